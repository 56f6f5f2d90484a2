#include <springfit/comparison/errors.h>
#include <springfit/comparison/interpolation.h>
#include <springfit/core/error.h>
#include <springfit/reference/nodal_masses.h>
#include <springfit/reference/quadratic_nodes.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/fine_reference.h>
#include <springfit/studies/responses.h>

#include <algorithm>
#include <cmath>

namespace springfit
{
  namespace
  {
    /** The parts of the volume that are the vertices', sum 1. */
    template <int dim, int spacedim>
    Eigen::VectorXd
    shares_of_volume(const CalibratedScene<dim, spacedim> &calibrated)
    {
      MaterialTable uniform = calibrated.materials;
      for (auto &[id, material] : uniform)
        material.constants.density = 1.;
      const auto volumes =
        nodal_masses(*calibrated.mesh, calibrated.element, uniform);
      return volumes / volumes.sum();
    }

    /** A mesh with its elements of the wanted degree, held and loaded. */
    template <int dim, int spacedim>
    struct LoadedElements
    {
      LoadedElements(const Scene<spacedim> &scene,
                     const Meshing &meshing,
                     Session &session)
        : calibrated(scene_of<dim>(
            scene.geometry.template create<dim>(meshing,
                                                session.communicator(),
                                                scene.folder),
            scene))
        , weights(shares_of_volume(calibrated))
      {
        auto &mesh = *calibrated.mesh;
        if (scene.tradeoff.reference_degree() == 2)
          {
            mesh.nodes         = quadratic_nodes(mesh);
            calibrated.element = make_element<dim, spacedim>(mesh.cell_kind, 2);
          }
        loading =
          scene.loads.resolve(mesh, calibrated.element, calibrated.materials);
        scene.loads.check_supports(mesh, loading);
        discretization.emplace(mesh, loading.held, session.communicator());
      }

      CalibratedScene<dim, spacedim> calibrated;
      Eigen::VectorXd weights; // of the vertices
      Loading loading;
      std::optional<Discretization<spacedim>> discretization;
    };

    template <int dim, int spacedim>
    std::vector<double>
    find_scales(const Scene<spacedim> &scene,
                const LoadedElements<dim, spacedim> &elements)
    {
      const auto model =
        scene.statics.finite_elements_of(MaterialLaw::linear,
                                         *elements.discretization,
                                         *elements.calibrated.mesh,
                                         elements.calibrated.element,
                                         elements.calibrated.materials);
      std::vector<double> scales;
      for (const auto &load_case : elements.loading.cases)
        scales.push_back(scale_of(load_case,
                                  elements.loading,
                                  model->respond(load_case.load).displacement));
      return scales;
    }

    /** Of all load cases, at @p points. */
    template <int dim, int spacedim>
    std::vector<CommonState>
    respond(const Scene<spacedim> &scene,
            const LoadedElements<dim, spacedim> &elements,
            const std::vector<double> &scales,
            const std::vector<dealii::Point<spacedim>> &points)
    {
      const auto &[mesh, element, materials, volume, networks] =
        elements.calibrated;
      const MaterialLaw law = scene.statics.material_law();
      const auto model = scene.statics.finite_elements(*elements.discretization,
                                                       *mesh,
                                                       element,
                                                       materials);
      const FiniteElementBody<dim, spacedim> body(*mesh,
                                                  element,
                                                  materials,
                                                  law);
      const auto weights   = interpolation(*mesh, element, points).weights;
      const auto statement = scene.tradeoff.quantity();
      std::vector<CommonState> states;
      for (std::size_t i = 0; i < scales.size(); ++i)
        {
          const auto &load_case = elements.loading.cases[i];
          const auto found = model->respond(scaled(load_case.load, scales[i]));
          if (!is_complete(found))
            throw RunError("The reference has no equilibrium under the load "
                           "case " +
                             load_case.name + ". " + found.failure,
                           "Load less.");
          CommonState state;
          state.displacement = found.displacement * weights;
          state.energy       = body.energy(found.displacement);
          state.reactions =
            forces_of_supports(elements.loading, found.reactions);
          if (statement)
            state.quantity = value_of(on_mesh(*statement,
                                              *mesh,
                                              element,
                                              elements.loading,
                                              "Tradeoff/Quantity"),
                                      found);
          states.push_back(state);
        }
      return states;
    }

    /** @throws EntryError when it is 0 but for rounding. */
    double
    find_largest_quantity(const std::optional<QuantityStatement> &statement,
                          const std::vector<CommonState> &states)
    {
      double largest = 0., scale = 0.;
      for (const auto &state : states)
        if (state.quantity)
          {
            largest = std::max(largest, std::abs(*state.quantity));
            if (statement->kind == QuantityStatement::Kind::reaction)
              for (const auto &[support, force] : state.reactions)
                scale = std::max(scale, force.norm());
            else
              scale = std::max(scale, largest_displacement(state.displacement));
          }
      if (scale > 0. && !(largest > 1e-9 * scale))
        throw EntryError("Tradeoff/Quantity",
                         "no load moves it: it is 0 in all load cases.",
                         "Name another component, or a place that moves.");
      return largest;
    }

