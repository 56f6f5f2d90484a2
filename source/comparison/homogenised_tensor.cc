#include <springfit/comparison/homogenised_tensor.h>

#include <Eigen/LU>

#include <cmath>

namespace springfit
{
  namespace
  {
    /** A spring's elongation is this times the displacement gradient. */
    Eigen::VectorXd
    dyad(const SpringNetwork &network, const std::size_t spring)
    {
      const Eigen::Index dim  = network.nodes.rows();
      const Eigen::VectorXd d = network.nodes.col(network.j[spring]) -
                                network.nodes.col(network.i[spring]);
      Eigen::VectorXd result(dim * dim);
      for (Eigen::Index i = 0; i < dim; ++i)
        for (Eigen::Index j = 0; j < dim; ++j)
          result[dim * i + j] = d[i] * d[j] / d.norm();
      return result;
    }
  } // namespace

  ElasticityTensor
  homogenised_tensor(const SpringNetwork &network, const double volume)
  {
    const Eigen::Index dim  = network.nodes.rows();
    ElasticityTensor tensor = ElasticityTensor::Zero(dim * dim, dim * dim);
    for (std::size_t s = 0; s < network.stiffness.size(); ++s)
      {
        const Eigen::VectorXd q = dyad(network, s);
        tensor += network.stiffness[s] * q * q.transpose();
      }
    for (const auto &[a, b, stiffness] : network.couplings)
      {
        const Eigen::MatrixXd term =
          stiffness * dyad(network, a) * dyad(network, b).transpose();
        tensor += term + term.transpose();
      }

    // A volume changes by itself times the divergence.
    double volumes = 0.;
    for (const auto &spring : network.volumes)
      volumes += spring.stiffness * spring.rest_volume * spring.rest_volume;
    for (Eigen::Index i = 0; i < dim; ++i)
      for (Eigen::Index j = 0; j < dim; ++j)
        tensor(dim * i + i, dim * j + j) += volumes;
    return tensor / volume;
  }

  IsotropicPart
  isotropic_part(const ElasticityTensor &tensor)
  {
    const auto dim = static_cast<Eigen::Index>(
      std::lround(std::sqrt(static_cast<double>(tensor.rows()))));
    const double n = dim;

    // The two invariants C_iijj and (symmetrised) C_ijij of an isotropic
    // tensor are linear in lambda and mu.
    double iijj = 0., ijij = 0.;
    for (Eigen::Index i = 0; i < dim; ++i)
      for (Eigen::Index j = 0; j < dim; ++j)
        {
          iijj += tensor(dim * i + i, dim * j + j);
          ijij += 0.5 * (tensor(dim * i + j, dim * i + j) +
                         tensor(dim * i + j, dim * j + i));
        }
    Eigen::Matrix2d invariants;
    invariants << n * n, 2. * n, n, n * n + n;
    const Eigen::Vector2d lame =
      invariants.inverse() * Eigen::Vector2d(iijj, ijij);

    ElasticityTensor isotropic = ElasticityTensor::Zero(dim * dim, dim * dim);
    for (Eigen::Index i = 0; i < dim; ++i)
      for (Eigen::Index j = 0; j < dim; ++j)
        {
          isotropic(dim * i + i, dim * j + j) += lame[0];
          isotropic(dim * i + j, dim * i + j) += lame[1];
          isotropic(dim * i + j, dim * j + i) += lame[1];
        }
    return {lame[0], lame[1], (tensor - isotropic).norm() / tensor.norm()};
  }

  YoungPoisson
  young_poisson(const double lambda, const double mu)
  {
    return {mu * (3. * lambda + 2. * mu) / (lambda + mu),
            lambda / (2. * (lambda + mu))};
  }

  YoungPoisson
  young_poisson_plane_stress(const double lambda, const double mu)
  {
    return {4. * mu * (lambda + mu) / (lambda + 2. * mu),
            lambda / (lambda + 2. * mu)};
  }

  YoungPoisson
  from_plane_strain(const YoungPoisson &apparent)
  {
    const double nu = apparent.poissons_ratio / (1. + apparent.poissons_ratio);
    return {apparent.youngs_modulus * (1. - nu * nu), nu};
  }
} // namespace springfit
