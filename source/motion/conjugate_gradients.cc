#include <springfit/motion/conjugate_gradients.h>

namespace springfit
{
  namespace
  {
    double
    product(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b)
    {
      // reshaped() would not be vectorised.
      return Eigen::Map<const Eigen::VectorXd>(a.data(), a.size())
        .dot(Eigen::Map<const Eigen::VectorXd>(b.data(), b.size()));
    }
  } // namespace


  ConjugateGradients
  conjugate_gradients(const MatrixProduct &matrix,
                      const MatrixProduct &preconditioner,
                      const double norm,
                      const unsigned int most_iterations,
                      Eigen::MatrixXd &solution,
                      Eigen::MatrixXd &residual)
  {
    ConjugateGradients result;
    const double first = residual.norm();
    double last        = first;
    double weight      = 0.; // residual . preconditioned residual
    Eigen::MatrixXd z, direction, of_direction;
    while (last > norm && result.n_iterations < most_iterations)
      {
        preconditioner(residual, z);
        const double next = product(residual, z);
        if (result.n_iterations == 0)
          direction = z;
        else
          {
            direction *= next / weight;
            direction += z;
          }
        weight = next;
        matrix(direction, of_direction);
        const double curvature = product(direction, of_direction);
        if (!(curvature > 0.))
          break;
        const double step = weight / curvature;
        solution += step * direction;
        residual -= step * of_direction;
        last = residual.norm();
        ++result.n_iterations;
      }
    result.has_converged = last <= norm;
    if (first > 0.)
      result.reduction = last / first;
    return result;
  }
} // namespace springfit
