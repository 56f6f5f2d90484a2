#include <springfit/comparison/errors.h>

#include <cmath>
#include <vector>

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

  namespace
  {
    ErrorNorms
    norms(const Eigen::VectorXd &errors, const double largest)
    {
      return {100. * std::sqrt(errors.squaredNorm() / errors.size()) / largest,
              100. * errors.maxCoeff() / largest};
    }
  } // namespace

  ErrorNorms
  error_norms(const Eigen::MatrixXd &reference, const Eigen::MatrixXd &model)
  {
    return norms(nodal_errors(reference, model),
                 largest_displacement(reference));
  }

  ErrorNorms
  error_norms_where_loaded(const Eigen::MatrixXd &reference,
                           const Eigen::MatrixXd &model,
                           const Eigen::MatrixXd &forces)
  {
    std::vector<Eigen::Index> loaded;
    for (Eigen::Index node = 0; node < forces.cols(); ++node)
      if (!forces.col(node).isZero(0.))
        loaded.push_back(node);
    return norms(nodal_errors(reference, model)(loaded),
                 largest_displacement(reference));
  }
} // namespace springfit
