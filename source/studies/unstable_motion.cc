#include <springfit/studies/unstable_motion.h>

#include <sstream>

namespace springfit
{
  namespace
  {
    std::string
    fastest_node(const Eigen::MatrixXd &shape, const Eigen::MatrixXd &nodes)
    {
      Eigen::Index v;
      shape.colwise().norm().maxCoeff(&v);
      std::ostringstream text;
      text.precision(4);
      text << "node " << v << " at (";
      for (Eigen::Index d = 0; d < nodes.rows(); ++d)
        text << (d > 0 ? ", " : "") << nodes(d, v);
      text << ") m";
      return text.str();
    }

    bool
    is_of(const MovingModel &model, const CalibratedNetwork &network)
    {
      return model.name.compare(0, network.name.size(), network.name) == 0 &&
             model.fit == network.fit && model.enrichment == network.enrichment;
    }

    /** Nothing where none resists. */
    std::string
    stiffest_member(const SpringNetwork &network,
                    const Eigen::MatrixXd &x,
                    const Eigen::MatrixXd &shape)
    {
      std::string words;
      double largest = 0.;
      for (const auto &family : network.families)
        for (std::size_t m = 0; m < family.size(); ++m)
          {
            const unsigned int *nodes = family.nodes(m);
            const std::vector<unsigned int> of_member(nodes,
                                                      nodes +
                                                        family.kind->n_nodes());
            const Eigen::VectorXd u = shape(Eigen::all, of_member).reshaped();
            if (u.isZero(0.))
              continue;
            const double energy =
              u.dot(family.kind->hessian(family.members, m, x) * u);
            if (energy > largest)
              {
                largest = energy;
                words   = " and most of all by the nodes";
                for (const unsigned int v : of_member)
                  words += ' ' + std::to_string(v);
                words += " of " + family.kind->word();
              }
          }
      return words;
    }
  } // namespace

  std::string
  limiting_motion(const std::vector<CalibratedNetwork> &networks,
                  const MovingModel &model,
                  const Eigen::MatrixXd &nodes,
                  const Eigen::MatrixXd &shape)
  {
    std::string words = fastest_node(shape, nodes);
    for (const auto &network : networks)
      if (is_of(model, network))
        words += stiffest_member(network.network,
                                 nodes + model.state.displacement,
                                 shape);
    return words;
  }
} // namespace springfit
