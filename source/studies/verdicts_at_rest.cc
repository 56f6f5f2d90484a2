#include <springfit/comparison/errors.h>
#include <springfit/motion/critical_step.h>
#include <springfit/motion/observed_step.h>
#include <springfit/motion/stiffness_spectrum.h>
#include <springfit/reference/nodal_masses.h>
#include <springfit/studies/delivered.h>
#include <springfit/studies/responses.h>
#include <springfit/studies/verdicts_at_rest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace springfit
{
  namespace
  {
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
  void
  judge_at_rest(const JudgedBody<dim, spacedim> &body,
                const std::uint64_t n_steps,
                StabilityRow &row)
  {
    const auto &varied  = body.setting.varied;
    const auto &loading = body.setting.loading;
    const auto &nodes   = body.setting.nodes;
    const auto members  = members_of(body);
    tell_spectrum(stiffness_spectrum(*members, 0. * nodes, loading.held), row);

    auto settings = body.scene.dynamics.settings(Integrator::symplectic_euler);
    settings.openings.clear();
    auto excitation = steady(body, NodalLoad{0. * nodes, 0. * nodes});
    if (row.verdict == "stable")
      {
        auto moving           = springfit::moving(body, settings, excitation);
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
                                              n_steps,
                                              width,
                                              size);
            const auto motion      = observe(moving->body,
                                        *moving->system,
                                        spacedim,
                                        0.9 * critical,
                                        n_steps,
                                        size);
            if (!motion.grows)
              row.energy_drift = motion.energy_drift;
          }
      }

    if (!body.setting.failure_of_reference.empty())
      {
        if (body.network == nullptr && row.verdict == "stable")
          refuse(body.setting.failure_of_reference, row);
        return;
      }
    const auto statics = statics_of(body, *body.setting.discretization);
    for (std::size_t i = 0; i < loading.cases.size(); ++i)
      {
        const auto found = body.network != nullptr
                             ? statics->respond(loading.cases[i].load)
                             : body.setting.reference[i];
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
        if (body.network != nullptr)
          row.e_rms =
            std::max(row.e_rms.value_or(0.),
                     error_norms(body.setting.reference[i].displacement,
                                 found.displacement)
                       .e_rms_percent);
        if (loading.cases[i].canned == Load::tension)
          if (const auto constants = delivered(body.scene,
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
  judge_stretched(const JudgedBody<dim, spacedim> &body,
                  const double stretch,
                  StabilityRow &row)
  {
    const auto &varied = body.setting.varied;
    const auto &nodes  = body.setting.nodes;
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
    const Discretization<spacedim> discretization(
      *varied.mesh, held, body.setting.discretization->communicator());
    const auto statics = statics_of(body, discretization);
    const auto found   = statics->respond(load);
    if (!is_complete(found))
      {
        row.verdict = "unstable";
        row.reason  = found.failure;
        return;
      }
    const auto members = members_of(body);
    tell_spectrum(stiffness_spectrum(*members, found.displacement, held), row);
    MovingBody moving;
    moving.elastic = members.get();
    moving.mass = nodal_masses(*varied.mesh, varied.element, varied.materials);
    moving.held = held;
    moving.damping        = body.scene.dynamics.damping();
    const double critical = critical_step(moving, found.displacement).step;
    if (std::isfinite(critical))
      row.predicted_step = critical;
  }

  template void
  judge_at_rest(const JudgedBody<2, 2> &, std::uint64_t, StabilityRow &);
  template void
  judge_stretched(const JudgedBody<2, 2> &, double, StabilityRow &);
  template void
  judge_at_rest(const JudgedBody<2, 3> &, std::uint64_t, StabilityRow &);
  template void
  judge_stretched(const JudgedBody<2, 3> &, double, StabilityRow &);
  template void
  judge_at_rest(const JudgedBody<3, 3> &, std::uint64_t, StabilityRow &);
  template void
  judge_stretched(const JudgedBody<3, 3> &, double, StabilityRow &);
} // namespace springfit
