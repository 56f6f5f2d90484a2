#ifndef springfit_fit_object_object_fit_h
#define springfit_fit_object_object_fit_h

#include <springfit/fit/object/object_problem.h>

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
   * The constants that minimise ||R - K(c)||_F.
   *
   * @throws RunError as minimise_quadratic() does.
   */
  Eigen::VectorXd
  fit_matrix(const ObjectProblem &problem);

  /**
   * The constants c with which the displacements of @p fields are right: those
   * that minimise the mean over the fields u of ||R^+ E u||^2 / ||u||^2,
   * E = R - K(c), and @p prior_weight^2 times the mean over the terms of
   * ((c_m - prior_m) / s_m)^2. The loads R u of a field displace the springs,
   * to first order, by R^+ E u more than the finite elements. Where the forces
   * E u are ruled by short waves this error is ruled by the soft deformations,
   * and it is what a comparison shows.
   *
   * s_m = (mean of R's diagonal at the nodes of T_m) / ||T_m||_F: with it a
   * term is about as stiff as the body around it. Without the prior the
   * constants are not unique, and deformations that no field excites may cost
   * no energy.
   *
   * @param fields n x n_fields, m; only deformations count, and a field that is
   * a rigid motion not at all
   * @param prior constants to stay near to, such as those of fits of the cells
   *
   * @throws RunError as FreeBody and bounded_least_squares() do.
   */
  Eigen::VectorXd
  fit_displacements(const ObjectProblem &problem,
                    const Eigen::MatrixXd &fields,
                    const Eigen::VectorXd &prior,
                    double prior_weight);
} // namespace springfit

#endif
