#ifndef springfit_fit_cell_definiteness_h
#define springfit_fit_cell_definiteness_h

#include <springfit/fit/cell_model.h>
#include <springfit/fit/problem.h>

namespace springfit
{
  /**
   * The smallest eigenvalue of a cell's forces at rest on its deformations,
   * relative to ||R||_2.
   */
  double
  smallest_eigenvalue(const FitProblem &problem, const CellModel &model);

  /**
   * Whether a cell with this smallest eigenvalue releases energy in no
   * deformation, up to rounding.
   */
  bool
  is_definite(double smallest_eigenvalue);

  /**
   * The least smallest_eigenvalue() of a fit with springs >= 0: 0.03 of that of
   * R itself. Springs that are to be >= 0 may all but vanish, and what only
   * they hold moves freely.
   */
  double
  floor_of_eigenvalues(const FitProblem &problem);

  /** All springs alike, nearest to R in Frobenius' norm; nothing else. */
  CellModel
  equal_springs(const FitProblem &problem);

  /**
   * The nearest to @p model on the way to equal springs, which have no
   * mechanisms, that is no softer than the floor. A model that releases energy
   * is left as it is. On the specimen and on bricks of 1 : 2 this hardly moves
   * the errors of the consistent fit with any factor from 0.01 to 0.1.
   */
  CellModel
  without_mechanisms(const FitProblem &problem, const CellModel &model);

  /**
   * 90 % of the way from @p safe towards @p wanted on which the cell stays
   * positive semidefinite: definite cells are a convex set.
   *
   * @param safe a model with which it is
   */
  CellModel
  furthest_definite(const FitProblem &problem,
                    const CellModel &safe,
                    const CellModel &wanted);
} // namespace springfit

#endif
