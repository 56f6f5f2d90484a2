#include <springfit/comparison/homogenised_tensor.h>

#include <Eigen/LU>

#include <cmath>

namespace springfit
{
  ElasticityTensor
  homogenised_tensor(const SpringNetwork &network, const double volume)
  {
    const Eigen::Index dim = network.nodes.rows();
    // u_i = x_j for the displacement gradient (i, j), by its columns.
    Eigen::MatrixXd affine =
      Eigen::MatrixXd::Zero(network.nodes.size(), dim * dim);
    const Eigen::MatrixXd x =
      network.nodes.colwise() - network.nodes.rowwise().mean();
    for (Eigen::Index v = 0; v < x.cols(); ++v)
      for (Eigen::Index i = 0; i < dim; ++i)
        for (Eigen::Index j = 0; j < dim; ++j)
          affine(dim * v + i, dim * i + j) = x(j, v);
    return affine.transpose() *
           (tangent(network.families, network.nodes) * affine) / volume;
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
