#include <springfit/core/collective.h>
#include <springfit/core/formatted.h>
#include <springfit/motion/critical_step.h>
#include <springfit/motion/stable_step.h>
#include <springfit/output/csv.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/response/linear_body.h>
#include <springfit/response/network_body.h>
#include <springfit/studies/stable_steps.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    // An assembled stiffness of more cells, or Lanczos' vectors of more nodes,
    // take too much memory for a number that nobody has asked for.
    constexpr unsigned int most_cells = 200000;
    constexpr Eigen::Index most_nodes = 200000;

    struct Row
    {
      std::string model;
      std::optional<double> step, bound; // s
      Eigen::Index node;                 // that moves most
      Eigen::VectorXd place;             // m
    };

    /** The step of a body that nothing holds. */
    Row
    row_of(const std::string &name,
           const ElasticBody &body,
           const SpringNetwork &network,
           const RayleighDamping &damping)
    {
      MovingBody moving;
      moving.elastic = &body;
      moving.mass    = Eigen::Map<const Eigen::VectorXd>(network.mass.data(),
                                                      network.mass.size());
      moving.damping = damping;
      moving.held.assign(network.nodes.size(), false);
      const auto critical = critical_step(moving, 0. * network.nodes);
      Row row{name, {}, {}, 0, {}};
      if (std::isfinite(critical.step))
        row.step = critical.step;
      critical.shape.colwise().norm().maxCoeff(&row.node);
      row.place = network.nodes.col(row.node);
      return row;
    }

    std::string
    line_of(const Row &row)
    {
      std::string place;
      for (Eigen::Index d = 0; d < row.place.size(); ++d)
        place += (d > 0 ? ", " : "") + formatted("%.4g", row.place[d]);
      if (!row.step)
        place = "-";
      return formatted("  %-32s %11s %11s  node %d at (%s) m",
                       row.model.c_str(),
                       row.step ? formatted("%.4g", *row.step).c_str() : "-",
                       row.bound ? formatted("%.4g", *row.bound).c_str() : "-",
                       int(row.node),
                       place.c_str());
    }
  } // namespace

  template <int dim, int spacedim>
  void
  tell_stable_steps(const Scene<spacedim> &scene,
                    const CalibratedScene<dim, spacedim> &calibrated,
                    Session &session)
  {
    dealii::TimerOutput::Scope scope(session.timer(), "Stable steps");
    const auto damping = scene.dynamics.damping();
    const auto &mesh   = *calibrated.mesh;
    std::vector<Row> rows;
    for (const auto &network : calibrated.networks)
      {
        if (network.network.nodes.cols() > most_nodes)
          {
            rows.push_back({network.name, {}, {}, 0, {}});
            session.skip("Stable step of '" + network.name + "'",
                         "it is not sought for more than " +
                           std::to_string(most_nodes) +
                           " nodes; the bound is there");
          }
        else
          rows.push_back(row_of(network.name,
                                NetworkBody(network.network),
                                network.network,
                                damping));
        const double bound =
          spring_bound_of_step(network.network,
                               std::vector<bool>(network.network.nodes.cols(),
                                                 false));
        if (std::isfinite(bound))
          rows.back().bound = bound;
      }
    if (mesh.triangulation.n_active_cells() <= most_cells &&
        mesh.triangulation.n_vertices() <= most_nodes)
      {
        const auto &network = calibrated.networks.front().network;
        const FiniteElementBody<dim, spacedim> elements(mesh,
                                                        calibrated.element,
                                                        calibrated.materials,
                                                        MaterialLaw::linear);
        rows.push_back(
          row_of("fem",
                 LinearBody(elements, spacedim, network.nodes.cols()),
                 network,
                 damping));
      }
    else
      session.skip("Stable step of the finite elements",
                   "their stiffness is not assembled for more than " +
                     std::to_string(most_cells) + " cells");

    session.print("Largest stable steps of symplectic Euler's method at rest "
                  "(s; free: supports only raise them), the bound from the "
                  "springs alone, and the node that sets them:");
    for (const auto &row : rows)
      session.print(line_of(row));
    run_on_root(session.communicator(), [&]() {
      CsvTable table(
        std::string("model,stable_step_s,spring_bound_s,node,x,y") +
        (spacedim == 3 ? ",z" : ""));
      for (const auto &row : rows)
        {
          table.new_row();
          table << row.model << row.step << row.bound;
          if (row.step)
            table << static_cast<unsigned int>(row.node);
          else
            table << "";
          for (int d = 0; d < spacedim; ++d)
            table << (row.step ? std::optional<double>(row.place[d])
                               : std::nullopt);
        }
      table.write(session.draft() / "stable_steps.csv");
    });
  }

  template void
  tell_stable_steps(const Scene<2> &, const CalibratedScene<2> &, Session &);
  template void
  tell_stable_steps(const Scene<3> &, const CalibratedScene<2, 3> &, Session &);
  template void
  tell_stable_steps(const Scene<3> &, const CalibratedScene<3> &, Session &);
} // namespace springfit
