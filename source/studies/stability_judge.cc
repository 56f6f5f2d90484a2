#include <springfit/calibration/calibration.h>
#include <springfit/comparison/errors.h>
#include <springfit/core/error.h>
#include <springfit/motion/critical_step.h>
#include <springfit/motion/observed_step.h>
#include <springfit/motion/stiffness_spectrum.h>
#include <springfit/reference/nodal_masses.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/response/network_body.h>
#include <springfit/response/stability.h>
#include <springfit/studies/delivered.h>
#include <springfit/studies/moving_models.h>
#include <springfit/studies/openings.h>
#include <springfit/studies/responses.h>
#include <springfit/studies/stability_judge.h>
#include <springfit/studies/varied_scene.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace springfit
{
  namespace
  {
    /** A fit of a point of the axes: a network, or why there is none. */
    struct Attempt
    {
      std::optional<CalibratedNetwork> network;
      std::string failure;
    };

    /** The body without the axes that are states or motions of it. */
    Variation
    body_of(Variation variation)
    {
      for (const auto axis : {StabilityAxis::stretch,
                              StabilityAxis::inversion,
                              StabilityAxis::time_step})
        variation.erase(axis);
      return variation;
    }

    template <int dim, int spacedim>
    double
    shortest_edge(const Mesh<dim, spacedim> &mesh)
    {
      double shortest = std::numeric_limits<double>::infinity();
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        for (const unsigned int line : cell->line_indices())
          shortest = std::min(shortest, cell->line(line)->diameter());
      return shortest;
    }

    double
    extent_of(const Eigen::MatrixXd &nodes)
    {
      return (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff())
        .maxCoeff();
    }

    void
    refuse(const std::string &why, StabilityRow &row)
    {
      row.verdict = "refused";
      row.reason  = why;
    }

    /** Tables have numbers only. */
    void
    drop_what_is_not_finite(StabilityRow &row)
    {
      for (auto *number : {&row.cell_eigenvalue,
                           &row.network_eigenvalue,
                           &row.condition,
                           &row.gap,
                           &row.predicted_step,
                           &row.observed_step,
                           &row.energy_drift,
                           &row.e_rms,
                           &row.youngs_modulus,
                           &row.poissons_ratio,
                           &row.iterations})
        if (*number && !std::isfinite(**number))
          number->reset();
    }

    void
    tell_cells(const CalibratedNetwork &network, StabilityRow &row)
    {
      row.calibration = "accepted";
      row.n_negative  = n_negative(network.network.families);
      for (const auto &cell : network.cells)
        {
          if (const auto gap = cell.result.duality_gap)
            {
              row.calibration = "certified";
              row.gap         = std::max(row.gap.value_or(0.), *gap);
            }
          if (const auto smallest = cell.result.smallest_eigenvalue)
            row.cell_eigenvalue =
              std::min(row.cell_eigenvalue.value_or(*smallest), *smallest);
        }
    }

    /** Unstable where some motion releases energy or costs none. */
    void
    tell_spectrum(const StiffnessSpectrum &spectrum, StabilityRow &row)
    {
      row.n_unstable   = spectrum.n_negative;
      row.n_mechanisms = spectrum.n_mechanisms;
      if (spectrum.largest > 0.)
        row.network_eigenvalue = spectrum.smallest / spectrum.largest;
      if (spectrum.smallest > 0.)
        row.condition = spectrum.largest / spectrum.smallest;
      row.verdict = "stable";
      if (spectrum.n_negative > 0)
        {
          row.verdict = "unstable";
          row.reason =
            std::to_string(spectrum.n_negative) + " motions release energy";
        }
      else if (spectrum.n_mechanisms > 0)
        {
          row.verdict = "unstable";
          row.reason =
            std::to_string(spectrum.n_mechanisms) + " motions cost no energy";
        }
    }
  } // namespace

  template <int dim, int spacedim>
  struct StabilityJudge<dim, spacedim>::Setting
  {
    Variation body;
    std::string failure; // why there is nothing to judge
    CalibratedScene<dim, spacedim> varied;
    Loading loading;
    std::unique_ptr<const Discretization<spacedim>> discretization;
    std::vector<Equilibrium> linear, reference; // of the finite elements
    std::string failure_of_reference;
    std::map<std::size_t, Attempt> fits;
  };

  template <int dim, int spacedim>
  StabilityJudge<dim, spacedim>::StabilityJudge(
    const Scene<spacedim> &scene,
    const StabilitySettings &settings,
    Session &session)
    : scene_(scene)
    , settings_(settings)
    , session_(session)
    , kind_(scene.geometry
              .template create<dim>(session.communicator(), scene.folder)
              ->cell_kind)
  {}

  template <int dim, int spacedim>
  StabilityJudge<dim, spacedim>::~StabilityJudge() = default;

  template <int dim, int spacedim>
  std::vector<JudgedModel>
  StabilityJudge<dim, spacedim>::models(const Variation &variation) const
  {
    const bool is_motion = value_of(variation, StabilityAxis::time_step) &&
                           !value_of(variation, StabilityAxis::stretch) &&
                           !value_of(variation, StabilityAxis::inversion);
    const bool is_nonlinear = value_of(variation, StabilityAxis::stretch) ||
                              value_of(variation, StabilityAxis::inversion);
    std::vector<std::optional<Integrator>> integrators(1);
    if (is_motion)
      integrators.assign(settings_.integrators.begin(),
                         settings_.integrators.end());
    std::vector<JudgedModel> models;
    const auto add = [&](const std::optional<std::size_t> &fit,
                         const Kinematics kinematics) {
      if (is_nonlinear && kinematics == Kinematics::linear)
        return;
      for (const auto &integrator : integrators)
        models.push_back({fit, kinematics, integrator});
    };
    add({},
        scene_.statics.material_law() == MaterialLaw::linear
          ? Kinematics::linear
          : Kinematics::nonlinear);
    for (std::size_t f = 0; f < scene_.fit.rows(kind_).size(); ++f)
      for (const auto kinematics : scene_.statics.kinematics())
        add(f, kinematics);
    return models;
  }

  template <int dim, int spacedim>
  StabilityRow
  StabilityJudge<dim, spacedim>::blank_row(const Variation &variation,
                                           const JudgedModel &model) const
  {
    StabilityRow row;
    for (const auto &axis : settings_.axes)
      row.axes.emplace_back(word_of(stability_axis_words(), axis.axis),
                            value_of(variation, axis.axis));
    row.fit        = "fem";
    row.enrichment = "none";
    if (model.fit)
      {
        const auto fit = scene_.fit.rows(kind_)[*model.fit];
        row.fit        = name_of(*fit.method);
        row.enrichment = name_of(fit.enrichment);
      }
    row.kinematics = word_of(kinematics_words(), model.kinematics);
    row.integrator =
      model.integrator ? word_of(integrator_words(), *model.integrator) : "-";
    row.calibration = model.fit ? "refused" : "-";
    return row;
  }

  template <int dim, int spacedim>
  void
  StabilityJudge<dim, spacedim>::set(const Variation &variation)
  {
    const Variation body = body_of(variation);
    if (setting_ && setting_->body == body)
      return;
    setting_       = std::make_unique<Setting>();
    auto &setting  = *setting_;
    setting.body   = body;
    setting.varied = varied_scene<dim>(scene_, body, session_.communicator());
    auto &varied   = setting.varied;
    scene_.fit.check_cells(varied.mesh->cell_kind);
    setting.loading =
      scene_.loads.resolve(*varied.mesh, varied.element, varied.materials);
    auto &loading = setting.loading;
    scene_.loads.check_supports(*varied.mesh, loading);
    setting.discretization =
      std::make_unique<const Discretization<spacedim>>(*varied.mesh,
                                                       loading.held,
                                                       session_.communicator());
    try
      {
        const auto linear =
          scene_.statics.finite_elements_of(MaterialLaw::linear,
                                            *setting.discretization,
                                            *varied.mesh,
                                            varied.element,
                                            varied.materials);
        for (auto &load_case : loading.cases)
          {
            setting.linear.push_back(linear->respond(load_case.load));
            const double scale =
              scale_of(load_case, loading, setting.linear.back().displacement);
            load_case.load.forces *= scale;
            setting.linear.back().displacement *= scale;
          }
        setting.reference = setting.linear;
        if (scene_.statics.material_law() == MaterialLaw::linear)
          return;
        const auto model =
          scene_.statics.finite_elements(*setting.discretization,
                                         *varied.mesh,
                                         varied.element,
                                         varied.materials);
        for (std::size_t i = 0; i < loading.cases.size(); ++i)
          {
            setting.reference[i] = model->respond(loading.cases[i].load);
            if (!is_complete(setting.reference[i]))
              setting.failure_of_reference = setting.reference[i].failure;
          }
      }
    catch (const RunError &error)
      {
        setting.failure_of_reference = error.what();
      }
  }

  template <int dim, int spacedim>
  StabilityRow
  StabilityJudge<dim, spacedim>::judge(const Variation &variation,
                                       const JudgedModel &model)
  {
    StabilityRow row = blank_row(variation, model);
    try
      {
        set(variation);
        if (model.fit)
          {
            auto &attempt = setting_->fits[*model.fit];
            if (!attempt.network && attempt.failure.empty())
              try
                {
                  attempt.network =
                    calibrate_row(scene_.fit,
                                  scene_.fit.rows(kind_)[*model.fit],
                                  *setting_->varied.mesh,
                                  setting_->varied.element,
                                  setting_->varied.materials,
                                  scene_.statics.material_law(),
                                  session_);
                }
              catch (const RunError &error)
                {
                  attempt.failure = error.what();
                }
            if (!attempt.network)
              {
                refuse(attempt.failure, row);
                return row;
              }
            tell_cells(*attempt.network, row);
          }

        if (const auto stretch = value_of(variation, StabilityAxis::stretch))
          judge_stretched(*stretch, model, row);
        else if (const auto edges =
                   value_of(variation, StabilityAxis::inversion))
          judge_inverted(*edges, model, row);
        else if (const auto step =
                   value_of(variation, StabilityAxis::time_step))
          judge_motion(*step, model, row);
        else
          judge_at_rest(model, row);
      }
    catch (const RunError &error)
      {
        refuse(error.what(), row);
      }
    catch (const InputError &error)
      {
        // A mesh that cannot be, a region that is empty at this size.
        setting_.reset();
        refuse(error.what(), row);
      }
    drop_what_is_not_finite(row);
    return row;
  }

  namespace
  {
    template <int dim, int spacedim>
    std::unique_ptr<BodyOfMembers>
    body_of_members(const CalibratedScene<dim, spacedim> &varied,
                    const CalibratedNetwork *network,
                    const MaterialLaw law)
    {
      if (network != nullptr)
        return std::make_unique<NetworkBody>(network->network);
      return std::make_unique<FiniteElementBody<dim, spacedim>>(
        *varied.mesh, varied.element, varied.materials, law);
    }

    template <int spacedim>
    Eigen::MatrixXd
    nodes_of(const Nodes<spacedim> &nodes)
    {
      Eigen::MatrixXd places(spacedim, nodes.size());
      for (std::size_t v = 0; v < nodes.size(); ++v)
        for (int d = 0; d < spacedim; ++d)
          places(d, v) = nodes.places[v][d];
      return places;
    }

    /** A model that moves from rest under @p excitation, which outlives it. */
    template <int dim, int spacedim>
    std::unique_ptr<MovingModel>
    moving_model(const Scene<spacedim> &scene,
                 const CalibratedScene<dim, spacedim> &varied,
                 const CalibratedNetwork *network,
                 const Kinematics kinematics,
                 const DynamicsSettings<spacedim> &settings,
                 Excitation &excitation)
    {
      auto model = network != nullptr
                     ? network_in_motion(*network,
                                         network->network,
                                         kinematics,
                                         settings.spring_damper)
                     : finite_elements_in_motion(scene.statics.material_law(),
                                                 varied,
                                                 excitation.nodes,
                                                 everything(*varied.mesh));
      set_in_motion(settings, excitation, *model);
      return model;
    }
  } // namespace

  template <int dim, int spacedim>
  void
  StabilityJudge<dim, spacedim>::judge_at_rest(const JudgedModel &model,
                                               StabilityRow &row)
  {
    const auto &varied  = setting_->varied;
    const auto &loading = setting_->loading;
    const CalibratedNetwork *network =
      model.fit ? &*setting_->fits.at(*model.fit).network : nullptr;
    const Eigen::MatrixXd nodes = nodes_of(varied.mesh->nodes);
    const auto law              = scene_.statics.material_law();
    const auto body             = body_of_members(varied, network, law);
    tell_spectrum(stiffness_spectrum(*body, 0. * nodes, loading.held), row);

    auto settings = scene_.dynamics.settings(Integrator::symplectic_euler);
    settings.openings.clear();
    Excitation excitation{nodes, loading.held, {}, {}, {}};
    excitation.load = [zero = NodalLoad{0. * nodes, 0. * nodes}](double) {
      return zero;
    };
    if (row.verdict == "stable")
      {
        auto moving = moving_model(
          scene_, varied, network, model.kinematics, settings, excitation);
        moving->body.loads    = {};
        const double critical = critical_step(moving->body, 0. * nodes).step;
        if (std::isfinite(critical))
          {
            constexpr double width = 0.002;
            const double size      = shortest_edge(*varied.mesh);
            row.predicted_step     = critical;
            row.observed_step      = observed_step(moving->body,
                                              *moving->system,
                                              spacedim,
                                              critical,
                                              settings_.n_steps,
                                              width,
                                              size);
            const auto motion      = observe(moving->body,
                                        *moving->system,
                                        spacedim,
                                        0.9 * critical,
                                        settings_.n_steps,
                                        size);
            if (!motion.grows)
              row.energy_drift = motion.energy_drift;
          }
      }

    if (!setting_->failure_of_reference.empty())
      {
        if (network == nullptr && row.verdict == "stable")
          refuse(setting_->failure_of_reference, row);
        return;
      }
    const auto statics =
      network != nullptr
        ? scene_.statics.springs(*setting_->discretization,
                                 *varied.mesh,
                                 varied.element,
                                 network->network,
                                 network->name,
                                 model.kinematics)
        : scene_.statics.finite_elements(*setting_->discretization,
                                         *varied.mesh,
                                         varied.element,
                                         varied.materials);
    for (std::size_t i = 0; i < loading.cases.size(); ++i)
      {
        const auto found = network != nullptr
                             ? statics->respond(loading.cases[i].load)
                             : setting_->reference[i];
        if (!is_complete(found))
          {
            if (row.verdict == "stable")
              {
                row.verdict = "unstable";
                row.reason =
                  "load case " + loading.cases[i].name + ": " + found.failure;
              }
            continue;
          }
        if (network != nullptr)
          row.e_rms = std::max(row.e_rms.value_or(0.),
                               error_norms(setting_->reference[i].displacement,
                                           found.displacement)
                                 .e_rms_percent);
        if (loading.cases[i].canned == Load::tension)
          if (const auto constants = delivered(scene_,
                                               varied,
                                               loading,
                                               loading.cases[i].load.forces,
                                               found.displacement))
            {
              row.youngs_modulus = constants->youngs_modulus;
              row.poissons_ratio = constants->poissons_ratio;
            }
      }
  }

  template <int dim, int spacedim>
  void
  StabilityJudge<dim, spacedim>::judge_stretched(const double stretch,
                                                 const JudgedModel &model,
                                                 StabilityRow &row)
  {
    const auto &varied = setting_->varied;
    const CalibratedNetwork *network =
      model.fit ? &*setting_->fits.at(*model.fit).network : nullptr;
    const Eigen::MatrixXd nodes = nodes_of(varied.mesh->nodes);
    Eigen::Index axis;
    const double length =
      (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).maxCoeff(&axis);
    const double low = nodes.row(axis).minCoeff();

    // Both ends are held, and one of them is moved.
    std::vector<bool> held(nodes.size(), false);
    NodalLoad load{0. * nodes, 0. * nodes};
    for (Eigen::Index v = 0; v < nodes.cols(); ++v)
      {
        const double place = (nodes(axis, v) - low) / length;
        if (place > 1e-6 && place < 1. - 1e-6)
          continue;
        for (int d = 0; d < spacedim; ++d)
          held[spacedim * v + d] = true;
        load.support(axis, v) = place * (stretch - 1.) * length;
      }
    const Discretization<spacedim> discretization(*varied.mesh,
                                                  held,
                                                  session_.communicator());
    const auto statics = network != nullptr
                           ? scene_.statics.springs(discretization,
                                                    *varied.mesh,
                                                    varied.element,
                                                    network->network,
                                                    network->name,
                                                    model.kinematics)
                           : scene_.statics.finite_elements(discretization,
                                                            *varied.mesh,
                                                            varied.element,
                                                            varied.materials);
    const auto found   = statics->respond(load);
    if (!is_complete(found))
      {
        row.verdict = "unstable";
        row.reason  = found.failure;
        return;
      }
    const auto body =
      body_of_members(varied, network, scene_.statics.material_law());
    tell_spectrum(stiffness_spectrum(*body, found.displacement, held), row);
    MovingBody moving;
    moving.elastic = body.get();
    moving.mass = nodal_masses(*varied.mesh, varied.element, varied.materials);
    moving.held = held;
    moving.damping        = scene_.dynamics.damping();
    const double critical = critical_step(moving, found.displacement).step;
    if (std::isfinite(critical))
      row.predicted_step = critical;
  }

  template <int dim, int spacedim>
  void
  StabilityJudge<dim, spacedim>::judge_inverted(const double edges,
                                                const JudgedModel &model,
                                                StabilityRow &row)
  {
    const auto &varied  = setting_->varied;
    const auto &loading = setting_->loading;
    const CalibratedNetwork *network =
      model.fit ? &*setting_->fits.at(*model.fit).network : nullptr;
    const Eigen::MatrixXd nodes = nodes_of(varied.mesh->nodes);

    // The free node in the middle, along the first direction.
    const Eigen::VectorXd middle =
      0.5 * (nodes.rowwise().maxCoeff() + nodes.rowwise().minCoeff());
    Eigen::Index pushed = -1;
    for (Eigen::Index v = 0; v < nodes.cols(); ++v)
      if (!loading.held[spacedim * v] &&
          (pushed < 0 || (nodes.col(v) - middle).norm() <
                           (nodes.col(pushed) - middle).norm()))
        pushed = v;
    if (pushed < 0)
      {
        refuse("all nodes are held along x", row);
        return;
      }
    double edge = 0.;
    for (const auto &cell : varied.mesh->triangulation.active_cell_iterators())
      for (const unsigned int line : cell->line_indices())
        for (const unsigned int end : {0u, 1u})
          if (cell->line(line)->vertex_index(end) == pushed)
            edge = std::max(edge, cell->line(line)->diameter());

    auto settings = scene_.dynamics.settings(Integrator::implicit_euler);
    settings.newton.n_iterations = 1;
    settings.openings.clear();
    Excitation excitation{nodes, loading.held, {}, {}, {}};
    excitation.load = [zero = NodalLoad{0. * nodes, 0. * nodes}](double) {
      return zero;
    };
    auto moving = moving_model(
      scene_, varied, network, model.kinematics, settings, excitation);
    // A step of a slow motion, in which implicit Euler's method damps most.
    const auto spectrum =
      stiffness_spectrum(*moving->elastic, 0. * nodes, loading.held);
    const double smallest =
      std::max(spectrum.smallest, 1e-6 * spectrum.largest);
    const double step =
      2. * M_PI * std::sqrt(moving->body.mass.mean() / smallest);
    moving->state.displacement(0, pushed) = edges * edge;
    if (!std::isfinite(moving->elastic->energy(moving->state.displacement)))
      {
        refuse("it has no energy there", row);
        return;
      }
    const std::uint64_t most = std::min<std::uint64_t>(settings_.n_steps, 500);
    for (std::uint64_t i = 0; i < most; ++i)
      {
        try
          {
            advance(settings, step, (i + 1) * step, excitation, *moving);
          }
        catch (const RunError &error)
          {
            row.verdict = "diverged";
            row.reason  = error.what();
            return;
          }
        const double distance =
          moving->state.displacement.cwiseAbs().maxCoeff();
        constexpr double far = 1e3;
        if (!(distance < far * edge))
          {
            row.verdict = "diverged";
            row.reason  = "at step " + std::to_string(i + 1);
            return;
          }
        if (distance < 1e-4 * edge)
          {
            row.verdict    = "stable";
            row.iterations = i + 1;
            return;
          }
      }
    row.verdict = "unstable";
    row.reason =
      "it stays " +
      std::to_string(moving->state.displacement.cwiseAbs().maxCoeff() / edge) +
      " edges away from rest";
  }

  template <int dim, int spacedim>
  void
  StabilityJudge<dim, spacedim>::judge_motion(const double step,
                                              const JudgedModel &model,
                                              StabilityRow &row)
  {
    const auto &varied  = setting_->varied;
    const auto &loading = setting_->loading;
    const CalibratedNetwork *network =
      model.fit ? &*setting_->fits.at(*model.fit).network : nullptr;
    const Eigen::MatrixXd nodes = nodes_of(varied.mesh->nodes);
    auto settings               = scene_.dynamics.settings(*model.integrator);
    settings.openings.clear();
    const auto &load_case = loading.cases.front();
    if (load_case.canned && setting_->linear.empty())
      {
        refuse("its load cannot be scaled: " + setting_->failure_of_reference,
               row);
        return;
      }
    Excitation excitation{nodes, loading.held, {}, {}, {}};
    excitation.load = [load = load_case.load](double) { return load; };
    auto moving     = moving_model(
      scene_, varied, network, model.kinematics, settings, excitation);
    const double critical = critical_step(moving->body, 0. * nodes).step;
    if (std::isfinite(critical))
      row.predicted_step = critical;

    // What a load moves a body by at once, and some.
    const double far = 1e3 * extent_of(nodes);
    const std::uint64_t n_steps =
      *model.integrator == Integrator::symplectic_euler
        ? settings_.n_steps
        : std::min<std::uint64_t>(settings_.n_steps, 200);
    std::uint64_t i    = 0;
    const auto diverge = [&](const std::string &what) {
      row.verdict = "diverged";
      row.reason  = what + " after " + std::to_string(i + 1) + " steps";
    };
    try
      {
        for (; i < n_steps; ++i)
          {
            advance(settings, step, (i + 1) * step, excitation, *moving);
            if (!(moving->state.displacement.cwiseAbs().maxCoeff() < far))
              {
                diverge("it is a thousand times its size away");
                return;
              }
          }
      }
    catch (const RunError &error)
      {
        diverge(error.what());
        return;
      }
    row.verdict = "stable";
    if (moving->solutions.n > 0)
      row.iterations =
        double(moving->solutions.n_iterations) / moving->solutions.n;
  }

  template class StabilityJudge<2, 2>;
  template class StabilityJudge<2, 3>;
  template class StabilityJudge<3, 3>;
} // namespace springfit
