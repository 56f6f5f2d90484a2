#ifndef springfit_tests_unit_derivative_h
#define springfit_tests_unit_derivative_h

#include <Eigen/Core>

namespace springfit::oracle
{
  inline Eigen::VectorXd
  scalar(const double value)
  {
    return Eigen::VectorXd::Constant(1, value);
  }

  /**
   * The derivative of a vector @p f of points by central differences; column i
   * is that to coordinate i, counted node by node.
   */
  template <typename F>
  Eigen::MatrixXd
  derivative(const F &f, const Eigen::MatrixXd &points)
  {
    constexpr double h = 1e-5;
    Eigen::MatrixXd columns;
    for (Eigen::Index i = 0; i < points.size(); ++i)
      {
        Eigen::MatrixXd plus = points, minus = points;
        plus.data()[i] += h;
        minus.data()[i] -= h;
        const Eigen::VectorXd slope = (f(plus) - f(minus)) / (2. * h);
        columns.conservativeResize(slope.size(), points.size());
        columns.col(i) = slope;
      }
    return columns;
  }
} // namespace springfit::oracle

#endif
