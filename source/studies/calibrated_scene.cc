#include <springfit/calibration/calibration.h>
#include <springfit/comparison/homogenised_tensor.h>
#include <springfit/core/collective.h>
#include <springfit/core/formatted.h>
#include <springfit/mesh/boundaries.h>
#include <springfit/mesh/materials.h>
#include <springfit/mesh/node_sets.h>
#include <springfit/output/mesh_vtu.h>
#include <springfit/output/response_table.h>
#include <springfit/output/tables.h>
#include <springfit/reference/cell_matrices.h>
#include <springfit/springs/spring_law.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/stable_steps.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  namespace
  {
    /** "0.02 x 0.02 x 0.02": wrong units of a file show there. */
    template <int dim, int spacedim>
    std::string
    extents(const Mesh<dim, spacedim> &mesh)
    {
      const dealii::BoundingBox<spacedim> box(
        mesh.triangulation.get_vertices());
      std::string text;
      for (int d = 0; d < spacedim; ++d)
        text += (d > 0 ? " x " : "") + formatted("%.4g", box.side_length(d));
      return text;
    }

    std::vector<FitRow>
    fit_rows(const CalibratedNetwork &network, const CellKind kind)
    {
      std::vector<FitRow> rows;
      for (const auto &cell : network.cells)
        rows.push_back({network.name,
                        network.scope == Scope::object
                          ? "object"
                          : singular(kind) + ' ' + std::to_string(cell.cell),
                        cell.multiplicity,
                        cell.result.frobenius_residual,
                        cell.result.spectral_residual,
                        cell.result.duality_gap,
                        cell.result.n_negative,
                        cell.seconds,
                        cell.result.smallest_eigenvalue,
                        cell.result.states_residual});
      return rows;
    }

    /** One line: what a fit reached over all distinct cells. */
    std::string
    fit_summary(const CalibratedNetwork &network)
    {
      double spectral = 0., frobenius = 0., gap = 0.;
      std::optional<double> smallest;
      bool certified = false;
      for (const auto &cell : network.cells)
        {
          frobenius = std::max(frobenius, cell.result.frobenius_residual);
          spectral  = std::max(spectral, cell.result.spectral_residual);
          if (const auto &eigenvalue = cell.result.smallest_eigenvalue)
            smallest = std::min(smallest.value_or(*eigenvalue), *eigenvalue);
          if (cell.result.duality_gap)
            {
              certified = true;
              gap       = std::max(gap, *cell.result.duality_gap);
            }
        }
      return formatted("%-32s %8zu %10zu %9u %11.2f %11.2f %10s %12s %9.3f",
                       network.name.c_str(),
                       network.cells.size(),
                       n_springs(network.network.families),
                       n_negative(network.network.families),
                       100. * frobenius,
                       100. * spectral,
                       smallest ? formatted("%.2f", 100. * *smallest).c_str()
                                : "-",
                       certified ? formatted("%.1e", gap).c_str() : "-",
                       network.seconds);
    }

    template <int dim>
    YoungPoisson
    constants_of(const IsotropicPart &part, const PlaneState state)
    {
      return dim == 2 && state == PlaneState::stress
               ? young_poisson_plane_stress(part.lambda, part.mu)
               : young_poisson(part.lambda, part.mu);
    }

    std::set<double>
    poissons_ratios(const MaterialTable &materials)
    {
      std::set<double> ratios;
      for (const auto &[id, material] : materials)
        ratios.insert(material.constants.poissons_ratio);
      return ratios;
    }

    void
    warn_of_poissons_ratio(const double wanted,
                           const double delivered,
                           Session &session)
    {
      session.warn(formatted(
        "Springs alone cannot honour Poisson's ratio %.4g: a network of "
        "springs delivers %.4g in this setting, whatever their stiffness. "
        "'Enrichment' can, in section Fit: volume or coupling.",
        wanted,
        delivered));
    }

    /** Say what a network is as a material, and what it cannot be. */
    template <int dim>
    void
    report_homogenised(const Scene<dim> &scene,
                       const CalibratedScene<dim> &calibrated,
                       Session &session)
    {
      session.print("\nThe networks as materials (affine deformation; E Pa, "
                    "anisotropy relative to C):");
      std::vector<YoungPoisson> delivered;
      std::vector<double> anisotropies;
      for (const auto &network : calibrated.networks)
        {
          const auto part = isotropic_part(
            homogenised_tensor(network.network, calibrated.volume));
          delivered.push_back(
            constants_of<dim>(part, scene.material.plane_state()));
          anisotropies.push_back(part.anisotropy);
          session.print(formatted("  %-32s E %.6g, nu %.4f, anisotropy %.1f %%",
                                  network.name.c_str(),
                                  delivered.back().youngs_modulus,
                                  delivered.back().poissons_ratio,
                                  100. * part.anisotropy));
        }

      const auto wanted  = poissons_ratios(calibrated.materials);
      const auto differs = [](const double nu, const YoungPoisson &other) {
        return std::abs(nu - other.poissons_ratio) > 0.01;
      };

      // Cauchy's relations: lambda = mu, whatever the constants of the springs.
      for (std::size_t n = 0; n < delivered.size(); ++n)
        if (has_springs_alone(calibrated.networks[n].network.families))
          {
            for (const double nu : wanted)
              if (differs(nu, delivered[n]))
                warn_of_poissons_ratio(nu,
                                       delivered[n].poissons_ratio,
                                       session);
            break; // It is the same for all of them.
          }

      // What other networks deliver is a mean over the materials.
      if (wanted.size() == 1)
        for (std::size_t n = 0; n < delivered.size(); ++n)
          if (!has_springs_alone(calibrated.networks[n].network.families) &&
              differs(*wanted.begin(), delivered[n]))
            session.warn(formatted(
              "The network '%s' does not honour Poisson's ratio %.4g: that of "
              "its isotropic part is %.4g.",
              calibrated.networks[n].name.c_str(),
              *wanted.begin(),
              delivered[n].poissons_ratio));

      constexpr double much = 0.1;
      for (std::size_t n = 0; n < anisotropies.size(); ++n)
        if (!has_springs_alone(calibrated.networks[n].network.families) &&
            anisotropies[n] > much)
          session.warn(formatted(
            "The network '%s' is not isotropic: %.0f %% of its tensor depend "
            "on directions. Take the fit 'consistent' and cells about as long "
            "as wide, or set 'Enrichment = coupling' in section Fit.",
            calibrated.networks[n].name.c_str(),
            100. * anisotropies[n]));
    }

    /** Each cell of a surface is the same material in its own plane. */
    template <int dim, int spacedim>
    void
    report_surface(const CalibratedScene<dim, spacedim> &calibrated,
                   Session &session)
    {
      // Cauchy's relation lambda = mu in plane stress.
      constexpr double of_springs = 1. / 3.;
      for (const auto &network : calibrated.networks)
        if (has_springs_alone(network.network.families) &&
            !are_under_tension(network.network.families))
          {
            for (const double nu : poissons_ratios(calibrated.materials))
              if (std::abs(nu - of_springs) > 0.01)
                warn_of_poissons_ratio(nu, of_springs, session);
            return; // It is the same for all of them.
          }
    }

    template <int dim, int spacedim>
    std::vector<SetRow>
    set_rows(const Mesh<dim, spacedim> &mesh)
    {
      std::vector<SetRow> rows;
      for (const auto &row : boundary_table(mesh))
        rows.push_back({"boundary", row.id, row.name, row.n_faces});
      for (const auto &row : material_table(mesh))
        rows.push_back({"material", row.id, row.name, row.n_cells});
      return rows;
    }
  } // namespace

  std::vector<NamedNetwork>
  named(const std::vector<CalibratedNetwork> &networks)
  {
    std::vector<NamedNetwork> result;
    for (const auto &network : networks)
      result.push_back({network.name, &network.network});
    return result;
  }

  template <int dim, int spacedim>
  CalibratedScene<dim, spacedim>
  scene_of(std::unique_ptr<Mesh<dim, spacedim>> made,
           const Scene<spacedim> &scene)
  {
    CalibratedScene<dim, spacedim> calibrated;
    calibrated.mesh      = std::move(made);
    const auto &mesh     = *calibrated.mesh;
    calibrated.element   = make_element<dim, spacedim>(mesh.cell_kind);
    calibrated.materials = scene.material.resolve(mesh);

    CellMatrices<dim, spacedim> cell_matrices(calibrated.element);
    calibrated.volume = 0.;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      calibrated.volume +=
        cell_matrices.volume(cell) *
        calibrated.materials.at(cell->material_id()).thickness;
    return calibrated;
  }

  template <int dim, int spacedim>
  CalibratedScene<dim, spacedim>
  make_scene(const Scene<spacedim> &scene, Session &session)
  {
    dealii::TimerOutput::Scope scope(session.timer(), "Mesh");
    auto calibrated =
      scene_of<dim>(scene.geometry.template create<dim>(session.communicator(),
                                                        scene.folder),
                    scene);
    const auto &mesh = *calibrated.mesh;
    scene.fit.check_cells(mesh.cell_kind);
    session.print(formatted("Mesh: %u nodes, %u %s%s, %s m, %.6g m^3\n",
                            mesh.triangulation.n_vertices(),
                            mesh.triangulation.n_active_cells(),
                            word_of(cell_kind_words(), mesh.cell_kind).c_str(),
                            dim < spacedim ? " in space" : "",
                            extents(mesh).c_str(),
                            calibrated.volume));
    if (!mesh.left_out.empty())
      {
        session.print("Left out: " + mesh.left_out + '.');
        session.skip("Cells",
                     mesh.left_out + ", by 'Leave out' in section Geometry");
      }
    session.print(format_boundary_table<dim>(boundary_table(mesh)));
    const auto mesh_materials = material_table(mesh);
    if (mesh_materials.size() > 1 || !mesh.material_names.empty())
      session.print(format_material_table<dim>(mesh_materials));
    for (const auto &warning : mesh.warnings)
      session.warn(warning);
    return calibrated;
  }

  template <int dim, int spacedim>
  void
  calibrate_scene(const Scene<spacedim> &scene,
                  CalibratedScene<dim, spacedim> &calibrated,
                  const std::vector<bool> &held,
                  const Eigen::MatrixXd &responses,
                  Session &session)
  {
    calibrated.networks = calibrate(scene.fit,
                                    *calibrated.mesh,
                                    calibrated.element,
                                    calibrated.materials,
                                    responses,
                                    scene.statics.material_law(),
                                    session);
    session.print(
      "fit                              distinct    springs  negative  |E|_F max%  |E|_2 max%  eig min%  "
      "duality gap    time s");
    std::vector<FitRow> rows;
    for (const auto &network : calibrated.networks)
      {
        session.print(fit_summary(network));
        for (const auto &row : fit_rows(network, calibrated.mesh->cell_kind))
          rows.push_back(row);
      }
    session.print("Spring law: " +
                  word_of(spring_law_words(), scene.fit.spring_law()));
    if constexpr (dim == spacedim)
      report_homogenised(scene, calibrated, session);
    else
      report_surface(calibrated, session);

    tell_stable_steps(scene, calibrated, session);

    dealii::TimerOutput::Scope scope(session.timer(), "Output");
    run_on_root(session.communicator(), [&]() {
      const auto &folder = session.draft();
      write_fits(folder, rows);
      write_nodes(folder,
                  calibrated.networks.front().network,
                  held,
                  node_sets(*calibrated.mesh));
      write_sets(folder, set_rows(*calibrated.mesh));
      write_cells(folder, *calibrated.mesh);
      write_mesh_vtu(folder / "mesh.vtu", *calibrated.mesh, {});
      write_boundaries_vtu(folder / "boundaries.vtu", *calibrated.mesh);
      for (const auto &network : calibrated.networks)
        write_network(folder, network.name, network.network);
      write_families(folder, named(calibrated.networks));
    });
  }

  template CalibratedScene<2>
  scene_of<2>(std::unique_ptr<Mesh<2>>, const Scene<2> &);
  template CalibratedScene<2, 3>
  scene_of<2, 3>(std::unique_ptr<Mesh<2, 3>>, const Scene<3> &);
  template CalibratedScene<3>
  scene_of<3>(std::unique_ptr<Mesh<3>>, const Scene<3> &);
  template CalibratedScene<2>
  make_scene<2>(const Scene<2> &, Session &);
  template CalibratedScene<2, 3>
  make_scene<2, 3>(const Scene<3> &, Session &);
  template CalibratedScene<3>
  make_scene<3>(const Scene<3> &, Session &);
  template void
  calibrate_scene<2>(const Scene<2> &,
                     CalibratedScene<2> &,
                     const std::vector<bool> &,
                     const Eigen::MatrixXd &,
                     Session &);
  template void
  calibrate_scene<2, 3>(const Scene<3> &,
                        CalibratedScene<2, 3> &,
                        const std::vector<bool> &,
                        const Eigen::MatrixXd &,
                        Session &);
  template void
  calibrate_scene<3>(const Scene<3> &,
                     CalibratedScene<3> &,
                     const std::vector<bool> &,
                     const Eigen::MatrixXd &,
                     Session &);
} // namespace springfit
