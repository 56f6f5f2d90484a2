#ifndef springfit_springs_network_h
#define springfit_springs_network_h

#include <springfit/springs/cell_topology.h>
#include <springfit/springs/coupling.h>
#include <springfit/springs/elongation.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace springfit
{
  /**
   * A spring whose coordinate is the volume V of a cell, in 2-d its area:
   * energy stiffness (V - rest_volume)^2 / 2, in J; see volume.h.
   */
  struct VolumeSpring
  {
    /** The cell's vertices in deal.II's numbering; they tell its kind. */
    std::vector<unsigned int> nodes;

    /** J/m^6 = N/m^5 in 3-d, J/m^4 = N/m^3 in 2-d */
    double stiffness;

    /** m^3, in 2-d m^2 */
    double rest_volume;
  };

  /**
   * A spring whose coordinate is the angle theta at the middle one of three
   * nodes, of the energy stiffness (theta - rest_angle)^2 / 2, in J; see
   * angle.h. At rest it is neither straight nor folded.
   */
  struct AngleSpring
  {
    /** {end, middle, end}, the ends in ascending order. */
    NodeTriple nodes;

    /** J = N m (per rad^2) */
    double stiffness;

    /** rad */
    double rest_angle;
  };

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

    /**
     * Terms between the elongations of two springs, sorted by their positions
     * (a, b) in the list of springs; no pair occurs twice.
     */
    std::vector<LengthCoupling> couplings;

    /** Sorted by their nodes; no triple occurs twice. */
    std::vector<AngleSpring> angles;

    /** In the order of the cells. */
    std::vector<VolumeSpring> volumes;

    /** That of all springs and couplings. */
    SpringLaw law = SpringLaw::quadratic;

    /** per node, kg */
    std::vector<double> mass;
  };

  unsigned int
  n_negative(const SpringNetwork &network);

  /** Whether a network has neither couplings nor angles nor volumes. */
  bool
  has_springs_alone(const SpringNetwork &network);


  /**
   * Assembles a network cell by cell: the constants of springs, couplings and
   * angles and the masses of nodes that cells share are added, in the order of
   * the cells.
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

    /**
     * @param vertices the cell's nodes
     * @param pairs the cell's springs, as positions in @p vertices. Each of
     * those coupled must be added as a spring too, be it without stiffness.
     * @param couplings between positions in @p pairs
     */
    void
    add_couplings(const std::vector<unsigned int> &vertices,
                  const std::vector<NodePair> &pairs,
                  const std::vector<LengthCoupling> &couplings);

    /**
     * @param vertices the cell's nodes
     * @param triples the cell's angles, as positions in @p vertices
     * @param k the stiffness of each, J = N m (per rad^2)
     *
     * @throws std::logic_error when an angle is straight or folded: fits
     * refuse it, see angle_gradients.
     */
    void
    add_angles(const std::vector<unsigned int> &vertices,
               const std::vector<NodeTriple> &triples,
               const Eigen::Ref<const Eigen::VectorXd> &k);

    /**
     * @param vertices the cell's nodes in deal.II's numbering
     * @param stiffness see VolumeSpring
     * @param rest_volume m^3, in 2-d m^2
     */
    void
    add_volume(const std::vector<unsigned int> &vertices,
               double stiffness,
               double rest_volume);

    /** @param masses one per vertex, kg */
    void
    add_masses(const std::vector<unsigned int> &vertices,
               const Eigen::Ref<const Eigen::VectorXd> &masses);

    /** @throws std::logic_error when a coupling names an absent spring. */
    SpringNetwork
    build() const;

  private:
    /** The other node and the stiffness. */
    using Neighbour = std::pair<unsigned int, double>;

    /** Two springs by their nodes. */
    struct Coupling
    {
      NodePair a;
      NodePair b;
      double stiffness;
    };

    /** Sorted by their springs, those of the same two springs added up. */
    std::vector<LengthCoupling>
    merged_couplings(const SpringNetwork &network) const;

    Eigen::MatrixXd nodes_;
    std::vector<double> mass_;
    std::vector<std::vector<Neighbour>> neighbours_;
    std::vector<Coupling> couplings_;
    std::vector<AngleSpring> angles_;
    std::vector<VolumeSpring> volumes_;
  };
} // namespace springfit

#endif
