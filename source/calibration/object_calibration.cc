#include <springfit/calibration/cell_fits.h>
#include <springfit/calibration/cell_network.h>
#include <springfit/calibration/object_calibration.h>
#include <springfit/core/collective.h>
#include <springfit/fit/cell/cell_terms.h>
#include <springfit/fit/object/free_body.h>
#include <springfit/fit/object/object_stability.h>

#include <chrono>
#include <cmath>
#include <optional>

namespace springfit
{
  namespace
  {
    /** The constants that the same fit of the cells gives. */
    template <int dim>
    Eigen::VectorXd
    constants_of_cell_fits(const DistinctCells &cells,
                           const Mesh<dim> &mesh,
                           const Element<dim> &element,
                           const MaterialTable &materials,
                           const Method &method,
                           const FitOptions &options,
                           const SpringLaw law,
                           const std::string &name,
                           Session &session)
    {
      const auto fits = fit_distinct_cells<dim>(cells,
                                                mesh,
                                                element,
                                                materials,
                                                method,
                                                options,
                                                {{}, MaterialLaw::linear, law},
                                                name,
                                                session);
      return constants_of(
        assemble_network(mesh, cells, models_of(fits), element, materials)
          .families);
    }
  } // namespace

  template <int dim>
  FittedNetwork
  calibrate_object(const DistinctCells &cells,
                   const Mesh<dim> &mesh,
                   const Element<dim> &element,
                   const MaterialTable &materials,
                   const Method &method,
                   const FitOptions &options,
                   const SpringLaw law,
                   const std::vector<Field> &fields,
                   const Eigen::MatrixXd &responses,
                   const std::string &name,
                   Session &session)
  {
    // What the mesh has, with constants of one.
    const auto iterators = cells_by_index(mesh);
    std::vector<CellModel> units;
    CellMatrices<dim> cell_matrices(element);
    for (const auto &distinct : cells.distinct)
      {
        auto problem = cell_problem<dim>(iterators[distinct.representative],
                                         mesh.cell_kind,
                                         cell_matrices,
                                         materials.at(distinct.material));
        problem.law  = law;
        units.push_back({unit_families(problem, options.enrichment)});
      }
    const auto unit_network =
      assemble_network(mesh, cells, units, element, materials);

    // With all couplings cells are exact, and so is the object.
    const bool is_exact = options.enrichment == Enrichment::coupling;
    const bool need_cell_fits =
      is_exact || has(method, Feature::fields) || options.nonnegative;
    Eigen::VectorXd of_cells;
    if (need_cell_fits)
      of_cells = constants_of_cell_fits(
        cells, mesh, element, materials, method, options, law, name, session);

    std::optional<double> share; // of the way to the fit, where it is unstable
    // The same on every rank: a factorisation is not worth distributing.
    const auto start = std::chrono::steady_clock::now();
    ObjectFit found;
    run_collectively(session.communicator(), [&]() {
      const auto problem =
        make_object_problem(unit_network,
                            object_stiffness(mesh, element, materials),
                            options.nonnegative);
      if (is_exact)
        {
          found = judge_object(problem, of_cells);
          return;
        }
      const auto all_fields = displacement_fields(fields, problem, responses);
      found                 = fit_object(problem, method, all_fields, of_cells);
      if (!options.nonnegative)
        return;

      // Between the fits of the cells and that of the object what it minimises
      // is convex: nowhere is it more than at the former, which are definite
      // and no mechanisms.
      const auto move_to = [&](const double part_of_way) {
        found = judge_object(problem,
                             (1. - part_of_way) * of_cells +
                               part_of_way * found.constants);
      };
      if (found.n_unstable > 0)
        {
          // Volumes or angles so negative that the object gives way. Well
          // inside, as in a fit of cells.
          share =
            0.9 * share_to_instability(problem, of_cells, found.constants);
          move_to(*share);
        }
      else if (FreeBody(fitted_stiffness(problem, found.constants),
                        problem.nodes)
                 .n_mechanisms() > 0)
        move_to(0.97); // springs that are zero no longer are
    });
    const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start;

    FittedNetwork fitted{unit_network, {}};
    fitted.network.families =
      with_constants(unit_network.families, found.constants);
    FitResult result{};
    result.frobenius_residual = found.frobenius_residual;
    result.spectral_residual  = found.spectral_residual;
    result.n_negative         = n_negative(fitted.network.families);
    fitted.cells              = {{0, 1, result, seconds.count()}};
    if (share)
      session.warn(
        "The springs of the fit '" + name +
        "' with springs >= 0 would be unstable. They were moved back, to " +
        std::to_string(static_cast<int>(std::lround(100. * *share))) +
        " % of the way there from those of the same fit of the cells.");
    if (found.n_unstable > 0)
      session.warn("The springs of the fit '" + name +
                   "' are unstable where nothing holds them: " +
                   std::to_string(found.n_unstable) +
                   " of their deformations release energy." +
                   (options.nonnegative
                      ? ""
                      : " Set 'Nonnegative = true' in section Fit."));
    return fitted;
  }

  template FittedNetwork
  calibrate_object<2>(const DistinctCells &,
                      const Mesh<2> &,
                      const Element<2> &,
                      const MaterialTable &,
                      const Method &,
                      const FitOptions &,
                      SpringLaw,
                      const std::vector<Field> &,
                      const Eigen::MatrixXd &,
                      const std::string &,
                      Session &);
  template FittedNetwork
  calibrate_object<3>(const DistinctCells &,
                      const Mesh<3> &,
                      const Element<3> &,
                      const MaterialTable &,
                      const Method &,
                      const FitOptions &,
                      SpringLaw,
                      const std::vector<Field> &,
                      const Eigen::MatrixXd &,
                      const std::string &,
                      Session &);
} // namespace springfit
