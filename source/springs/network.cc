#include <springfit/springs/negative.h>
#include <springfit/springs/network.h>

#include <algorithm>

namespace springfit
{
  unsigned int
  n_negative(const SpringNetwork &network)
  {
    return n_negative(
      Eigen::Map<const Eigen::VectorXd>(network.stiffness.data(),
                                        network.stiffness.size()));
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
        const auto [i, j] =
          std::minmax(vertices[pairs[s][0]], vertices[pairs[s][1]]);
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
    network.nodes = nodes_;
    network.mass  = mass_;
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
    return network;
  }
} // namespace springfit
