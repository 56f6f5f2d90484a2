#include <springfit/fit/consistent.h>
#include <springfit/fit/nonnegative_least_squares.h>
#include <springfit/springs/rigid_modes.h>

#include <Eigen/SVD>

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

    /** The displacements x_a x_b e_c, the coordinates from the centre. */
    Eigen::MatrixXd
    quadratic_fields(const Eigen::MatrixXd &points)
    {
      const Eigen::Index dim  = points.rows();
      const Eigen::MatrixXd x = points.colwise() - points.rowwise().mean();
      Eigen::MatrixXd fields =
        Eigen::MatrixXd::Zero(points.size(), dim * dim * (dim + 1) / 2);
      Eigen::Index column = 0;
      for (Eigen::Index a = 0; a < dim; ++a)
        for (Eigen::Index b = a; b < dim; ++b)
          for (Eigen::Index c = 0; c < dim; ++c, ++column)
            for (Eigen::Index v = 0; v < points.cols(); ++v)
              fields(dim * v + c, column) =
                (a == b ? 1. : std::sqrt(2.)) * x(a, v) * x(b, v);
      return fields;
    }

    /**
     * The hourglass modes as quadratic fields reach them: of length one where
     * these have a part in them, and shorter where the part is below 0.05 of
     * the largest one. Quadratic fields cannot tell the corners of a regular
     * hexahedron by the sign of x y z; those of a distorted one they can.
     */
    Eigen::MatrixXd
    reached_modes(const Eigen::MatrixXd &points, const Eigen::MatrixXd &H)
    {
      if (H.cols() == 0)
        return H;
      const Eigen::JacobiSVD<Eigen::MatrixXd> svd(H.transpose() *
                                                    quadratic_fields(points),
                                                  Eigen::ComputeFullU);
      const Eigen::ArrayXd part =
        svd.singularValues().array() / svd.singularValues()[0];
      const Eigen::ArrayXd length = part.square() / (part.square() + 0.0025);
      return H * svd.matrixU() * length.matrix().asDiagonal();
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
    equations.add_block(
      squared(affine_forces), M, reached_modes(points, H), B, R);
    equations.add_block(2., M, H, B, R);
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
