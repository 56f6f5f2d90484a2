#include <springfit/fit/cell/approximation.h>
#include <springfit/fit/cell/consistent.h>
#include <springfit/fit/cell/spectral_fit.h>
#include <springfit/fit/displacement_fields.h>
#include <springfit/fit/programs/nonnegative_least_squares.h>
#include <springfit/springs/rigid_modes.h>

#include <Eigen/Eigenvalues>
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

    // Of the softest deformation's stiffness, see the header.
    constexpr double least_stiffness = 0.03;

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

    Eigen::MatrixXd
    stiffness(const Eigen::MatrixXd &B, const Eigen::VectorXd &k)
    {
      return B * k.asDiagonal() * B.transpose();
    }

    /** The same constant for all springs, the others zero: nearest to R. */
    Eigen::VectorXd
    equal_springs(const Eigen::MatrixXd &B,
                  const Eigen::MatrixXd &R,
                  const Eigen::Index n_springs)
    {
      Eigen::VectorXd k         = Eigen::VectorXd::Zero(B.cols());
      k.head(n_springs)         = Eigen::VectorXd::Ones(n_springs);
      const Eigen::MatrixXd one = stiffness(B, k);
      return one.cwiseProduct(R).sum() / one.squaredNorm() * k;
    }

    /**
     * The nearest to @p k on the way to equal springs in which no deformation
     * is softer than least_stiffness of the softest one of R. Constants that
     * release energy are left as they are.
     */
    Eigen::VectorXd
    without_mechanisms(const Eigen::MatrixXd &points,
                       const Eigen::MatrixXd &B,
                       const Eigen::MatrixXd &R,
                       const Eigen::Index n_springs,
                       const Eigen::VectorXd &k)
    {
      const Eigen::MatrixXd Q = deformation_basis(points);
      const auto softest      = [&Q](const Eigen::MatrixXd &K) {
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
          Q.transpose() * K * Q, Eigen::EigenvaluesOnly);
        return eigen.eigenvalues()[0];
      };
      const double rounding = 1e-10 * R.norm();
      const double least    = least_stiffness * softest(R);
      const double found    = softest(stiffness(B, k));
      if (found < -rounding || found >= least)
        return k;

      const Eigen::VectorXd equal = equal_springs(B, R, n_springs);
      // What is stiff enough is a convex set.
      double soft = 0., stiff = 1.;
      while (stiff - soft > 1e-3 * stiff)
        {
          const double middle           = 0.5 * (soft + stiff);
          const Eigen::VectorXd between = k + middle * (equal - k);
          (softest(stiffness(B, between)) < least ? soft : stiff) = middle;
        }
      return k + stiff * (equal - k);
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
    const Eigen::VectorXd k = nonnegative_least_squares(equations.gram,
                                                        equations.products,
                                                        n_nonnegative);
    return n_nonnegative > 0
             ? without_mechanisms(points, B, R, n_nonnegative, k)
             : k;
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


  FittedCell
  fit_consistent(const FitProblem &problem, const FitOptions &options)
  {
    const auto in_spectral_norm = [&](const CellTerms &terms,
                                      const Eigen::Index n_nonnegative) {
      return solve(make_consistent_spectral_problem(problem.points,
                                                    terms.gradients,
                                                    problem.stiffness,
                                                    n_nonnegative),
                   terms,
                   options);
    };
    const auto by_ladder = [&](const CellTerms &terms,
                               const Eigen::Index n_nonnegative) {
      return FittedCell{make_cell_model(terms,
                                        fit_consistent(problem.points,
                                                       terms.gradients,
                                                       problem.stiffness,
                                                       n_nonnegative))};
    };
    if (options.norm == Norm::spectral && !is_simplex(problem.kind))
      return approximate(problem, options, in_spectral_norm);
    return approximate(problem, options, by_ladder);
  }
} // namespace springfit
