#ifndef springfit_fit_object_free_body_h
#define springfit_fit_object_free_body_h

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <vector>

namespace springfit
{
  /**
   * The stiffness of a body that nothing holds: singular, as rigid motions
   * cost nothing. It is factorised with as many degrees of freedom fixed as
   * there are rigid motions, which is statically determinate: the fixings
   * change neither the signs of its eigenvalues nor, up to a rigid motion, its
   * response to forces in equilibrium.
   */
  class FreeBody
  {
  public:
    /**
     * @param stiffness n x n, N/m, symmetric, zero on rigid motions
     * @param nodes dim x n_nodes, m; see rigid_body_modes()
     */
    FreeBody(const Eigen::SparseMatrix<double> &stiffness,
             const Eigen::MatrixXd &nodes);

    /**
     * The number of independent deformations that release energy, by the
     * signs of L D L^T (Sylvester's law of inertia). Mechanisms, which cost
     * none, do not count.
     */
    unsigned int
    n_unstable() const;

    /**
     * The number of independent deformations that cost no energy, or so little
     * that rounding errors hide it.
     */
    unsigned int
    n_mechanisms() const;

    /**
     * A deformation that costs least, of length one, orthogonal to those of
     * @p others (n x any, orthonormal): by inverse iteration, and good where
     * it costs as good as nothing.
     */
    Eigen::VectorXd
    softest_motion(const Eigen::MatrixXd &others) const;

    /**
     * The displacements without rigid motions (m) under the part of
     * @p forces (n x n_cases, N) that is in equilibrium: the Moore-Penrose
     * inverse of the stiffness.
     *
     * @throws RunError when a pivot vanishes: the body has a mechanism.
     */
    Eigen::MatrixXd
    respond(const Eigen::MatrixXd &forces) const;

    /** What @p displacements (n x n_cases, m) are without rigid motions. */
    Eigen::MatrixXd
    deformation(const Eigen::MatrixXd &displacements) const;

  private:
    /**
     * How many eigenvalues are below @p shift times the largest diagonal entry.
     */
    unsigned int
    n_below(double shift) const;

    Eigen::MatrixXd rigid_;
    std::vector<Eigen::Index> free_;
    Eigen::SparseMatrix<double> held_; // of the free ones
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
  };
} // namespace springfit

#endif
