#ifndef springfit_springs_positive_part_h
#define springfit_springs_positive_part_h

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace springfit
{
  /** A symmetric matrix without its negative eigenvalues. */
  template <typename Matrix>
  Matrix
  positive_part(const Matrix &symmetric)
  {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(symmetric);
    return solver.eigenvectors() *
           solver.eigenvalues().cwiseMax(0.).asDiagonal() *
           solver.eigenvectors().transpose();
  }
} // namespace springfit

#endif
