#include <springfit/core/error.h>
#include <springfit/fit/object/free_body.h>
#include <springfit/springs/rigid_modes.h>

#include <Eigen/QR>

#include <cmath>

namespace springfit
{
  namespace
  {
    // Relative to the largest one, a pivot below it is zero.
    constexpr double rounding = 1e-12;

    /**
     * All degrees of freedom but those whose fixing holds a body best: pivots
     * of the rigid motions.
     */
    std::vector<Eigen::Index>
    without_fixed(const Eigen::MatrixXd &rigid)
    {
      const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rigid.transpose());
      std::vector<bool> is_fixed(rigid.rows(), false);
      for (Eigen::Index r = 0; r < rigid.cols(); ++r)
        is_fixed[qr.colsPermutation().indices()[r]] = true;

      std::vector<Eigen::Index> free;
      for (std::size_t i = 0; i < is_fixed.size(); ++i)
        if (!is_fixed[i])
          free.push_back(i);
      return free;
    }
  } // namespace

  FreeBody::FreeBody(const Eigen::SparseMatrix<double> &stiffness,
                     const Eigen::MatrixXd &nodes)
    : rigid_(rigid_body_modes(nodes)), free_(without_fixed(rigid_))
  {
    std::vector<Eigen::Index> number(stiffness.rows(), -1);
    for (std::size_t i = 0; i < free_.size(); ++i)
      number[free_[i]] = i;
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index column = 0; column < stiffness.cols(); ++column)
      for (Eigen::SparseMatrix<double>::InnerIterator it(stiffness, column); it;
           ++it)
        if (number[it.row()] >= 0 && number[it.col()] >= 0)
          entries.emplace_back(number[it.row()], number[it.col()], it.value());
    held_.resize(free_.size(), free_.size());
    held_.setFromTriplets(entries.begin(), entries.end());
    factors_.compute(held_);
  }

  unsigned int
  FreeBody::n_below(const double shift) const
  {
    Eigen::SparseMatrix<double> shifted = held_;
    shifted.diagonal().array() -= shift * held_.diagonal().maxCoeff();
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(shifted);
    return (factors.vectorD().array() < 0.).count();
  }

  unsigned int
  FreeBody::n_unstable() const
  {
    // Off zero, lest a mechanism's pivot be a rounding error of either sign.
    return n_below(-rounding);
  }

  unsigned int
  FreeBody::n_mechanisms() const
  {
    return n_below(rounding) - n_below(-rounding);
  }

  Eigen::VectorXd
  FreeBody::softest_motion(const Eigen::MatrixXd &others) const
  {
    Eigen::SparseMatrix<double> shifted = held_;
    shifted.diagonal().array() += 10. * rounding * held_.diagonal().maxCoeff();
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(shifted);

    // Of no symmetry that the body may have.
    Eigen::VectorXd motion(rigid_.rows());
    for (Eigen::Index i = 0; i < motion.size(); ++i)
      motion[i] = std::sin(1. + i * std::sqrt(2.));
    for (int step = 0; step < 5; ++step)
      {
        motion -= others * (others.transpose() * motion);
        const Eigen::VectorXd of_free = motion(free_);
        const Eigen::VectorXd softer  = factors.solve(of_free);
        motion.setZero();
        motion(free_) = softer;
        motion.normalize();
      }
    const Eigen::VectorXd found = deformation(motion);
    return (found - others * (others.transpose() * found)).normalized();
  }

  Eigen::MatrixXd
  FreeBody::respond(const Eigen::MatrixXd &forces) const
  {
    const Eigen::ArrayXd pivots = factors_.vectorD().array().abs();
    if (factors_.info() != Eigen::Success ||
        !(pivots.minCoeff() > rounding * pivots.maxCoeff()))
      throw RunError("The stiffness of the object is singular beyond its rigid "
                     "motions.",
                     "Its parts must be joined so that none can move freely.");

    const Eigen::MatrixXd in_equilibrium = deformation(forces);
    const Eigen::MatrixXd of_free        = in_equilibrium(free_, Eigen::all);
    Eigen::MatrixXd displacements =
      Eigen::MatrixXd::Zero(forces.rows(), forces.cols());
    const Eigen::MatrixXd responses  = factors_.solve(of_free);
    displacements(free_, Eigen::all) = responses;
    return deformation(displacements);
  }

  Eigen::MatrixXd
  FreeBody::deformation(const Eigen::MatrixXd &displacements) const
  {
    return displacements - rigid_ * (rigid_.transpose() * displacements);
  }
} // namespace springfit
