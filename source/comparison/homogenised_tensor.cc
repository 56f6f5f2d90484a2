#include <springfit/comparison/homogenised_tensor.h>
#include <springfit/springs/gradients.h>

#include <Eigen/LU>

#include <cmath>

namespace springfit
{
  namespace
  {
    /**
     * The change of a coordinate with the gradient of an affine displacement,
     * sum_v b_v x_v^T by rows, where b is its gradient with respect to the
     * nodes x.
     */
    Eigen::VectorXd
    affine_change(const Eigen::MatrixXd &nodes, const Eigen::VectorXd &gradient)
    {
      const Eigen::Index dim = nodes.rows();
      const Eigen::Map<const Eigen::MatrixXd> b(gradient.data(),
                                                dim,
                                                nodes.cols());
      return (nodes * b.transpose()).reshaped();
    }

    /** Of the elongation of a spring. */
    Eigen::VectorXd
    affine_change(const SpringNetwork &network, const unsigned int spring)
    {
      Eigen::MatrixXd ends(network.nodes.rows(), 2);
      ends << network.nodes.col(network.i[spring]),
        network.nodes.col(network.j[spring]);
      return affine_change(ends, length_gradients(ends, {{{0, 1}}}));
    }

    Eigen::VectorXd
    affine_change(const SpringNetwork &network, const AngleSpring &spring)
    {
      Eigen::MatrixXd corner(network.nodes.rows(), 3);
      for (unsigned int v = 0; v < 3; ++v)
        corner.col(v) = network.nodes.col(spring.nodes[v]);
      return affine_change(corner, angle_gradients(corner, {{{0, 1, 2}}}));
    }
  } // namespace

  ElasticityTensor
  homogenised_tensor(const SpringNetwork &network, const double volume)
  {
    const Eigen::Index dim  = network.nodes.rows();
    ElasticityTensor tensor = ElasticityTensor::Zero(dim * dim, dim * dim);
    for (std::size_t s = 0; s < network.stiffness.size(); ++s)
      {
        const Eigen::VectorXd q = affine_change(network, s);
        tensor += network.stiffness[s] * q * q.transpose();
      }
    for (const auto &[a, b, stiffness] : network.couplings)
      {
        const Eigen::MatrixXd term = stiffness * affine_change(network, a) *
                                     affine_change(network, b).transpose();
        tensor += term + term.transpose();
      }

    for (const auto &spring : network.angles)
      {
        const Eigen::VectorXd q = affine_change(network, spring);
        tensor += spring.stiffness * q * q.transpose();
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
