#include <springfit/fit/cell/approximation.h>
#include <springfit/fit/cell/consistent.h>
#include <springfit/fit/cell/spectral_fit.h>
#include <springfit/fit/displacement_fields.h>
#include <springfit/fit/programs/nonnegative_least_squares.h>
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

    /** The displacements of unit strains, as large as unit vectors on average.
     */
    Eigen::MatrixXd
    strain_modes(const Eigen::MatrixXd &points)
    {
      const Eigen::MatrixXd modes = affine_fields(points);
      return modes * std::sqrt(modes.cols() / modes.squaredNorm());
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

    // The invariants C_iijj and C_ijij of a tensor, normal strains first.
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
                                   const Eigen::Index n_nonnegative,
                                   const Eigen::MatrixXd &least)
  {
    const Eigen::MatrixXd Q = affine_basis(points);
    const Eigen::MatrixXd S = Eigen::MatrixXd::Identity(Q.rows(), Q.rows()) +
                              (affine_factor - 1.) * Q * Q.transpose();
    return make_spectral_problem(points,
                                 S * B,
                                 S * R * S,
                                 n_nonnegative,
                                 least.size() > 0 ? S * least * S : least);
  }


  FittedCell
  fit_consistent(const FitProblem &problem, const FitOptions &options)
  {
    if (options.norm == Norm::spectral && !is_simplex(problem.kind))
      return fit_with_certificate(problem,
                                  options,
                                  &make_consistent_spectral_problem);
    const auto by_ladder = [&](const CellTerms &terms,
                               const Eigen::Index n_nonnegative) {
      return FittedCell{make_cell_model(terms,
                                        fit_consistent(problem.points,
                                                       terms.gradients,
                                                       problem.stiffness,
                                                       n_nonnegative))};
    };
    return approximate(problem, options, by_ladder);
  }
} // namespace springfit
