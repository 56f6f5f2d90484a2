#ifndef springfit_comparison_rungs_h
#define springfit_comparison_rungs_h

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /**
   * For each cell the first of several models, from cheap to exact, with which
   * a sum over the cells is as small as is wanted: all cells whose contribution
   * is above a threshold take the first model that is below it, and the
   * threshold is as high as can be.
   *
   * @param contributions n_cells x n_models of each load case, signed, of the
   * model in each cell to the error: those of an exact one are 0
   * @param least of each cell, below which it does not go
   * @param tolerance of the magnitude of the sum, in their unit, in all load
   * cases
   * @return by cell the number of its model
   */
  std::vector<unsigned int>
  choose_rungs(const std::vector<Eigen::MatrixXd> &contributions,
               const std::vector<unsigned int> &least,
               double tolerance);
} // namespace springfit

#endif
