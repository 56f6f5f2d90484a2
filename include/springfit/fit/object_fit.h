#ifndef springfit_fit_object_fit_h
#define springfit_fit_object_fit_h

#include <springfit/fit/object_problem.h>

#include <Eigen/SparseCore>

namespace springfit
{
  /** Linear equations A c = d for the constants, to be met in the mean. */
  struct LinearEquations
  {
    Eigen::SparseMatrix<double> A; // m x n_terms
    Eigen::VectorXd d;             // m
  };

  /**
   * K(c) = R, an equation for each entry of the lower triangle, such that the
   * sum of the squares is ||R - K(c)||_F^2 / ||R||_F^2.
   */
  LinearEquations
  matrix_equations(const ObjectProblem &problem);

  /**
   * K(c) u = R u, an equation for each degree of freedom and each column u of
   * @p fields (n x n_fields, m), such that the sum of the squares is that of
   * ||R u - K(c) u||^2 / ||R u||^2. A field without forces (a rigid motion)
   * has no equations.
   */
  LinearEquations
  force_equations(const ObjectProblem &problem, const Eigen::MatrixXd &fields);

  /**
   * The constants that minimise ||R - K(c)||_F.
   *
   * @throws RunError as minimise_quadratic() does.
   */
  Eigen::VectorXd
  fit_matrix(const ObjectProblem &problem);

  /**
   * The constants c that minimise the sum of the squares of force_equations()
   * and @p prior_weight^2 ||K(c) - K(prior)||_F^2 / ||R||_F^2. Without the
   * prior the constants are not unique, and deformations that no field excites
   * may cost no energy.
   *
   * @param prior constants to stay near to, such as those of fits of the cells
   *
   * @throws RunError as minimise_quadratic() does.
   */
  Eigen::VectorXd
  fit_forces(const ObjectProblem &problem,
             const Eigen::MatrixXd &fields,
             const Eigen::VectorXd &prior,
             double prior_weight);
} // namespace springfit

#endif
