#ifndef springfit_studies_fine_reference_h
#define springfit_studies_fine_reference_h

#include <springfit/core/session.h>
#include <springfit/response/load_case.h>
#include <springfit/response/model.h>
#include <springfit/studies/scene.h>

#include <deal.II/base/point.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** What is compared of an equilibrium on any mesh. */
  struct CommonState
  {
    Eigen::MatrixXd displacement; // at the reference's points, m
    double energy;                // elastic, J
    std::vector<ForceOfSupport> reactions;
    std::optional<double> quantity; // m or N
  };

  /**
   * The response of fine finite elements to all load cases of a scene, at the
   * vertices of their mesh.
   */
  template <int spacedim>
  struct FineReference
  {
    std::vector<dealii::Point<spacedim>> points;
    Eigen::VectorXd weights; // the parts of the volume that are theirs, sum 1
    std::vector<std::string> load_cases;
    std::vector<double> scales; // of their loads
    std::vector<CommonState> states;
    double largest_quantity; // m or N, of its magnitude in all cases
    unsigned int n_nodes;    // of the elements, midpoints included
    std::string cells;
    double cell_size; // m

    /** From those of twice the cell size, in per cent of the displacement. */
    std::optional<double> own_error;
  };

  /**
   * How far a model is from the reference: weighted root mean square and
   * maximum of the distances over the points, in per cent of the largest
   * displacement of the reference; the largest difference of the force of a
   * support, in per cent of the largest such force, empty without one; of the
   * energy, in per cent of it; of the quantity, in per cent of the largest in
   * any load case, @p largest_quantity (m or N): symmetry may forbid it in
   * some.
   */
  struct CommonErrors
  {
    double e_rms, e_max;
    std::optional<double> force, energy, quantity;
  };

  CommonErrors
  common_errors(const CommonState &reference,
                const CommonState &model,
                const Eigen::VectorXd &weights,
                double largest_quantity);

  /**
   * @throws EntryError when the reference is coarser than a model, or no load
   * moves the named quantity; RunError when a load case has no equilibrium.
   */
  template <int dim, int spacedim>
  FineReference<spacedim>
  find_fine_reference(const Scene<spacedim> &scene, Session &session);

  /**
   * What a mesh was made with, m; of a file the mean length of its edges.
   */
  template <int dim, int spacedim>
  double
  size_of_cells(const Mesh<dim, spacedim> &mesh, const Meshing &meshing);

  /** A load as @p scale makes it. */
  NodalLoad
  scaled(const NodalLoad &load, double scale);
} // namespace springfit

#endif
