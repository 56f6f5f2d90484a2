#include <springfit/calibration/calibration.h>
#include <springfit/calibration/cell_fits.h>
#include <springfit/calibration/cell_network.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/calibration/mechanisms.h>
#include <springfit/calibration/object_calibration.h>
#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/reference/cell_frame.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace springfit
{
  template <int dim, int spacedim>
  DistinctCells
  cells_of_fits(const FitSection<spacedim> &section,
                const Mesh<dim, spacedim> &mesh)
  {
    if (section.scope() == Scope::object)
      return every_cell(mesh);
    // States are given in the scene's directions.
    return section.has_states() ? find_distinct_oriented_cells(mesh)
                                : find_distinct_cells(mesh);
  }

  namespace
  {
    /** How many cells do not meet each assumption of a published method. */
    template <int dim, int spacedim>
    std::map<std::string, unsigned int>
    count_unmet_assumptions(const DistinctCells &cells,
                            const Mesh<dim, spacedim> &mesh,
                            const MaterialTable &materials,
                            const Method &method)
    {
      const auto iterators = cells_by_index(mesh);
      std::map<std::string, unsigned int> counts;
      for (const auto &distinct : cells.distinct)
        for (const auto &assumption : unmet_assumptions(
               method,
               flat_points<dim, spacedim>(iterators[distinct.representative]),
               mesh.cell_kind,
               material_of<dim>(materials.at(distinct.material))))
          counts[assumption] += distinct.multiplicity;
      return counts;
    }

    template <int dim, int spacedim>
    void
    warn_of_assumptions(const FitSection<spacedim> &section,
                        const DistinctCells &cells,
                        const Mesh<dim, spacedim> &mesh,
                        const MaterialTable &materials,
                        Session &session)
    {
      std::set<const Method *> methods;
      for (const auto &row : section.rows(mesh.cell_kind))
        if (methods.insert(row.method).second)
          for (const auto &[assumption, n_cells] :
               count_unmet_assumptions(cells, mesh, materials, *row.method))
            session.warn("The constants of '" + row.method->word +
                         "' are published for " + assumption + ", which " +
                         std::to_string(n_cells) + " of " +
                         std::to_string(cells.copies.size()) +
                         " cells do not meet. They are used all the same.");
    }

    /** @throws EntryError where a surface in space shall have what it cannot.
     */
    template <int spacedim>
    void
    check_for_surface(const FitSection<spacedim> &section)
    {
      if (section.scope() == Scope::object)
        throw EntryError("Fit/Scope",
                         "of a surface in space, which bends without "
                         "resistance, only cells are fitted.",
                         "Set it to cell.");
      if (section.has_states())
        throw EntryError("Fit/States",
                         "a surface in space is fitted at rest, where its "
                         "cells have directions of their own.",
                         "Leave it empty.");
    }

    /** Say where the engine asked for had to make way for the other one. */
    void
    warn_of_other_engine(const std::vector<CellFit> &fits,
                         const std::string &name,
                         Session &session)
    {
      const auto n =
        std::count_if(fits.begin(), fits.end(), [](const CellFit &fit) {
          return fit.result.by_other_engine;
        });
      if (n > 0)
        session.warn("The fit '" + name + "' of " + std::to_string(n) + " of " +
                     std::to_string(fits.size()) +
                     " distinct cells was not certified by the engine asked "
                     "for; the other 'Engine' solved it.");
    }

    /** Of springs alone the loaded object is checked as a whole. */
    void
    warn_of_indefinite_cells(const std::vector<CellFit> &fits,
                             const std::string &name,
                             Session &session)
    {
      constexpr double rounding = 1e-10;
      const auto is_indefinite  = [](const CellFit &fit) {
        return fit.result.smallest_eigenvalue.value_or(0.) < -rounding;
      };
      const auto n = std::count_if(fits.begin(), fits.end(), is_indefinite);
      if (n > 0)
        session.warn("The forces of '" + name +
                     "' release energy in some "
                     "deformation of " +
                     std::to_string(n) + " of " + std::to_string(fits.size()) +
                     " distinct cells: smallest_eigenvalue in fit.csv is "
                     "negative there. 'Nonnegative = true' in section Fit "
                     "keeps approximations of the stiffness from that.");
    }

    /** Without a word. */
    template <int dim, int spacedim>
    FittedNetwork
    fit_cells(const DistinctCells &cells,
              const Mesh<dim, spacedim> &mesh,
              const Element<dim, spacedim> &element,
              const MaterialTable &materials,
              const Method &method,
              const FitOptions &options,
              const ReferenceStates &states,
              const std::string &name,
              Session &session)
    {
      const auto fits = fit_distinct_cells(cells,
                                           mesh,
                                           element,
                                           materials,
                                           method,
                                           options,
                                           states,
                                           name,
                                           session);
      FittedNetwork fitted{
        assemble_network(mesh, cells, models_of(fits), element, materials), {}};
      for (unsigned int c = 0; c < fits.size(); ++c)
        fitted.cells.push_back({cells.distinct[c].representative,
                                cells.distinct[c].multiplicity,
                                fits[c].result,
                                fits[c].seconds});
      return fitted;
    }

    void
    warn_of_cells(const FittedNetwork &fitted,
                  const Method &method,
                  const FitOptions &options,
                  const std::string &name,
                  Session &session)
    {
      warn_of_other_engine(fitted.cells, name, session);
      if (options.enrichment != Enrichment::none)
        warn_of_indefinite_cells(fitted.cells, name, session);
      const unsigned int n = n_negative(fitted.network.families);
      if (options.nonnegative && has(method, Feature::formulas) &&
          !has(method, Feature::finite_element) && n > 0)
        session.warn("Of the springs of '" + name + "' " + std::to_string(n) +
                     " are negative: 'Nonnegative' does not change the "
                     "constants of a published fit.");
    }

    /** @return whether there was anything to explain. */
    bool
    explain_negative_springs(const SpringNetwork &network, Session &session)
    {
      const unsigned int n = n_negative(network.families);
      if (n == 0)
        return false;
      session.print(
        "Of the springs under tension " + std::to_string(n) +
        " have a stiffness < 0: they lie opposite to obtuse angles, and push "
        "where the others pull. The cells are as stable as their finite "
        "elements all the same; 'Nonnegative' does not apply to them.");
      return true;
    }
  } // namespace

  template <int dim, int spacedim>
  CalibratedNetwork
  calibrate_row(const FitSection<spacedim> &section,
                const typename FitSection<spacedim>::Row &row,
                const Mesh<dim, spacedim> &mesh,
                const Element<dim, spacedim> &element,
                const MaterialTable &materials,
                const MaterialLaw law,
                Session &session)
  {
    Assert(section.scope() == Scope::cell, dealii::ExcInternalError());
    const std::string fit        = name_of(*row.method);
    const std::string enrichment = name_of(row.enrichment);
    const std::string name       = name_of(fit, enrichment);
    const dealii::Timer timer(session.communicator());
    return {fit_cells(cells_of_fits(section, mesh),
                      mesh,
                      element,
                      materials,
                      *row.method,
                      section.options(row),
                      {section.states(), law, section.spring_law()},
                      name,
                      session),
            name,
            fit,
            enrichment,
            section.scope(),
            has(*row.method, Feature::finite_element),
            false,
            timer.wall_time()};
  }

  template <int dim, int spacedim>
  std::vector<CalibratedNetwork>
  calibrate(const FitSection<spacedim> &section,
            const Mesh<dim, spacedim> &mesh,
            const Element<dim, spacedim> &element,
            const MaterialTable &materials,
            const Eigen::MatrixXd &responses,
            const MaterialLaw law,
            Session &session)
  {
    section.check_cells(mesh.cell_kind);
    section.check_states(law);
    if (dim < spacedim)
      check_for_surface(section);
    for (const auto &sentence : section.unused_entries(mesh.cell_kind))
      session.warn(sentence);
    const auto cells = cells_of_fits(section, mesh);
    warn_of_assumptions(section, cells, mesh, materials, session);
    if (cells.distinct.size() < cells.copies.size())
      session.skip("Fits of " +
                     std::to_string(cells.copies.size() -
                                    cells.distinct.size()) +
                     " of " + std::to_string(cells.copies.size()) + " cells",
                   "they are copies of others");

    std::vector<CalibratedNetwork> networks;
    bool is_explained = false;
    for (const auto &row : section.rows(mesh.cell_kind))
      {
        const std::string fit        = name_of(*row.method);
        const std::string enrichment = name_of(row.enrichment);
        const std::string name       = name_of(fit, enrichment);

        dealii::TimerOutput::Scope scope(session.timer(),
                                         "Calibration, " + name);
        dealii::Timer timer(session.communicator());
        const auto fit_network = [&]() {
          if constexpr (dim == spacedim)
            if (section.scope() == Scope::object)
              return calibrate_object(cells,
                                      mesh,
                                      element,
                                      materials,
                                      *row.method,
                                      section.options(row),
                                      section.spring_law(),
                                      section.fields(),
                                      responses,
                                      name,
                                      session);
          auto fitted = fit_cells(cells,
                                  mesh,
                                  element,
                                  materials,
                                  *row.method,
                                  section.options(row),
                                  {section.states(), law, section.spring_law()},
                                  name,
                                  session);
          warn_of_cells(
            fitted, *row.method, section.options(row), name, session);
          return fitted;
        };
        FittedNetwork fitted = fit_network();
        // What surfaces do not resist is none of their springs' fault.
        if (dim == spacedim)
          warn_of_mechanisms(fitted, name, session);
        if (has(*row.method, Feature::finite_element) && !is_explained)
          is_explained = explain_negative_springs(fitted.network, session);
        networks.push_back({std::move(fitted),
                            name,
                            fit,
                            enrichment,
                            section.scope(),
                            has(*row.method, Feature::finite_element),
                            section.needs_responses(row),
                            timer.wall_time()});
      }
    return networks;
  }

  template DistinctCells
  cells_of_fits(const FitSection<2> &, const Mesh<2> &);
  template DistinctCells
  cells_of_fits(const FitSection<3> &, const Mesh<2, 3> &);
  template DistinctCells
  cells_of_fits(const FitSection<3> &, const Mesh<3> &);
  template std::vector<CalibratedNetwork>
  calibrate<2>(const FitSection<2> &,
               const Mesh<2> &,
               const Element<2> &,
               const MaterialTable &,
               const Eigen::MatrixXd &,
               MaterialLaw,
               Session &);
  template std::vector<CalibratedNetwork>
  calibrate<2, 3>(const FitSection<3> &,
                  const Mesh<2, 3> &,
                  const Element<2, 3> &,
                  const MaterialTable &,
                  const Eigen::MatrixXd &,
                  MaterialLaw,
                  Session &);
  template std::vector<CalibratedNetwork>
  calibrate<3>(const FitSection<3> &,
               const Mesh<3> &,
               const Element<3> &,
               const MaterialTable &,
               const Eigen::MatrixXd &,
               MaterialLaw,
               Session &);
  template CalibratedNetwork
  calibrate_row<2>(const FitSection<2> &,
                   const FitSection<2>::Row &,
                   const Mesh<2> &,
                   const Element<2> &,
                   const MaterialTable &,
                   MaterialLaw,
                   Session &);
  template CalibratedNetwork
  calibrate_row<2, 3>(const FitSection<3> &,
                      const FitSection<3>::Row &,
                      const Mesh<2, 3> &,
                      const Element<2, 3> &,
                      const MaterialTable &,
                      MaterialLaw,
                      Session &);
  template CalibratedNetwork
  calibrate_row<3>(const FitSection<3> &,
                   const FitSection<3>::Row &,
                   const Mesh<3> &,
                   const Element<3> &,
                   const MaterialTable &,
                   MaterialLaw,
                   Session &);
} // namespace springfit
