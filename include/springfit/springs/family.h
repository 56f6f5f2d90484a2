#ifndef springfit_springs_family_h
#define springfit_springs_family_h

#include <springfit/springs/tangent_operator.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace springfit
{
  class TangentMatrix;

  /** What a column of numbers says of the members of a family. */
  struct Column
  {
    enum class Role
    {
      stiffness,  // the energy is linear in it; of the first column of a kind
      rest_value, // of the coordinate
      parameter   // anything else
    };

    std::string name; // in tables
    std::string unit; // SI; "1" of a pure number
    Role role;

    /** Of a copy that is scaled by s it is s to this power as large. */
    int power;

    /** How many numbers a member has, one for each of its coordinates. */
    unsigned int width = 1;
  };


  /**
   * The members of a family as a structure of arrays: member m has the nodes
   * from n_nodes * m on, and in each column the numbers from width * m on.
   */
  struct Members
  {
    std::vector<unsigned int> nodes;
    std::vector<std::vector<double>> columns;
  };


  /**
   * A kind of generalised spring: lengths, angles, volumes, ... What it does is
   * done for all members of a family at once.
   *
   * Places @p x of the nodes are dim x n_nodes, in m. A member may lack
   * derivatives at some places (a length of zero, a straight angle, a volume of
   * zero under a logarithmic law). The energy of the family is infinite there,
   * and the other operations leave the member out.
   *
   * There is one object for each kind, so that its address tells kinds apart.
   */
  class SpringKind
  {
  public:
    SpringKind(std::string word,
               std::string law,
               std::vector<std::string> node_names,
               std::vector<Column> columns);

    virtual ~SpringKind() = default;

    SpringKind(const SpringKind &) = delete;

    SpringKind &
    operator=(const SpringKind &) = delete;

    /** In the plural, as files are called: "springs". */
    const std::string &
    word() const;

    /**
     * How the energy follows from the coordinate and the columns, where a word
     * has several laws: "quadratic". Headers of the kinds have the formulas.
     */
    const std::string &
    law() const;

    /** The names of a member's nodes in tables. */
    const std::vector<std::string> &
    node_names() const;

    const std::vector<Column> &
    columns() const;

    unsigned int
    n_nodes() const;

    /**
     * Whether members of the same nodes are one spring: the stiffness of cells
     * that share it adds up, and families are sorted by their nodes. Otherwise
     * every member stays as it is, in the order of the cells.
     */
    virtual bool
    is_shared() const = 0;

    /**
     * Whether the energy of a member is k (q - q0)^2 / 2 of a coordinate q that
     * does not depend on the rest value q0, so that two members are, but for a
     * constant, one with the mean of their rest values, weighted by k.
     */
    virtual bool
    rest_values_average() const;

    /**
     * Whether the energy is one for cells turned inside out, too: finite, and
     * such that they come back. Springs at rest stay where they are then.
     */
    virtual bool
    bears_inversion() const;

    /**
     * Give a member the order of nodes that equal members have in common, or
     * in which its coordinate is positive.
     *
     * @param nodes n_nodes() of them
     * @param numbers a vector for each column
     * @param x the places at rest
     */
    virtual void
    canonicalise(std::vector<unsigned int> &nodes,
                 std::vector<std::vector<double>> &numbers,
                 const Eigen::MatrixXd &x) const;

    /** J */
    virtual double
    energy(const Members &members, const Eigen::MatrixXd &x) const = 0;

    /** Add the forces on the nodes, -grad U, in N to @p forces (as @p x). */
    virtual void
    add_forces(const Members &members,
               const Eigen::MatrixXd &x,
               Eigen::MatrixXd &forces) const = 0;

    /**
     * Add the Hessian of the energy times a displacement @p u (as @p x, m),
     * stress stiffness included, to @p product (as @p x, N).
     */
    virtual void
    add_tangent_product(const Members &members,
                        const Eigen::MatrixXd &x,
                        const Eigen::MatrixXd &u,
                        Eigen::MatrixXd &product) const = 0;

    /**
     * The Hessian as an operator whose states are places of the nodes.
     *
     * @param members must outlive it
     */
    virtual std::unique_ptr<TangentOperator>
    tangent_operator(const Members &members) const;

    /** Add the Hessian of the energy, N/m. */
    virtual void
    add_tangent(const Members &members,
                const Eigen::MatrixXd &x,
                TangentMatrix &tangent) const = 0;

    /**
     * The same without the negative eigenvalues of each member's Hessian: a
     * positive semidefinite matrix, whose Newton step leads downhill (Teran,
     * Sifakis, Irving and Fedkiw 2005).
     */
    virtual void
    add_convex_tangent(const Members &members,
                       const Eigen::MatrixXd &x,
                       TangentMatrix &tangent) const = 0;

    /**
     * Add the Hessian's blocks of each node with itself, in N/m, to @p blocks:
     * dim x (dim * n_nodes), one block beside the other.
     */
    virtual void
    add_diagonal_blocks(const Members &members,
                        const Eigen::MatrixXd &x,
                        Eigen::MatrixXd &blocks) const = 0;

    /**
     * The Hessian of one member, N/m, with respect to its own nodes: row
     * dim * a + d for component d of its node a. Zero where it has none.
     */
    virtual Eigen::MatrixXd
    hessian(const Members &members,
            std::size_t member,
            const Eigen::MatrixXd &x) const = 0;

  private:
    const std::string word_, law_;
    const std::vector<std::string> node_names_;
    const std::vector<Column> columns_;
  };


  /** Springs of one kind. */
  struct Family
  {
    explicit Family(const SpringKind &kind);

    std::size_t
    size() const;

    /** The nodes of a member: n_nodes() of the kind, from here on. */
    const unsigned int *
    nodes(std::size_t member) const;

    /**
     * @param nodes n_nodes() of the kind
     * @param numbers a vector for each column, of its width
     */
    void
    add(const std::vector<unsigned int> &nodes,
        const std::vector<std::vector<double>> &numbers);

    /** The numbers of a member, a vector for each column. */
    std::vector<std::vector<double>>
    numbers(std::size_t member) const;

    const SpringKind *kind; // never null
    Members members;
  };

  /** Some members of a family, in the order given. */
  Family
  selected(const Family &family, const std::vector<std::size_t> &members);

  /** The members of a copy that is @p scale times as large. */
  Family
  scaled(Family family, double scale);

  bool
  all_finite(const Family &family);
} // namespace springfit

#endif
