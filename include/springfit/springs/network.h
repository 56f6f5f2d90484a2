#ifndef springfit_springs_network_h
#define springfit_springs_network_h

#include <springfit/springs/family.h>
#include <springfit/springs/tangent_matrix.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace springfit
{
  // Several families as one elastic body: what a family does, done by all.

  using Families = std::vector<Family>;

  /** J; infinite where a member has no derivatives. */
  double
  energy(const Families &families, const Eigen::MatrixXd &x);

  /** See SpringKind. */
  void
  add_forces(const Families &families,
             const Eigen::MatrixXd &x,
             Eigen::MatrixXd &forces);

  void
  add_tangent_product(const Families &families,
                      const Eigen::MatrixXd &x,
                      const Eigen::MatrixXd &u,
                      Eigen::MatrixXd &product);

  void
  add_tangent(const Families &families,
              const Eigen::MatrixXd &x,
              TangentMatrix &tangent);

  /** The nodes of every member as a clique. */
  void
  add_to_pattern(const Families &families, NodePattern &pattern);

  /**
   * The Hessian of the energy at the places @p x (dim x n_nodes), N/m,
   * stress stiffness included: row dim * v + d for component d of node v.
   */
  Eigen::SparseMatrix<double>
  tangent(const Families &families, const Eigen::MatrixXd &x);

  bool
  all_finite(const Families &families);

  // The constants in which the energy is linear, of one member after the other:
  // families whose first column is a stiffness of a single coordinate.

  /** @throws std::logic_error when a family has no such constant. */
  Eigen::VectorXd
  constants_of(const Families &families);

  /**
   * The same families with other constants.
   *
   * @throws std::logic_error as constants_of() does, or for another number of
   * them.
   */
  Families
  with_constants(Families families, const Eigen::VectorXd &constants);

  // Of the springs between two nodes.

  std::size_t
  n_springs(const Families &families);

  /** Those of negative stiffness, see negative.h. */
  unsigned int
  n_negative(const Families &families);

  /** The stiffness of the springs, N/m. */
  Eigen::VectorXd
  spring_stiffness(const Families &families);

  /** Whether all of them bear cells turned inside out, see SpringKind. */
  bool
  bear_inversion(const Families &families);

  /** Whether springs pull at rest, so that volumes must push. */
  bool
  are_under_tension(const Families &families);

  /**
   * The members all of whose nodes belong to one of @p cells, each given by its
   * nodes: what is left where the others are taken out. A spring between a cell
   * that is left and one that is not keeps the stiffness of both.
   */
  Families
  within(const Families &families,
         const std::vector<std::vector<unsigned int>> &cells);

  /** Whether there are springs between two nodes and nothing else. */
  bool
  has_springs_alone(const Families &families);


  /** Point masses and the springs between them. */
  struct SpringNetwork
  {
    /** The places at rest, dim x n_nodes, m */
    Eigen::MatrixXd nodes;

    /** At most one of a kind. */
    Families families;

    /** per node, kg */
    std::vector<double> mass;
  };


  /**
   * Assembles a network cell by cell. Members of the same nodes whose kind
   * neighbours share become one, in the order of the cells: their stiffness
   * adds up. Where their rest values differ and the energy is a square of the
   * distance from them, so do k and k times the rest value; otherwise they
   * remain two members.
   */
  class NetworkBuilder
  {
  public:
    /** @param nodes dim x n_nodes, m: the places at rest. */
    explicit NetworkBuilder(Eigen::MatrixXd nodes);

    /**
     * @param family of a cell, whose nodes are positions in @p nodes
     * @param nodes of the cell
     */
    void
    add(const Family &family, const std::vector<unsigned int> &nodes);

    /** @param masses one per node, kg */
    void
    add_masses(const std::vector<unsigned int> &nodes,
               const Eigen::Ref<const Eigen::VectorXd> &masses);

    SpringNetwork
    build() const;

  private:
    Eigen::MatrixXd nodes_;
    std::vector<double> mass_;
    Families families_;
  };
} // namespace springfit

#endif
