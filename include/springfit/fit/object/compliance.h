#ifndef springfit_fit_object_compliance_h
#define springfit_fit_object_compliance_h

#include <springfit/fit/object/object_problem.h>

namespace springfit
{
  /**
   * The constants that minimise
   * ||R^+ E R^+||_F^2 / ||R^+||_F^2 + 0.03^2 ||E||_F^2 / ||R||_F^2,
   * E = R - K(c). The first summand is, to first order, the error of the
   * displacements under the loads of single nodes in turn (those parts that are
   * in equilibrium), as (R - E)^+ = R^+ + R^+ E R^+ + ... Where ||E||_F is
   * ruled by the stiff deformations, which alternate from node to node, this
   * norm is ruled by the soft ones, which loads cause. The second summand
   * holds the stiff ones in place: without it slender objects get mechanisms.
   *
   * With <A, B> the inner product of this norm the normal equations are
   * sum_n <T_m, T_n> c_n = <T_m, R>, a dense system: every term meets every
   * other one in the compliance. Memory grows with the square of the number of
   * terms, time with its cube.
   *
   * @throws RunError when there are too many terms, when R is not positive
   * definite but for rigid motions, or as minimise_quadratic() does.
   */
  Eigen::VectorXd
  fit_compliance(const ObjectProblem &problem);
} // namespace springfit

#endif
