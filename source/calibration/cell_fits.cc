#include <springfit/calibration/cell_fits.h>
#include <springfit/calibration/packed_fit.h>
#include <springfit/calibration/shape_quality.h>
#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/progress.h>
#include <springfit/reference/cell_energy.h>
#include <springfit/reference/cell_frame.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <map>
#include <sstream>

namespace springfit
{
  namespace
  {
    /** A distinct cell as an error names it. */
    template <int dim, int spacedim>
    std::string
    description(const CellIterator<dim, spacedim> &cell, const CellKind kind)
    {
      std::ostringstream text;
      text.precision(3);
      text << singular(kind) << ' ' << cell->active_cell_index() << " (centre "
           << cell->center() << " m, shape quality "
           << shape_quality(flat_points<dim, spacedim>(cell), kind) << " of 1)";
      return text.str();
    }

    /** A cell and its reference's tangents in homogeneous deformations. */
    template <int dim, int spacedim>
    std::vector<DeformedState>
    deformed_states(const CellIterator<dim, spacedim> &cell,
                    const CellMaterial &material,
                    const std::vector<Eigen::MatrixXd> &deformation_gradients,
                    const MaterialLaw law,
                    CellEnergy<dim, spacedim> &energy)
    {
      std::vector<DeformedState> states;
      for (const auto &F : deformation_gradients)
        {
          const Eigen::MatrixXd displacement =
            (F - Eigen::MatrixXd::Identity(spacedim, spacedim)) *
            cell_points<dim, spacedim>(cell);
          const auto term = energy.evaluate(law, cell, material, displacement);
          if (!term)
            throw RunError("its finite element has no energy in one of the "
                           "'States'.",
                           "Name smaller deformations.");
          states.push_back({displacement, term->hessian});
        }
      return states;
    }
  } // namespace

  template <int dim, int spacedim>
  std::vector<CellIterator<dim, spacedim>>
  cells_by_index(const Mesh<dim, spacedim> &mesh)
  {
    std::vector<CellIterator<dim, spacedim>> cells;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      cells.push_back(cell);
    return cells;
  }


  template <int dim>
  IsotropicMaterial
  material_of(const CellMaterial &material)
  {
    IsotropicMaterial isotropic = isotropic_material(dim,
                                                     material.lame.lambda,
                                                     material.lame.mu,
                                                     material.thickness);
    isotropic.is_in_plane_stress =
      dim == 2 && material.plane_state == PlaneState::stress;
    return isotropic;
  }


  template <int dim, int spacedim>
  FitProblem
  cell_problem(
    const typename dealii::Triangulation<dim, spacedim>::active_cell_iterator
      &cell,
    const CellKind kind,
    CellMatrices<dim, spacedim> &cell_matrices,
    const CellMaterial &material)
  {
    return make_fit_problem(flat_points<dim, spacedim>(cell),
                            kind,
                            cell_matrices.stiffness(cell, material),
                            material_of<dim>(material));
  }

  std::vector<CellModel>
  models_of(const std::vector<TimedFit> &fits)
  {
    std::vector<CellModel> models;
    for (const auto &fit : fits)
      models.push_back(fit.result);
    return models;
  }

  template <int dim, int spacedim>
  std::vector<TimedFit>
  fit_distinct_cells(const DistinctCells &cells,
                     const Mesh<dim, spacedim> &mesh,
                     const Element<dim, spacedim> &element,
                     const MaterialTable &materials,
                     const Method &method,
                     const FitOptions &options,
                     const ReferenceStates &states,
                     const std::string &name,
                     Session &session)
  {
    const auto iterators    = cells_by_index(mesh);
    const CellKind kind     = mesh.cell_kind;
    const auto communicator = session.communicator();
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks =
      dealii::Utilities::MPI::n_mpi_processes(communicator);

    std::map<unsigned int, std::vector<double>> mine;
    run_collectively(communicator, [&]() {
      CellMatrices<dim, spacedim> cell_matrices(element);
      CellEnergy<dim, spacedim> cell_energy(element);
      Progress progress("Fits (" + name + ") of distinct cells",
                        (cells.distinct.size() + n_ranks - 1) / n_ranks,
                        rank == 0);
      for (unsigned int c = rank; c < cells.distinct.size(); c += n_ranks)
        {
          const auto &distinct = cells.distinct[c];
          const auto &cell     = iterators[distinct.representative];
          const auto &material = materials.at(distinct.material);
          const auto start     = std::chrono::steady_clock::now();
          auto problem =
            cell_problem<dim, spacedim>(cell, kind, cell_matrices, material);
          problem.law = states.spring_law;
          FitResult result;
          try
            {
              problem.states =
                deformed_states<dim, spacedim>(cell,
                                               material,
                                               states.deformation_gradients,
                                               states.material_law,
                                               cell_energy);
              result = fit(problem, method, options);
              check_certificate(result, options);
            }
          catch (const RunError &error)
            {
              throw RunError("The fit '" + name + "' of " +
                               description<dim, spacedim>(cell, kind) +
                               " failed:",
                             error.what());
            }
          const std::chrono::duration<double> seconds =
            std::chrono::steady_clock::now() - start;
          mine[c] = pack(result);
          mine[c].push_back(seconds.count());
          progress.step();
        }
    });

    std::vector<TimedFit> fits(cells.distinct.size());
    for (const auto &of_rank :
         dealii::Utilities::MPI::all_gather(communicator, mine))
      for (const auto &[c, numbers] : of_rank)
        fits[c] = {unpack(numbers), numbers.back()};
    return fits;
  }

  template FitProblem
  cell_problem<2>(const dealii::Triangulation<2>::active_cell_iterator &,
                  CellKind,
                  CellMatrices<2> &,
                  const CellMaterial &);
  template FitProblem
  cell_problem<2, 3>(const dealii::Triangulation<2, 3>::active_cell_iterator &,
                     CellKind,
                     CellMatrices<2, 3> &,
                     const CellMaterial &);
  template FitProblem
  cell_problem<3>(const dealii::Triangulation<3>::active_cell_iterator &,
                  CellKind,
                  CellMatrices<3> &,
                  const CellMaterial &);
  template IsotropicMaterial
  material_of<2>(const CellMaterial &);
  template IsotropicMaterial
  material_of<3>(const CellMaterial &);
  template std::vector<CellIterator<2>>
  cells_by_index<2>(const Mesh<2> &);
  template std::vector<CellIterator<2, 3>>
  cells_by_index<2, 3>(const Mesh<2, 3> &);
  template std::vector<CellIterator<3>>
  cells_by_index<3>(const Mesh<3> &);
  template std::vector<TimedFit>
  fit_distinct_cells<2>(const DistinctCells &,
                        const Mesh<2> &,
                        const Element<2> &,
                        const MaterialTable &,
                        const Method &,
                        const FitOptions &,
                        const ReferenceStates &,
                        const std::string &,
                        Session &);
  template std::vector<TimedFit>
  fit_distinct_cells<2, 3>(const DistinctCells &,
                           const Mesh<2, 3> &,
                           const Element<2, 3> &,
                           const MaterialTable &,
                           const Method &,
                           const FitOptions &,
                           const ReferenceStates &,
                           const std::string &,
                           Session &);
  template std::vector<TimedFit>
  fit_distinct_cells<3>(const DistinctCells &,
                        const Mesh<3> &,
                        const Element<3> &,
                        const MaterialTable &,
                        const Method &,
                        const FitOptions &,
                        const ReferenceStates &,
                        const std::string &,
                        Session &);
} // namespace springfit
