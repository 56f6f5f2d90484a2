#include <springfit/motion/largest_mode.h>
#include <springfit/motion/stiffness_spectrum.h>
#include <springfit/springs/tangent_matrix.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>

namespace springfit
{
  namespace
  {
    using SparseMatrix = Eigen::SparseMatrix<double>;

    // Less is rounding.
    constexpr double zero = 1e-13;

    StiffnessSpectrum
    of_all_eigenvalues(const SparseMatrix &matrix,
                       const std::vector<Eigen::Index> &free)
    {
      const Eigen::MatrixXd dense = Eigen::MatrixXd(matrix)(free, free);
      const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense,
                                                       Eigen::EigenvaluesOnly)
          .eigenvalues();
      StiffnessSpectrum spectrum;
      spectrum.largest      = eigenvalues.cwiseAbs().maxCoeff();
      const double least    = zero * spectrum.largest;
      spectrum.n_negative   = (eigenvalues.array() < -least).count();
      spectrum.n_mechanisms = (eigenvalues.array().abs() <= least).count();
      spectrum.smallest =
        std::abs(eigenvalues[0]) <= least ? 0. : eigenvalues[0];
      return spectrum;
    }

    StiffnessSpectrum
    of_factors(const int dim,
               const SparseMatrix &matrix,
               const std::vector<bool> &held)
    {
      // Held unknowns are taken out as ones on the diagonal, of the size of the
      // others.
      const Eigen::Index n   = matrix.rows();
      const double size      = matrix.diagonal().cwiseAbs().mean();
      SparseMatrix with_ones = matrix;
      for (Eigen::Index column = 0; column < n; ++column)
        for (SparseMatrix::InnerIterator it(with_ones, column); it; ++it)
          if (held[it.row()] || held[it.col()])
            it.valueRef() = it.row() == it.col() ? size : 0.;

      const auto largest = [&](const StiffnessProduct &product) {
        return largest_mode(dim, product, Eigen::VectorXd::Ones(n / dim), held)
          .square;
      };
      const auto times = [&](const double sign) {
        return [&, sign](const Eigen::MatrixXd &u, Eigen::MatrixXd &product) {
          product =
            (sign * (with_ones * u.reshaped())).reshaped(u.rows(), u.cols());
        };
      };
      StiffnessSpectrum spectrum;
      const double most_negative = largest(times(-1.));
      spectrum.largest           = std::max(largest(times(1.)), most_negative);
      // By Sylvester's law of inertia, of matrices that are shifted a little:
      // a mechanism is negative with one shift and not with the other.
      const double least = zero * spectrum.largest;
      SparseMatrix ones(n, n);
      ones.setIdentity();
      const Eigen::SimplicialLDLT<SparseMatrix> up(
        SparseMatrix(with_ones + least * ones));
      const Eigen::SimplicialLDLT<SparseMatrix> down(
        SparseMatrix(with_ones - least * ones));
      if (up.info() != Eigen::Success || down.info() != Eigen::Success)
        {
          spectrum.n_mechanisms = 1; // a pivot vanished
          return spectrum;
        }
      const auto n_negative =
        [](const Eigen::SimplicialLDLT<SparseMatrix> &factors) {
          const Eigen::ArrayXd pivots = factors.vectorD();
          return (pivots < 0.).count();
        };
      spectrum.n_negative = n_negative(up);
      spectrum.n_mechanisms =
        std::max<Eigen::Index>(0, n_negative(down) - spectrum.n_negative);
      if (spectrum.n_negative > 0)
        spectrum.smallest = -most_negative;
      else if (spectrum.n_mechanisms == 0)
        {
          const double of_inverse =
            largest([&](const Eigen::MatrixXd &u, Eigen::MatrixXd &product) {
              const Eigen::VectorXd solution =
                up.solve(Eigen::VectorXd(u.reshaped()));
              product = solution.reshaped(u.rows(), u.cols());
            });
          spectrum.smallest = of_inverse > 0. ? 1. / of_inverse : 0.;
        }
      return spectrum;
    }
  } // namespace


  StiffnessSpectrum
  stiffness_spectrum(const ElasticBody &body,
                     const Eigen::MatrixXd &displacement,
                     const std::vector<bool> &held)
  {
    NodePattern pattern(displacement.cols());
    body.add_to_pattern(pattern);
    TangentMatrix tangent(displacement.rows(), pattern);
    body.add_tangent(displacement, tangent);

    std::vector<Eigen::Index> free;
    for (std::size_t i = 0; i < held.size(); ++i)
      if (!held[i])
        free.push_back(i);
    constexpr std::size_t most = 500;
    if (free.empty())
      return {};
    return free.size() <= most
             ? of_all_eigenvalues(tangent.matrix(), free)
             : of_factors(displacement.rows(), tangent.matrix(), held);
  }
} // namespace springfit
