#include <springfit/core/error.h>
#include <springfit/motion/direct_step_system.h>
#include <springfit/motion/step_matrix.h>

namespace springfit
{
  namespace
  {
    NodePattern
    pattern_of(const MovingBody &body)
    {
      NodePattern pattern(body.mass.size());
      body.elastic->add_to_pattern(pattern);
      add_to_pattern(body.dampers, pattern);
      for (unsigned int v = 0; v < body.mass.size(); ++v)
        pattern.add_clique(&v, 1);
      for (int c = 0; c < body.consistent_mass.outerSize(); ++c)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(
               body.consistent_mass, c);
             entry;
             ++entry)
          {
            const unsigned int pair[] = {static_cast<unsigned int>(entry.row()),
                                         static_cast<unsigned int>(c)};
            pattern.add_clique(pair, 2);
          }
      return pattern;
    }

    /** The masses of all components, n_unknowns x n_unknowns. */
    template <int dim>
    void
    add_mass(const MovingBody &body, TangentMatrix &matrix)
    {
      using Block = Eigen::Matrix<double, dim, dim>;
      if (body.consistent_mass.nonZeros() == 0)
        for (unsigned int v = 0; v < body.mass.size(); ++v)
          matrix.add(v, v, (body.mass[v] * Block::Identity()).eval());
      for (int c = 0; c < body.consistent_mass.outerSize(); ++c)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(
               body.consistent_mass, c);
             entry;
             ++entry)
          matrix.add(entry.row(),
                     c,
                     (entry.value() * Block::Identity()).eval());
    }

    template <int dim>
    void
    add_node_blocks(const Eigen::MatrixXd &blocks, TangentMatrix &matrix)
    {
      for (Eigen::Index v = 0; v < blocks.cols() / dim; ++v)
        matrix.add(v, v, blocks.block<dim, dim>(0, dim * v).eval());
    }
  } // namespace


  DirectStepSystem::DirectStepSystem(const int dim, const MovingBody &body)
    : dim_(dim)
    , body_(body)
    , tangent_(dim, pattern_of(body))
    , mass_(tangent_)
    , load_stiffness_(tangent_)
    , dampers_(tangent_)
  {
    if (dim == 2)
      add_mass<2>(body, mass_);
    else
      add_mass<3>(body, mass_);
    factors_.analyzePattern(tangent_.matrix());
  }


  void
  DirectStepSystem::linearise(const MotionState &state)
  {
    are_factorised_ = false;
    tangent_.set_zero();
    body_.elastic->add_tangent(state.displacement, tangent_);
    if (body_.load_stiffness)
      {
        const Eigen::Index n   = body_.mass.size();
        Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(dim_, dim_ * n);
        body_.load_stiffness(state, blocks);
        load_stiffness_.set_zero();
        if (dim_ == 2)
          add_node_blocks<2>(blocks, load_stiffness_);
        else
          add_node_blocks<3>(blocks, load_stiffness_);
      }
    if (are_there(body_.dampers))
      {
        dampers_.set_zero();
        add_damper_matrix(body_.dampers, state.displacement, dampers_);
      }
  }


  Eigen::MatrixXd
  DirectStepSystem::stiffness_product(const Eigen::MatrixXd &u) const
  {
    const Eigen::VectorXd product = tangent_.matrix() * u.reshaped();
    return product.reshaped(u.rows(), u.cols());
  }


  void
  DirectStepSystem::factorise(const StepFactors &factors)
  {
    Eigen::SparseMatrix<double> matrix =
      factors.mass * mass_.matrix() + factors.stiffness * tangent_.matrix();
    if (body_.load_stiffness)
      matrix += factors.load_stiffness * load_stiffness_.matrix();
    if (are_there(body_.dampers))
      matrix += factors.dampers * dampers_.matrix();
    put_ones_where_held(body_, matrix);
    factors_.factorize(matrix);
    if (factors_.info() != Eigen::Success)
      throw RunError("The matrix of a step is singular.",
                     "Choose a smaller step.");
    are_factorised_ = true;
    of_factors_     = factors;
  }


  Eigen::MatrixXd
  DirectStepSystem::solve(const StepFactors &factors,
                          const Eigen::MatrixXd &forces)
  {
    if (!are_factorised_ || factors.mass != of_factors_.mass ||
        factors.stiffness != of_factors_.stiffness ||
        factors.load_stiffness != of_factors_.load_stiffness ||
        factors.dampers != of_factors_.dampers)
      factorise(factors);
    Eigen::VectorXd right_hand_side = forces.reshaped();
    for (Eigen::Index i = 0; i < right_hand_side.size(); ++i)
      if (body_.held[i])
        right_hand_side[i] = 0.;
    const Eigen::VectorXd solution = factors_.solve(right_hand_side);
    return solution.reshaped(forces.rows(), forces.cols());
  }
} // namespace springfit
