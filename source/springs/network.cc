#include <springfit/springs/angle.h>
#include <springfit/springs/negative.h>
#include <springfit/springs/network.h>

#include <algorithm>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    /** A spring of a cell by its nodes in the network. */
    NodePair
    nodes_of(const NodePair &pair, const std::vector<unsigned int> &vertices)
    {
      const auto [i, j] = std::minmax(vertices[pair[0]], vertices[pair[1]]);
      return {{i, j}};
    }

    /** An angle of a cell by its nodes in the network. */
    NodeTriple
    nodes_of(const NodeTriple &angle, const std::vector<unsigned int> &vertices)
    {
      const auto [a, c] = nodes_of(NodePair{{angle[0], angle[2]}}, vertices);
      return {{a, vertices[angle[1]], c}};
    }

    template <int dim>
    double
    rest_angle(const Eigen::MatrixXd &nodes, const NodeTriple &triple)
    {
      const auto [a, m, c] = triple;
      const Vector<dim> u  = nodes.col(a) - nodes.col(m);
      const Vector<dim> v  = nodes.col(c) - nodes.col(m);
      if (is_degenerate_angle<dim>(u, v))
        throw std::logic_error("an angle of the network is straight or folded");
      return angle<dim>(u, v);
    }

    /**
     * Sort the parts of a network by their @p key and add the stiffness of
     * those that have the same one.
     */
    template <typename Part, typename Key>
    std::vector<Part>
    merged(std::vector<Part> parts, const Key &key)
    {
      // Stable, so that the sums do not depend on the sorting.
      std::stable_sort(parts.begin(),
                       parts.end(),
                       [&](const Part &x, const Part &y) {
                         return key(x) < key(y);
                       });
      std::vector<Part> result;
      for (const auto &part : parts)
        if (!result.empty() && key(result.back()) == key(part))
          result.back().stiffness += part.stiffness;
        else
          result.push_back(part);
      return result;
    }
  } // namespace

  unsigned int
  n_negative(const SpringNetwork &network)
  {
    return n_negative(
      Eigen::Map<const Eigen::VectorXd>(network.stiffness.data(),
                                        network.stiffness.size()));
  }

  bool
  has_springs_alone(const SpringNetwork &network)
  {
    return network.couplings.empty() && network.angles.empty() &&
           network.volumes.empty();
  }


  NetworkBuilder::NetworkBuilder(Eigen::MatrixXd nodes)
    : nodes_(std::move(nodes))
    , mass_(nodes_.cols(), 0.)
    , neighbours_(nodes_.cols())
  {}


  void
  NetworkBuilder::add_springs(const std::vector<unsigned int> &vertices,
                              const std::vector<NodePair> &pairs,
                              const Eigen::Ref<const Eigen::VectorXd> &k)
  {
    for (std::size_t s = 0; s < pairs.size(); ++s)
      {
        const auto [i, j] = nodes_of(pairs[s], vertices);
        // A node has some ten neighbours: searching them one by one is
        // quicker than any map.
        auto &row  = neighbours_[i];
        auto found = std::find_if(row.begin(),
                                  row.end(),
                                  [j = j](const Neighbour &neighbour) {
                                    return neighbour.first == j;
                                  });
        if (found == row.end())
          row.emplace_back(j, k[s]);
        else
          found->second += k[s];
      }
  }


  void
  NetworkBuilder::add_couplings(const std::vector<unsigned int> &vertices,
                                const std::vector<NodePair> &pairs,
                                const std::vector<LengthCoupling> &couplings)
  {
    for (const auto &[a, b, stiffness] : couplings)
      couplings_.push_back({nodes_of(pairs[a], vertices),
                            nodes_of(pairs[b], vertices),
                            stiffness});
  }


  void
  NetworkBuilder::add_angles(const std::vector<unsigned int> &vertices,
                             const std::vector<NodeTriple> &triples,
                             const Eigen::Ref<const Eigen::VectorXd> &k)
  {
    for (std::size_t t = 0; t < triples.size(); ++t)
      {
        const NodeTriple nodes = nodes_of(triples[t], vertices);
        angles_.push_back({nodes,
                           k[t],
                           nodes_.rows() == 2 ? rest_angle<2>(nodes_, nodes)
                                              : rest_angle<3>(nodes_, nodes)});
      }
  }


  void
  NetworkBuilder::add_volume(const std::vector<unsigned int> &vertices,
                             const double stiffness,
                             const double rest_volume)
  {
    volumes_.push_back({vertices, stiffness, rest_volume});
  }


  void
  NetworkBuilder::add_masses(const std::vector<unsigned int> &vertices,
                             const Eigen::Ref<const Eigen::VectorXd> &masses)
  {
    for (std::size_t v = 0; v < vertices.size(); ++v)
      mass_[vertices[v]] += masses[v];
  }


  SpringNetwork
  NetworkBuilder::build() const
  {
    SpringNetwork network;
    network.nodes   = nodes_;
    network.mass    = mass_;
    network.volumes = volumes_;
    network.angles =
      merged(angles_, [](const AngleSpring &spring) { return spring.nodes; });
    for (unsigned int i = 0; i < neighbours_.size(); ++i)
      {
        std::vector<Neighbour> row = neighbours_[i];
        std::sort(row.begin(), row.end());
        for (const auto &[j, k] : row)
          {
            network.i.push_back(i);
            network.j.push_back(j);
            network.stiffness.push_back(k);
            network.rest_length.push_back(
              (nodes_.col(j) - nodes_.col(i)).norm());
          }
      }
    network.couplings = merged_couplings(network);
    return network;
  }


  std::vector<LengthCoupling>
  NetworkBuilder::merged_couplings(const SpringNetwork &network) const
  {
    // Springs are sorted by (i, j).
    const auto position = [&](const NodePair &spring) -> unsigned int {
      const auto row =
        std::equal_range(network.i.begin(), network.i.end(), spring[0]);
      const auto begin = network.j.begin() + (row.first - network.i.begin());
      const auto end   = network.j.begin() + (row.second - network.i.begin());
      const auto found = std::lower_bound(begin, end, spring[1]);
      if (found == end || *found != spring[1])
        throw std::logic_error("a coupling names a spring that is not there");
      return found - network.j.begin();
    };

    std::vector<LengthCoupling> all;
    for (const auto &coupling : couplings_)
      {
        const auto [a, b] =
          std::minmax({position(coupling.a), position(coupling.b)});
        all.push_back({a, b, coupling.stiffness});
      }
    return merged(all, [](const LengthCoupling &coupling) {
      return std::pair(coupling.a, coupling.b);
    });
  }
} // namespace springfit
