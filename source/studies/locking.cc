#include <springfit/calibration/cell_fits.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/comparison/bending_ratio.h>
#include <springfit/core/formatted.h>
#include <springfit/studies/locking.h>

#include <algorithm>
#include <string>

namespace springfit
{
  namespace
  {
    // A cube has 1.7 at nu = 0.3, 4.1 at 0.45, 17 at 0.49; a brick of 1 : 4
    // has 7.5 at 0.3.
    constexpr double much = 5.;

    // From there on simplices are much too stiff in any shape.
    constexpr double nearly_incompressible = 0.48;

    /** E of a bent beam, times the thickness. */
    template <int dim>
    double
    modulus_of_beam(const CellMaterial &material)
    {
      const double nu = material.constants.poissons_ratio;
      const bool is_in_plane_strain =
        dim == 2 && material.plane_state == PlaneState::strain;
      return material.thickness * material.constants.youngs_modulus /
             (is_in_plane_strain ? 1. - nu * nu : 1.);
    }
  } // namespace

  template <int dim, int spacedim>
  void
  warn_of_locking(const Scene<spacedim> &scene,
                  const CalibratedScene<dim, spacedim> &calibrated,
                  Session &session)
  {
    const auto &mesh = *calibrated.mesh;
    const std::string advice =
      std::string(" The distances below are ") +
      (scene.reference.degree() == 2
         ? "from quadratic ones, as 'Reference' in section Response asks for."
         : "from them. Set 'Reference = quadratic elements' in section Response to measure "
           "them from better ones.");
    if (is_simplex(mesh.cell_kind))
      {
        double largest = 0.;
        for (const auto &[id, material] : calibrated.materials)
          if (dim == 3 || material.plane_state == PlaneState::strain)
            largest = std::max(largest, material.constants.poissons_ratio);
        if (largest > nearly_incompressible)
          session.warn(
            formatted("The linear finite elements lock: %s hardly deform where "
                      "their volume cannot change, at nu = %.6g.",
                      word_of(cell_kind_words(), mesh.cell_kind).c_str(),
                      largest) +
            advice);
        return;
      }

    const auto cells     = find_distinct_cells(mesh);
    const auto iterators = cells_by_index(mesh);
    CellMatrices<dim, spacedim> matrices(calibrated.element);
    double largest = 0.;
    for (const auto &distinct : cells.distinct)
      {
        const auto &material = calibrated.materials.at(distinct.material);
        const auto problem =
          cell_problem<dim, spacedim>(iterators[distinct.representative],
                                      mesh.cell_kind,
                                      matrices,
                                      material);
        largest = std::max(largest,
                           bending_ratio(problem.points,
                                         mesh.cell_kind,
                                         problem.stiffness,
                                         modulus_of_beam<dim>(material)));
      }
    if (largest > much)
      session.warn(
        formatted("The linear finite elements lock: in bending a cell is %.3g "
                  "times as stiff as a beam, for its shape or for nu.",
                  largest) +
        advice);
  }

  template void
  warn_of_locking(const Scene<2> &, const CalibratedScene<2> &, Session &);
  template void
  warn_of_locking(const Scene<3> &, const CalibratedScene<2, 3> &, Session &);
  template void
  warn_of_locking(const Scene<3> &, const CalibratedScene<3> &, Session &);
} // namespace springfit
