#ifndef springfit_mesh_connected_parts_h
#define springfit_mesh_connected_parts_h

#include <vector>

namespace springfit
{
  /** The parts that nodes form when some of them are connected. */
  class ConnectedParts
  {
  public:
    explicit ConnectedParts(unsigned int n_nodes);

    void
    connect(unsigned int a, unsigned int b);

    /**
     * For each node the number of its part, from 0 in the order of the parts'
     * first nodes.
     */
    std::vector<unsigned int>
    part_of_nodes() const;

  private:
    unsigned int
    root(unsigned int node) const;

    mutable std::vector<unsigned int> parents_; // paths shorten when followed
  };
} // namespace springfit

#endif
