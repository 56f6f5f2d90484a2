#include <springfit/core/error.h>
#include <springfit/fit/programs/bounded_least_squares.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace springfit
{
  namespace
  {
    // Of the residual's equation, relative to |b|: what ends the iterations,
    // and what is good enough where rounding errors end them.
    constexpr double tolerance    = 1e-10;
    constexpr double largest_miss = 1e-8;

    /** A residual y and the x(y) that goes with it; see the header. */
    struct Iterate
    {
      Eigen::VectorXd y;
      Eigen::VectorXd x;
      double value; // of the convex function
    };

    class Program
    {
    public:
      Program(const LinearMap &B,
              const Eigen::VectorXd &b,
              const Eigen::VectorXd &prior,
              const Eigen::VectorXd &scale,
              const std::vector<bool> &nonnegative)
        : B_(B), b_(b), prior_(prior), scale_(scale), nonnegative_(nonnegative)
      {}

      Iterate
      iterate(const Eigen::VectorXd &y) const
      {
        Eigen::VectorXd x =
          prior_ + scale_.cwiseAbs2().cwiseProduct(B_.apply_transposed(y));
        for (Eigen::Index s = 0; s < x.size(); ++s)
          if (nonnegative_[s])
            x[s] = std::max(x[s], 0.);
        const double value = 0.5 * y.squaredNorm() - b_.dot(y) +
                             0.5 * x.cwiseQuotient(scale_).squaredNorm();
        return {y, x, value};
      }

      Eigen::VectorXd
      gradient(const Iterate &at) const
      {
        return at.y + B_.apply(at.x) - b_;
      }

      /** The solution of (1 + B D B^T) d = r, |error of r| <= accuracy. */
      Eigen::VectorXd
      newton_step(const Iterate &at,
                  Eigen::VectorXd r,
                  const double accuracy) const
      {
        Eigen::VectorXd D = scale_.cwiseAbs2();
        for (Eigen::Index s = 0; s < D.size(); ++s)
          if (nonnegative_[s] && at.x[s] == 0.)
            D[s] = 0.;

        Eigen::VectorXd d       = Eigen::VectorXd::Zero(r.size());
        Eigen::VectorXd p       = r;
        double size             = r.squaredNorm();
        const Eigen::Index last = 10 * r.size();
        for (Eigen::Index i = 0; i < last && std::sqrt(size) > accuracy; ++i)
          {
            const Eigen::VectorXd q =
              p + B_.apply(D.cwiseProduct(B_.apply_transposed(p)));
            const double length = size / p.dot(q);
            d += length * p;
            r -= length * q;
            const double previous = size;
            size                  = r.squaredNorm();
            p                     = r + size / previous * p;
          }
        return d;
      }

      /** The first of the halved steps that lowers the value enough. */
      Iterate
      search(const Iterate &from,
             const Eigen::VectorXd &step,
             const double slope) const
      {
        // Near the minimum only rounding errors tell values apart.
        const double rounding =
          1e-14 * (b_.squaredNorm() + std::abs(from.value));
        double length = 1.;
        Iterate to    = iterate(from.y + step);
        while (to.value > from.value + 1e-4 * length * slope + rounding &&
               length > 1e-8)
          {
            length /= 2.;
            to = iterate(from.y + length * step);
          }
        return to;
      }

    private:
      const LinearMap &B_;
      const Eigen::VectorXd &b_;
      const Eigen::VectorXd &prior_;
      const Eigen::VectorXd &scale_;
      const std::vector<bool> &nonnegative_;
    };
  } // namespace

  Eigen::VectorXd
  bounded_least_squares(const LinearMap &B,
                        const Eigen::VectorXd &b,
                        const Eigen::VectorXd &prior,
                        const Eigen::VectorXd &scale,
                        const std::vector<bool> &nonnegative)
  {
    const Program program(B, b, prior, scale, nonnegative);
    const double size        = b.norm();
    Iterate at               = program.iterate(Eigen::VectorXd::Zero(b.size()));
    Eigen::VectorXd gradient = program.gradient(at);
    for (int step = 0; step < 100 && gradient.norm() > tolerance * size; ++step)
      {
        const double miss = gradient.norm();
        // The nearer, the more accurate, for quadratic convergence.
        const double accuracy = std::min(0.1, miss / size) * miss;
        const Eigen::VectorXd d =
          program.newton_step(at,
                              -gradient,
                              std::max(accuracy, 0.1 * tolerance * size));
        at       = program.search(at, d, gradient.dot(d));
        gradient = program.gradient(at);
      }
    // Not '>', which lets values pass that are not numbers.
    if (!(gradient.norm() <= largest_miss * size))
      {
        std::ostringstream text;
        text << "A fit of the whole object misses its conditions of "
                "optimality by "
             << gradient.norm() / size << " (relative).";
        throw RunError(text.str(), "Improve the mesh, or fit cell by cell.");
      }
    return at.x;
  }
} // namespace springfit
