#include <springfit/motion/largest_mode.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>

namespace springfit
{
  namespace
  {
    // A fixed start has a part along every mode but by an accident.
    Eigen::VectorXd
    random_motion(const Eigen::VectorXd &weight)
    {
      std::mt19937 generator(1);
      std::uniform_real_distribution<double> uniform(-1., 1.);
      Eigen::VectorXd motion(weight.size());
      for (double &x : motion)
        x = uniform(generator);
      return (weight.array() == 0.).select(0., motion);
    }
  } // namespace


  LargestMode
  largest_mode(const int dim,
               const StiffnessProduct &stiffness,
               const Eigen::VectorXd &mass,
               const std::vector<bool> &held,
               const double tolerance)
  {
    Eigen::VectorXd weight(dim * mass.size()); // M^(-1/2)
    Eigen::Index n_unknowns = 0;
    for (Eigen::Index i = 0; i < weight.size(); ++i)
      {
        weight[i] = held[i] ? 0. : 1. / std::sqrt(mass[i / dim]);
        n_unknowns += !held[i];
      }
    LargestMode result;
    result.shape = Eigen::MatrixXd::Zero(dim, mass.size());
    if (n_unknowns == 0)
      return result;

    const Eigen::Index most = std::min<Eigen::Index>(n_unknowns, 300);
    std::vector<Eigen::VectorXd> basis;
    std::vector<double> diagonal, off_diagonal;
    Eigen::MatrixXd u(dim, mass.size()), product(dim, mass.size());
    basis.push_back(random_motion(weight).normalized());
    for (Eigen::Index k = 0; k < most; ++k)
      {
        u = basis[k].cwiseProduct(weight).reshaped(dim, mass.size());
        stiffness(u, product);
        ++result.n_products;
        Eigen::VectorXd next = product.reshaped().cwiseProduct(weight);
        diagonal.push_back(basis[k].dot(next));
        // Twice is enough (Parlett, section 6.9).
        for (unsigned int time = 0; time < 2; ++time)
          for (const Eigen::VectorXd &known : basis)
            next -= known.dot(next) * known;
        const double beta = next.norm();

        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small;
        small.computeFromTridiagonal(
          Eigen::Map<const Eigen::VectorXd>(diagonal.data(), k + 1),
          Eigen::Map<const Eigen::VectorXd>(off_diagonal.data(), k));
        const double largest  = small.eigenvalues()[k];
        const double residual = beta * std::abs(small.eigenvectors()(k, k));
        const bool is_last =
          k + 1 == most || residual <= tolerance * std::abs(largest) ||
          beta <= 1e-14 * small.eigenvalues().cwiseAbs().maxCoeff();
        if (is_last)
          {
            Eigen::VectorXd mode = Eigen::VectorXd::Zero(basis[0].size());
            for (Eigen::Index i = 0; i <= k; ++i)
              mode += small.eigenvectors()(i, k) * basis[i];
            result.shape = mode.cwiseProduct(weight).reshaped(dim, mass.size());
            result.shape /= result.shape.norm();
            result.lowest = std::max(largest, 0.);
            result.square = largest > 0. ? largest + residual : 0.;
            return result;
          }
        off_diagonal.push_back(beta);
        basis.push_back(next / beta);
      }
    return result;
  }
} // namespace springfit
