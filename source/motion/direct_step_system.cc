#include <springfit/core/error.h>
#include <springfit/motion/direct_step_system.h>

namespace springfit
{
  namespace
  {
    NodePattern
    pattern_of(const MovingBody &body)
    {
      NodePattern pattern(body.mass.size());
      body.elastic->add_to_pattern(pattern);
      for (unsigned int v = 0; v < body.mass.size(); ++v)
        pattern.add_clique(&v, 1);
      return pattern;
    }
  } // namespace


  DirectStepSystem::DirectStepSystem(const int dim, const MovingBody &body)
    : dim_(dim), body_(body), tangent_(dim, pattern_of(body))
  {
    factors_.analyzePattern(tangent_.matrix());
  }


  void
  DirectStepSystem::linearise(const Eigen::MatrixXd &displacement)
  {
    tangent_.set_zero();
    body_.elastic->add_tangent(displacement, tangent_);
    mass_factor_ = stiffness_factor_ = 0.;
  }


  Eigen::MatrixXd
  DirectStepSystem::stiffness_product(const Eigen::MatrixXd &u) const
  {
    const Eigen::VectorXd product = tangent_.matrix() * u.reshaped();
    return product.reshaped(u.rows(), u.cols());
  }


  Eigen::MatrixXd
  DirectStepSystem::solve(const double mass_factor,
                          const double stiffness_factor,
                          const Eigen::MatrixXd &forces)
  {
    if (mass_factor != mass_factor_ || stiffness_factor != stiffness_factor_)
      {
        // Held unknowns keep their row and column, of a one.
        Eigen::SparseMatrix<double> matrix =
          stiffness_factor * tangent_.matrix();
        for (int column = 0; column < matrix.outerSize(); ++column)
          for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column);
               entry;
               ++entry)
            {
              const bool is_diagonal = entry.row() == entry.col();
              if (body_.held[entry.row()] || body_.held[entry.col()])
                entry.valueRef() = is_diagonal ? 1. : 0.;
              else if (is_diagonal)
                entry.valueRef() += mass_factor * body_.mass[column / dim_];
            }
        factors_.factorize(matrix);
        if (factors_.info() != Eigen::Success)
          throw RunError("The matrix of a step is singular.",
                         "Choose a smaller step.");
        mass_factor_      = mass_factor;
        stiffness_factor_ = stiffness_factor;
      }
    Eigen::VectorXd right_hand_side = forces.reshaped();
    for (Eigen::Index i = 0; i < right_hand_side.size(); ++i)
      if (body_.held[i])
        right_hand_side[i] = 0.;
    const Eigen::VectorXd solution = factors_.solve(right_hand_side);
    return solution.reshaped(forces.rows(), forces.cols());
  }
} // namespace springfit
