#include <springfit/comparison/errors.h>

#include <cmath>

namespace springfit
{
  Eigen::VectorXd
  nodal_errors(const Eigen::MatrixXd &reference, const Eigen::MatrixXd &model)
  {
    return (reference - model).colwise().norm().transpose();
  }

  double
  largest_displacement(const Eigen::MatrixXd &displacement)
  {
    return displacement.colwise().norm().maxCoeff();
  }

  ErrorNorms
  error_norms(const Eigen::MatrixXd &reference, const Eigen::MatrixXd &model)
  {
    const Eigen::VectorXd errors = nodal_errors(reference, model);
    const double largest         = largest_displacement(reference);
    return {100. * std::sqrt(errors.squaredNorm() / errors.size()) / largest,
            100. * errors.maxCoeff() / largest};
  }
} // namespace springfit