    double
    relative_percent(const double difference, const double whole)
    {
      return 100. * std::abs(difference) / std::abs(whole);
    }

    /** The mean length of the edges of a mesh, m. */
    template <int dim, int spacedim>
    double
    mean_edge(const Mesh<dim, spacedim> &mesh)
    {
      double sum          = 0.;
      std::size_t n_edges = 0;
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        for (const unsigned int l : cell->line_indices())
          {
            sum += cell->line(l)->diameter();
            ++n_edges;
          }
      return sum / n_edges;
    }
  } // namespace

  CommonErrors
  common_errors(const CommonState &reference,
                const CommonState &model,
                const Eigen::VectorXd &weights,
                const double largest_quantity)
  {
    const Eigen::VectorXd distances =
      nodal_errors(reference.displacement, model.displacement);
    const double largest = largest_displacement(reference.displacement);
    CommonErrors errors;
    errors.e_rms =
      100. * std::sqrt(weights.dot(distances.cwiseAbs2())) / largest;
    errors.e_max = 100. * distances.maxCoeff() / largest;

    double force = 0., difference = 0.;
    for (std::size_t i = 0; i < reference.reactions.size(); ++i)
      {
        const auto &of_reference = reference.reactions[i].force;
        force                    = std::max(force, of_reference.norm());
        difference               = std::max(difference,
                              (model.reactions[i].force - of_reference).norm());
      }
    // Loads that pull both ways leave rounding errors.
    const double energy_per_way = std::abs(reference.energy) / largest;
    if (force > 1e-6 * energy_per_way && force > 0.)
      errors.force = relative_percent(difference, force);
    if (reference.energy != 0.)
      errors.energy =
        relative_percent(model.energy - reference.energy, reference.energy);
    if (reference.quantity)
      errors.quantity = relative_percent(*model.quantity - *reference.quantity,
                                         largest_quantity);
    return errors;
  }

  NodalLoad
  scaled(const NodalLoad &load, const double scale)
  {
    return {scale * load.forces, load.support};
  }

  template <int dim, int spacedim>
  double
  size_of_cells(const Mesh<dim, spacedim> &mesh, const Meshing &meshing)
  {
    if (meshing.cell_size.empty())
      return mean_edge(mesh);
    return meshing.cell_size.front() / (1 << meshing.refinements);
  }

  template <int dim, int spacedim>
  FineReference<spacedim>
  find_fine_reference(const Scene<spacedim> &scene, Session &session)
  {
    dealii::TimerOutput::Scope scope(session.timer(), "Reference");
    const auto meshings = scene.tradeoff.reference(scene.geometry);
    const LoadedElements<dim, spacedim> fine(scene, meshings.fine, session);
    const auto &mesh = *fine.calibrated.mesh;

    FineReference<spacedim> reference;
    reference.points    = mesh.triangulation.get_vertices();
    reference.n_nodes   = mesh.nodes.size();
    reference.cells     = word_of(cell_kind_words(), mesh.cell_kind);
    reference.cell_size = meshings.fine.cell_size.empty()
                            ? mean_edge(mesh)
                            : meshings.fine.cell_size.front();
    reference.weights   = fine.weights;

    for (const auto &load_case : fine.loading.cases)
      reference.load_cases.push_back(load_case.name);
    reference.scales = find_scales(scene, fine);
    reference.states = respond(scene, fine, reference.scales, reference.points);
    reference.largest_quantity =
      find_largest_quantity(scene.tradeoff.quantity(), reference.states);

    const auto tell_unknown = [&](const std::string &reason) {
      session.warn("The reference's own error is not known, because one with "
                   "cells twice as large was not to be had: " +
                   reason);
    };
    try
      {
        const LoadedElements<dim, spacedim> coarse(scene,
                                                   meshings.coarse,
                                                   session);
        if (coarse.calibrated.mesh->nodes.size() == mesh.nodes.size())
          throw RunError("it is the same mesh.", "");
        const auto states =
          respond(scene, coarse, reference.scales, reference.points);
        double error = 0.;
        for (std::size_t i = 0; i < states.size(); ++i)
          error = std::max(error,
                           common_errors(reference.states[i],
                                         states[i],
                                         reference.weights,
                                         reference.largest_quantity)
                             .e_rms);
        reference.own_error = error;
      }
    catch (const InputError &error)
      {
        tell_unknown(error.what());
      }
    catch (const RunError &error)
      {
        tell_unknown(error.what());
      }
    return reference;
  }

  template FineReference<2>
  find_fine_reference<2>(const Scene<2> &, Session &);
  template FineReference<3>
  find_fine_reference<2, 3>(const Scene<3> &, Session &);
  template FineReference<3>
  find_fine_reference<3>(const Scene<3> &, Session &);
  template double
  size_of_cells(const Mesh<2> &, const Meshing &);
  template double
  size_of_cells(const Mesh<2, 3> &, const Meshing &);
  template double
  size_of_cells(const Mesh<3> &, const Meshing &);
} // namespace springfit
