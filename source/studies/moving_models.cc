#include <springfit/calibration/calibration.h>
#include <springfit/core/error.h>
#include <springfit/motion/step_systems.h>
#include <springfit/reference/consistent_mass.h>
#include <springfit/reference/nodal_masses.h>
#include <springfit/response/expression.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/response/linear_body.h>
#include <springfit/response/network_body.h>
#include <springfit/springs/tangent_matrix.h>
#include <springfit/studies/comparison_files.h>
#include <springfit/studies/moving_models.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace springfit
{
  namespace
  {
    /** The load at the time that was asked for last, kept. */
    std::function<NodalLoad(double)>
    remembering(std::function<NodalLoad(double)> load)
    {
      struct Memory
      {
        std::optional<double> time;
        NodalLoad load;
      };
      return [load   = std::move(load),
              memory = std::make_shared<Memory>()](const double time) {
        if (memory->time != time)
          {
            memory->load = load(time);
            memory->time = time;
          }
        return memory->load;
      };
    }

    template <int dim>
    std::function<NodalLoad(double)>
    canned_load(const LoadCase &load_case,
                const DynamicsSettings<dim> &settings)
    {
      return [factor = load_factor<dim>(settings),
              load   = load_case.load](const double time) {
        return NodalLoad{factor.value({}, time) * load.forces, load.support};
      };
    }

    /** The stiffness of a body at rest. */
    struct RestStiffness
    {
      double mean_diagonal; // N/m
      double norm;          // N/m, by Frobenius
    };

    RestStiffness
    stiffness_at_rest(const ElasticBody &body,
                      const int dim,
                      const Eigen::Index n_nodes)
    {
      NodePattern pattern(n_nodes);
      body.add_to_pattern(pattern);
      TangentMatrix tangent(dim, pattern);
      body.add_tangent(Eigen::MatrixXd::Zero(dim, n_nodes), tangent);
      return {tangent.matrix().diagonal().mean(), tangent.matrix().norm()};
    }

    /** A damper along each spring between two nodes. */
    Dampers
    dampers_of(const SpringNetwork &network, const double coefficient)
    {
      Dampers dampers{coefficient, {}, network.nodes};
      if (coefficient == 0.)
        return dampers;
      for (const auto &family : network.families)
        if (family.kind->n_nodes() == 2)
          for (std::size_t m = 0; m < family.size(); ++m)
            dampers.pairs.push_back({{family.nodes(m)[0], family.nodes(m)[1]}});
      return dampers;
    }

    std::unique_ptr<const ElasticBody>
    with_kinematics(std::unique_ptr<const ElasticBody> body,
                    const Kinematics kinematics,
                    const Eigen::MatrixXd &nodes)
    {
      if (kinematics == Kinematics::nonlinear)
        return body;
      return std::make_unique<LinearBody>(*body, nodes.rows(), nodes.cols());
    }

    template <int dim, int spacedim>
    std::vector<typename CellEnergy<dim, spacedim>::Cell>
    cells_left(const Mesh<dim, spacedim> &mesh, const Remains &remains)
    {
      std::vector<typename CellEnergy<dim, spacedim>::Cell> cells;
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        if (remains.cells[cell->active_cell_index()])
          cells.push_back(cell);
      return cells;
    }
  } // namespace

  template <int dim>
  Expression<dim>
  load_factor(const DynamicsSettings<dim> &settings)
  {
    const std::string entry = "Dynamics/Load factor";
    const std::string advice =
      "Write an expression of t in s, such as \"min(t / 0.1, 1)\".";
    const auto factor =
      Expression<dim>::of_place_and_time(settings.load_factor, entry, advice);
    if (factor.depends_on_place())
      throw EntryError(entry, "it depends on the place.", advice);
    return factor;
  }

  template <int dim, int spacedim>
  Excitation
  make_excitation(const Scene<spacedim> &scene,
                  const CalibratedScene<dim, spacedim> &calibrated,
                  const Loading &loading,
                  const LoadCase &load_case,
                  const DynamicsSettings<spacedim> &settings)
  {
    Excitation excitation{calibrated.networks.front().network.nodes,
                          loading.held,
                          remembering(load_case.canned
                                        ? canned_load(load_case, settings)
                                        : load_case.at),
                          scene.contact.obstacles()};
    excitation.load(settings.begin);
    for (const auto &obstacle : excitation.obstacles)
      obstacle.at(settings.begin);
    return excitation;
  }

  template <int dim, int spacedim>
  std::unique_ptr<MovingModel>
  finite_elements_in_motion(const MaterialLaw law,
                            const CalibratedScene<dim, spacedim> &calibrated,
                            const Eigen::MatrixXd &nodes,
                            const Remains &remains)
  {
    const auto &mesh = *calibrated.mesh;
    auto model       = std::make_unique<MovingModel>();
    model->name = model->fit = "fem";
    model->enrichment        = "none";
    const Kinematics kinematics =
      law == MaterialLaw::linear ? Kinematics::linear : Kinematics::nonlinear;
    model->kinematics = word_of(kinematics_words(), kinematics);
    model->elastic =
      with_kinematics(std::make_unique<FiniteElementBody<dim, spacedim>>(
                        mesh,
                        cells_left(mesh, remains),
                        calibrated.element,
                        calibrated.materials,
                        law),
                      kinematics,
                      nodes);
    model->body.mass =
      nodal_masses(mesh, calibrated.element, calibrated.materials);
    return model;
  }

  std::unique_ptr<MovingModel>
  body_in_motion(std::unique_ptr<const ElasticBody> body,
                 const Kinematics kinematics,
                 const SpringNetwork &network)
  {
    auto model = std::make_unique<MovingModel>();
    model->elastic =
      with_kinematics(std::move(body), kinematics, network.nodes);
    model->body.mass = Eigen::Map<const Eigen::VectorXd>(network.mass.data(),
                                                         network.mass.size());
    return model;
  }

  std::unique_ptr<MovingModel>
  network_in_motion(const CalibratedNetwork &network,
                    const SpringNetwork &springs,
                    const Kinematics kinematics,
                    const double spring_damper)
  {
    auto model          = body_in_motion(std::make_unique<NetworkBody>(springs),
                                kinematics,
                                springs);
    model->name         = network.name + suffix_of(kinematics);
    model->fit          = network.fit;
    model->enrichment   = network.enrichment;
    model->kinematics   = word_of(kinematics_words(), kinematics);
    model->body.dampers = dampers_of(springs, spring_damper);
    return model;
  }

  template <int spacedim>
  void
  set_in_motion(const DynamicsSettings<spacedim> &settings,
                Excitation &excitation,
                MovingModel &model)
  {
    const double size = std::numeric_limits<double>::epsilon() *
                        excitation.nodes.cwiseAbs().maxCoeff();
    const auto stiffness =
      stiffness_at_rest(*model.elastic, spacedim, excitation.nodes.cols());
    for (auto &obstacle : excitation.obstacles)
      if (obstacle.stiffness == 0.)
        obstacle.stiffness = 10. * stiffness.mean_diagonal;
    model.body.elastic  = model.elastic.get();
    model.body.damping  = settings.damping;
    model.body.rounding = size * stiffness.norm;
    start(settings.begin,
          1e-6 * (settings.end - settings.begin),
          excitation,
          model);
    // Newton's method goes on where one solution ends.
    const double tolerance = settings.newton.n_iterations == 1
                               ? settings.newton.tolerance
                               : std::min(1e-6, settings.newton.tolerance);
    auto chosen            = make_step_system(spacedim,
                                   model.body,
                                   tolerance,
                                   settings.newton.n_iterations == 1
                                                ? WhereIndefinite::convex_tangent
                                                : WhereIndefinite::factors);
    model.system           = std::move(chosen.system);
    model.reason           = chosen.reason;
    if (settings.integrator == Integrator::generalised_alpha ||
        settings.integrator == Integrator::newmark)
      set_acceleration(model.body, *model.system, model.state);
  }

  template <int dim, int spacedim>
  std::vector<std::unique_ptr<MovingModel>>
  make_moving_models(const Scene<spacedim> &scene,
                     const CalibratedScene<dim, spacedim> &calibrated,
                     const DynamicsSettings<spacedim> &settings,
                     Excitation &excitation,
                     const Remains &remains)
  {
    std::vector<std::unique_ptr<MovingModel>> models;
    if (settings.has_finite_elements)
      {
        models.push_back(finite_elements_in_motion(
          scene.statics.material_law(), calibrated, excitation.nodes, remains));
        if (settings.mass == MassKind::consistent)
          models.back()->body.consistent_mass =
            consistent_mass(*calibrated.mesh,
                            calibrated.element,
                            calibrated.materials);
      }
    const bool is_whole =
      std::count(remains.cells.begin(), remains.cells.end(), false) == 0;
    const DistinctCells cells =
      is_whole ? DistinctCells() : cells_of_fits(scene.fit, *calibrated.mesh);
    for (const auto &network : calibrated.networks)
      {
        const SpringNetwork left =
          is_whole ? network.network
                   : opened(network, calibrated, cells, remains);
        for (const Kinematics kinematics : scene.statics.kinematics())
          models.push_back(network_in_motion(
            network, left, kinematics, settings.spring_damper));
      }
    for (auto &model : models)
      set_in_motion(settings, excitation, *model);
    return models;
  }

  template Expression<2>
  load_factor(const DynamicsSettings<2> &);
  template Expression<3>
  load_factor(const DynamicsSettings<3> &);
  template Excitation
  make_excitation(const Scene<2> &,
                  const CalibratedScene<2> &,
                  const Loading &,
                  const LoadCase &,
                  const DynamicsSettings<2> &);
  template Excitation
  make_excitation(const Scene<3> &,
                  const CalibratedScene<2, 3> &,
                  const Loading &,
                  const LoadCase &,
                  const DynamicsSettings<3> &);
  template Excitation
  make_excitation(const Scene<3> &,
                  const CalibratedScene<3> &,
                  const Loading &,
                  const LoadCase &,
                  const DynamicsSettings<3> &);
  template std::unique_ptr<MovingModel>
  finite_elements_in_motion(MaterialLaw,
                            const CalibratedScene<2> &,
                            const Eigen::MatrixXd &,
                            const Remains &);
  template std::unique_ptr<MovingModel>
  finite_elements_in_motion(MaterialLaw,
                            const CalibratedScene<2, 3> &,
                            const Eigen::MatrixXd &,
                            const Remains &);
  template std::unique_ptr<MovingModel>
  finite_elements_in_motion(MaterialLaw,
                            const CalibratedScene<3> &,
                            const Eigen::MatrixXd &,
                            const Remains &);
  template void
  set_in_motion(const DynamicsSettings<2> &, Excitation &, MovingModel &);
  template void
  set_in_motion(const DynamicsSettings<3> &, Excitation &, MovingModel &);
  template std::vector<std::unique_ptr<MovingModel>>
  make_moving_models(const Scene<2> &,
                     const CalibratedScene<2> &,
                     const DynamicsSettings<2> &,
                     Excitation &,
                     const Remains &);
  template std::vector<std::unique_ptr<MovingModel>>
  make_moving_models(const Scene<3> &,
                     const CalibratedScene<2, 3> &,
                     const DynamicsSettings<3> &,
                     Excitation &,
                     const Remains &);
  template std::vector<std::unique_ptr<MovingModel>>
  make_moving_models(const Scene<3> &,
                     const CalibratedScene<3> &,
                     const DynamicsSettings<3> &,
                     Excitation &,
                     const Remains &);
} // namespace springfit
