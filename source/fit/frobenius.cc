#include <springfit/fit/frobenius.h>
#include <springfit/fit/nonnegative_least_squares.h>

#include <Eigen/Cholesky>

namespace springfit
{
  Eigen::MatrixXd
  tangent_gram(const Eigen::MatrixXd &B)
  {
    return (B.transpose() * B).cwiseAbs2();
  }


  Eigen::VectorXd
  tangent_products(const Eigen::MatrixXd &B, const Eigen::MatrixXd &R)
  {
    return B.cwiseProduct(R * B).colwise().sum();
  }


  Eigen::VectorXd
  fit_frobenius(const Eigen::MatrixXd &B, const Eigen::MatrixXd &R)
  {
    return tangent_gram(B).llt().solve(tangent_products(B, R));
  }


  Eigen::VectorXd
  fit_frobenius_nonnegative(const Eigen::MatrixXd &B, const Eigen::MatrixXd &R)
  {
    return nonnegative_least_squares(tangent_gram(B), tangent_products(B, R));
  }
} // namespace springfit
