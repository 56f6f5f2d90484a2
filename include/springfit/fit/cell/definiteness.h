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
