#include <springfit/fit/consistent.h>
#include <springfit/fit/nonnegative_least_squares.h>
#include <springfit/springs/rigid_modes.h>

#include <cmath>

namespace springfit
{
  namespace
  {
    // The weights of the rungs.
    constexpr double isotropic_part  = 10000.;
    constexpr double affine_energies = 1000.;
    constexpr double affine_forces   = 300.;

    constexpr double affine_factor = 17.;

    /**
     * The displacements of unit strains in an orthonormal basis of the
     * symmetric matrices, normal strains first; scaled by a common factor so
     * that they are as large as unit vectors on average.
     *
     * @return (dim * n_nodes) x dim (dim + 1) / 2
     */
    Eigen::MatrixXd
    strain_modes(const Eigen::MatrixXd &points)
    {
      const Eigen::Index dim  = points.rows();
      const Eigen::MatrixXd x = points.colwise() - points.rowwise().mean();
      Eigen::MatrixXd modes =
        Eigen::MatrixXd::Zero(points.size(), dim * (dim + 1) / 2);
      Eigen::Index shear = dim;
      for (Eigen::Index a = 0; a < dim; ++a)
        {
          for (Eigen::Index v = 0; v < points.cols(); ++v)
            modes(dim * v + a, a) = x(a, v);
          for (Eigen::Index b = a + 1; b < dim; ++b, ++shear)
            for (Eigen::Index v = 0; v < points.cols(); ++v)
              {
                modes(dim * v + a, shear) = x(b, v) / std::sqrt(2.);
                modes(dim * v + b, shear) = x(a, v) / std::sqrt(2.);
              }
        }
      return modes * std::sqrt(modes.cols() / modes.squaredNorm());
    }

    /** The normal equations of a least squares problem in k. */
    struct NormalEquations
    {
      Eigen::MatrixXd gram;
      Eigen::VectorXd products;

      /** Add weight ||X^T E Y||^2. */
      void
      add_block(const double weight,
                const Eigen::MatrixXd &X,
                const Eigen::MatrixXd &Y,
                const Eigen::MatrixXd &B,
                const Eigen::MatrixXd &R)
      {
        // A tangent's block is the outer product of X^T b and Y^T b.
        const Eigen::MatrixXd x = X.transpose() * B;
        const Eigen::MatrixXd y = Y.transpose() * B;
        gram += weight * (x.transpose() * x).cwiseProduct(y.transpose() * y);
        products +=
          weight *
          x.cwiseProduct(X.transpose() * R * Y * y).colwise().sum().transpose();
      }

      /** Add weight (row . k - value)^2. */
      void
      add_row(const double weight,
              const Eigen::VectorXd &row,
              const double value)
      {
        gram += weight * row * row.transpose();
        products += weight * row * value;
      }
    };

    double
    squared(const double x)
    {
      return x * x;
    }
  } // namespace


  Eigen::VectorXd
  fit_consistent(const Eigen::MatrixXd &points,
                 const Eigen::MatrixXd &B,
                 const Eigen::MatrixXd &R,
                 const Eigen::Index n_nonnegative)
  {
    const Eigen::Index dim  = points.rows();
    const Eigen::MatrixXd M = strain_modes(points);
    const Eigen::MatrixXd H = hourglass_basis(points);
    NormalEquations equations{Eigen::MatrixXd::Zero(B.cols(), B.cols()),
                              Eigen::VectorXd::Zero(B.cols())};

    // The invariants C_iijj and C_ijij of a tensor.
    const Eigen::MatrixXd tensor = M.transpose() * R * M;
    const Eigen::MatrixXd m      = M.transpose() * B;
    equations.add_row(squared(isotropic_part),
                      m.topRows(dim).colwise().sum().cwiseAbs2(),
                      tensor.topLeftCorner(dim, dim).sum());
    equations.add_row(squared(isotropic_part),
                      m.colwise().squaredNorm(),
                      tensor.trace());

    equations.add_block(squared(affine_energies), M, M, B, R);
    equations.add_block(squared(affine_forces) + 2., M, H, B, R);
    equations.add_block(1., H, H, B, R);
    return nonnegative_least_squares(equations.gram,
                                     equations.products,
                                     n_nonnegative);
  }


  SpectralProblem
  make_consistent_spectral_problem(const Eigen::MatrixXd &points,
                                   const Eigen::MatrixXd &B,
                                   const Eigen::MatrixXd &R,
                                   const Eigen::Index n_nonnegative)
  {
    const Eigen::MatrixXd Q = affine_basis(points);
    const Eigen::MatrixXd S = Eigen::MatrixXd::Identity(Q.rows(), Q.rows()) +
                              (affine_factor - 1.) * Q * Q.transpose();
    return make_spectral_problem(points, S * B, S * R * S, n_nonnegative);
  }
} // namespace springfit
