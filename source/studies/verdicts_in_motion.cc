#include <springfit/core/error.h>
#include <springfit/motion/critical_step.h>
#include <springfit/motion/stiffness_spectrum.h>
#include <springfit/studies/verdicts_in_motion.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace springfit
{
  namespace
  {
    double
    extent_of(const Eigen::MatrixXd &nodes)
    {
      return (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff())
        .maxCoeff();
    }
  } // namespace

  template <int dim, int spacedim>
  void
  judge_inverted(const JudgedBody<dim, spacedim> &body,
                 const double edges,
                 const std::uint64_t n_steps,
                 StabilityRow &row)
  {
    const auto &varied  = body.setting.varied;
    const auto &loading = body.setting.loading;
    const auto &nodes   = body.setting.nodes;

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

    auto settings = body.scene.dynamics.settings(Integrator::implicit_euler);
    settings.newton.n_iterations = 1;
    settings.openings.clear();
    auto excitation = steady(body, NodalLoad{0. * nodes, 0. * nodes});
    auto moving     = springfit::moving(body, settings, excitation);
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
    const std::uint64_t most = std::min<std::uint64_t>(n_steps, 500);
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
  judge_motion(const JudgedBody<dim, spacedim> &body,
               const Integrator integrator,
               const double step,
               const std::uint64_t most_steps,
               StabilityRow &row)
  {
    const auto &nodes   = body.setting.nodes;
    const auto &loading = body.setting.loading;
    auto settings       = body.scene.dynamics.settings(integrator);
    settings.openings.clear();
    const auto &load_case = loading.cases.front();
    if (load_case.canned && !body.setting.is_scaled)
      {
        refuse("its load cannot be scaled: " +
                 body.setting.failure_of_reference,
               row);
        return;
      }
    auto excitation       = steady(body, load_case.load);
    auto moving           = springfit::moving(body, settings, excitation);
    const double critical = critical_step(moving->body, 0. * nodes).step;
    if (std::isfinite(critical))
      row.predicted_step = critical;

    // What a load moves a body by at once, and some.
    const double far            = 1e3 * extent_of(nodes);
    const std::uint64_t n_steps = integrator == Integrator::symplectic_euler
                                    ? most_steps
                                    : std::min<std::uint64_t>(most_steps, 200);
    std::uint64_t i             = 0;
    const auto diverge          = [&](const std::string &what) {
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

  template void
  judge_inverted(const JudgedBody<2, 2> &,
                 double,
                 std::uint64_t,
                 StabilityRow &);
  template void
  judge_motion(const JudgedBody<2, 2> &,
               Integrator,
               double,
               std::uint64_t,
               StabilityRow &);
  template void
  judge_inverted(const JudgedBody<2, 3> &,
                 double,
                 std::uint64_t,
                 StabilityRow &);
  template void
  judge_motion(const JudgedBody<2, 3> &,
               Integrator,
               double,
               std::uint64_t,
               StabilityRow &);
  template void
  judge_inverted(const JudgedBody<3, 3> &,
                 double,
                 std::uint64_t,
                 StabilityRow &);
  template void
  judge_motion(const JudgedBody<3, 3> &,
               Integrator,
               double,
               std::uint64_t,
               StabilityRow &);
} // namespace springfit
