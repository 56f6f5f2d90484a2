#ifndef springfit_fit_cell_coupled_cell_h
#define springfit_fit_cell_coupled_cell_h

#include <springfit/fit/cell_model.h>
#include <springfit/fit/problem.h>
#include <springfit/springs/rest_families.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /**
   * Springs between all nodes of a cell and couplings between all of them:
   * K = B C B^T with a symmetric C. The lengths of a cell's springs tell every
   * deformation of it, so that C reproduces R exactly: with e = B^T u the
   * elongations, R = B C B^T.
   *
   * A triangle and a tetrahedron have as many springs as deformations, and one
   * C (6 and 21 numbers; triangles: Delingette 2008). Quadrilaterals and
   * hexahedra have more; C is then the one of smallest Frobenius norm, B^+ R
   * B^+T. In either case C is positive semidefinite if R is, so that the
   * springs on its diagonal have k >= 0, and the energy e^T C e / 2 of the true
   * elongations is never negative.
   */
  CellModel
  fit_coupled_cell(const FitProblem &problem);

  /** Springs of stiffness @p k (N/m) at rest, and couplings between them. */
  CellModel
  coupled_model(const FitProblem &problem,
                const Eigen::VectorXd &k,
                const std::vector<LengthCoupling> &couplings);
} // namespace springfit

#endif
