#ifndef springfit_springs_network_h
#define springfit_springs_network_h

#include <springfit/springs/cell_topology.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace springfit
{
  /**
   * Point masses and the springs between them. Spring s connects the nodes
   * i[s] < j[s]; springs are sorted by (i, j) and no pair occurs twice.
   */
  struct SpringNetwork
  {
    /** dim x n_nodes, m */
    Eigen::MatrixXd nodes;

    std::vector<unsigned int> i;
    std::vector<unsigned int> j;

    /** N/m */
    std::vector<double> stiffness;

    /** m */
    std::vector<double> rest_length;

    /** per node, kg */
    std::vector<double> mass;
  };

  unsigned int
  n_negative(const SpringNetwork &network);


  /**
   * Assembles a network cell by cell: the constants of springs and the masses
   * of nodes that cells share are added, in the order of the cells.
   */
  class NetworkBuilder
  {
  public:
    /** @param nodes dim x n_nodes, m: the rest positions. */
    explicit NetworkBuilder(Eigen::MatrixXd nodes);

    /**
     * @param vertices the cell's nodes
     * @param pairs the cell's springs, as positions in @p vertices
     * @param k the stiffness of each, N/m
     */
    void
    add_springs(const std::vector<unsigned int> &vertices,
                const std::vector<NodePair> &pairs,
                const Eigen::Ref<const Eigen::VectorXd> &k);

    /** @param masses one per vertex, kg */
    void
    add_masses(const std::vector<unsigned int> &vertices,
               const Eigen::Ref<const Eigen::VectorXd> &masses);

    SpringNetwork
    build() const;

  private:
    /** The other node and the stiffness. */
    using Neighbour = std::pair<unsigned int, double>;

    Eigen::MatrixXd nodes_;
    std::vector<double> mass_;
    std::vector<std::vector<Neighbour>> neighbours_;
  };
} // namespace springfit

#endif
