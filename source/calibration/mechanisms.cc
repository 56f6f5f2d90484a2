#include <springfit/calibration/mechanisms.h>
#include <springfit/fit/object/free_motions.h>

#include <algorithm>
#include <sstream>

namespace springfit
{
  namespace
  {
    bool
    may_be_mechanism(const FittedNetwork &fitted)
    {
      constexpr double rounding = 1e-10;
      return std::any_of(fitted.cells.begin(),
                         fitted.cells.end(),
                         [](const CellFit &cell) {
                           return cell.result.smallest_eigenvalue.value_or(0.) <
                                  rounding;
                         });
    }

    /** "(0.1, 0.2, 0) m" */
    std::string
    place(const SpringNetwork &network, const unsigned int node)
    {
      std::ostringstream text;
      text.precision(4);
      text << '(';
      for (Eigen::Index d = 0; d < network.nodes.rows(); ++d)
        text << (d > 0 ? ", " : "") << network.nodes(d, node);
      text << ") m";
      return text.str();
    }

    std::string
    of_nodes(const SpringNetwork &network,
             const std::vector<unsigned int> &loose)
    {
      if (loose.empty())
        return "";
      return ' ' + std::to_string(loose.size()) +
             (loose.size() == 1 ? " node hangs" : " nodes hang") +
             " on springs that do not hold it in all directions, " +
             (loose.size() == 1 ? "that at " : "the first at ") +
             place(network, loose.front()) + '.';
    }

    std::string
    of_parts(const SpringNetwork &network, const FreeMotions &motions)
    {
      if (motions.n_of_parts == 0)
        return "";
      return ' ' + std::to_string(motions.n_of_parts) +
             (motions.n_of_parts == 1 ? " is a motion of a larger part, in "
                                      : " are motions of larger parts, in ") +
             "which the node at " + place(network, motions.moved_node) +
             " moves furthest.";
    }
  } // namespace

  void
  warn_of_mechanisms(const FittedNetwork &fitted,
                     const std::string &name,
                     Session &session)
  {
    if (!may_be_mechanism(fitted))
      return;
    const SpringNetwork &network = fitted.network;
    const Eigen::MatrixXd &nodes = network.nodes;
    const auto stiffness         = tangent(network.families, network.nodes);
    const auto loose             = loose_nodes(stiffness, nodes.rows());

    // Factors of more are too much.
    const Eigen::Index most_nodes = nodes.rows() == 2 ? 50000 : 5000;
    const bool is_small           = nodes.cols() <= most_nodes;
    FreeMotions motions{static_cast<unsigned int>(loose.size()), 0, 0};
    if (is_small)
      motions = find_free_motions(stiffness, nodes);
    if (motions.n == 0)
      return;
    session.warn(
      "The springs of the fit '" + name +
      "' make the object a mechanism: " + (is_small ? "" : "at least ") +
      std::to_string(motions.n) + " of its deformations cost no energy." +
      of_nodes(network, loose) + of_parts(network, motions) +
      " Set another 'Enrichment' or another fit in 'Methods' of section Fit, "
      "or improve the mesh there.");
  }
} // namespace springfit
