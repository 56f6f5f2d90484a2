#include <springfit/mesh/connected_parts.h>

#include <algorithm>
#include <numeric>

namespace springfit
{
  ConnectedParts::ConnectedParts(const unsigned int n_nodes) : parents_(n_nodes)
  {
    std::iota(parents_.begin(), parents_.end(), 0);
  }

  unsigned int
  ConnectedParts::root(unsigned int node) const
  {
    while (parents_[node] != node)
      {
        parents_[node] = parents_[parents_[node]];
        node           = parents_[node];
      }
    return node;
  }

  void
  ConnectedParts::connect(const unsigned int a, const unsigned int b)
  {
    const unsigned int root_a          = root(a);
    const unsigned int root_b          = root(b);
    parents_[std::max(root_a, root_b)] = std::min(root_a, root_b);
  }

  std::vector<unsigned int>
  ConnectedParts::part_of_nodes() const
  {
    // A root is the smallest node of its part, so it is met first.
    std::vector<unsigned int> parts(parents_.size());
    unsigned int n_parts = 0;
    for (unsigned int node = 0; node < parents_.size(); ++node)
      parts[node] = root(node) == node ? n_parts++ : parts[root(node)];
    return parts;
  }
} // namespace springfit
