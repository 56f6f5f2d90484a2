#include <springfit/comparison/uniaxial_test.h>
#include <springfit/springs/rigid_modes.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace springfit
{
  namespace
  {
    /** In m^3: the divergence of the position is dim everywhere. */
    double
    volume(const Eigen::MatrixXd &points,
           const Eigen::MatrixXd &integrated_gradients)
    {
      return points.cwiseProduct(integrated_gradients).sum() / points.rows();
    }

    /**
     * The displacement of smallest norm with K u = f, dim x n_nodes, or
     * nothing when some of the force meets no resistance.
     */
    std::optional<Eigen::MatrixXd>
    displacement_without_supports(const Eigen::MatrixXd &stiffness,
                                  const Eigen::MatrixXd &points,
                                  const Eigen::MatrixXd &forces)
    {
      const Eigen::MatrixXd basis = deformation_basis(points);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        basis.transpose() * stiffness * basis);
      const double largest = eigen.eigenvalues().cwiseAbs().maxCoeff();

      Eigen::VectorXd f = eigen.eigenvectors().transpose() *
                          (basis.transpose() * forces.reshaped());
      const double f_norm = f.norm();
      for (Eigen::Index mode = 0; mode < f.size(); ++mode)
        {
          const double eigenvalue = eigen.eigenvalues()[mode];
          if (std::abs(eigenvalue) > 1e-10 * largest)
            f[mode] /= eigenvalue;
          else if (std::abs(f[mode]) > 1e-8 * f_norm)
            return {};
          else
            f[mode] = 0.;
        }
      const Eigen::VectorXd u = basis * (eigen.eigenvectors() * f);
      return Eigen::MatrixXd(u.reshaped(points.rows(), points.cols()));
    }
  } // namespace

  std::optional<YoungPoisson>
  uniaxial_test(const Eigen::MatrixXd &stiffness,
                const Eigen::MatrixXd &points,
                const Eigen::MatrixXd &integrated_gradients,
                const Eigen::VectorXd &axis)
  {
    // Of a stress as large as the stiffness, so that strains are of order one.
    const double stress = stiffness.cwiseAbs().maxCoeff() * points.norm() /
                          volume(points, integrated_gradients);
    const Eigen::MatrixXd forces =
      stress * axis * (axis.transpose() * integrated_gradients);
    const auto displacement =
      displacement_without_supports(stiffness, points, forces);
    if (!displacement)
      return {};

    const Eigen::MatrixXd gradient = *displacement *
                                     integrated_gradients.transpose() /
                                     volume(points, integrated_gradients);
    const double axial   = axis.dot(gradient * axis);
    const double lateral = (gradient.trace() - axial) / (axis.size() - 1);
    if (std::abs(axial) <= 1e-9 * gradient.norm())
      return {};
    return YoungPoisson{stress / axial, -lateral / axial};
  }

  ElasticityTensor
  affine_tensor(const Eigen::MatrixXd &stiffness,
                const Eigen::MatrixXd &points,
                const Eigen::MatrixXd &integrated_gradients)
  {
    // Column dim * i + j is the displacement u_i = x_j.
    const Eigen::Index dim = points.rows();
    Eigen::MatrixXd modes  = Eigen::MatrixXd::Zero(points.size(), dim * dim);
    for (Eigen::Index v = 0; v < points.cols(); ++v)
      for (Eigen::Index i = 0; i < dim; ++i)
        modes.block(dim * v + i, dim * i, 1, dim) = points.col(v).transpose();
    return modes.transpose() * stiffness * modes /
           volume(points, integrated_gradients);
  }
} // namespace springfit
