#include <springfit/springs/rigid_modes.h>

#include <Eigen/QR>

namespace springfit
{
  namespace
  {
    /** Centred and of size one: modes of like magnitude. */
    Eigen::MatrixXd
    normalised(const Eigen::MatrixXd &points)
    {
      const Eigen::MatrixXd x = points.colwise() - points.rowwise().mean();
      return x / x.cwiseAbs().maxCoeff();
    }

    /** Translations, then infinitesimal rotations about the centre. */
    Eigen::MatrixXd
    rigid_modes(const Eigen::MatrixXd &points)
    {
      const Eigen::Index dim         = points.rows();
      const Eigen::Index n_nodes     = points.cols();
      const Eigen::Index n_rotations = dim * (dim - 1) / 2;
      const Eigen::MatrixXd x        = normalised(points);

      Eigen::MatrixXd modes =
        Eigen::MatrixXd::Zero(dim * n_nodes, dim + n_rotations);
      for (Eigen::Index v = 0; v < n_nodes; ++v)
        {
          modes.block(dim * v, 0, dim, dim).setIdentity();
          Eigen::Index column = dim;
          for (Eigen::Index a = 0; a < dim; ++a)
            for (Eigen::Index b = a + 1; b < dim; ++b, ++column)
              {
                modes(dim * v + a, column) = -x(b, v);
                modes(dim * v + b, column) = x(a, v);
              }
        }
      return modes;
    }

    /** The rigid motions, then stretches along the axes and shears. */
    Eigen::MatrixXd
    affine_modes(const Eigen::MatrixXd &points)
    {
      const Eigen::Index dim      = points.rows();
      const Eigen::MatrixXd rigid = rigid_modes(points);
      const Eigen::MatrixXd x     = normalised(points);

      Eigen::MatrixXd modes =
        Eigen::MatrixXd::Zero(rigid.rows(), dim + dim * dim);
      modes.leftCols(rigid.cols()) = rigid;
      Eigen::Index column          = rigid.cols();
      for (Eigen::Index a = 0; a < dim; ++a)
        for (Eigen::Index b = a; b < dim; ++b, ++column)
          for (Eigen::Index v = 0; v < points.cols(); ++v)
            {
              modes(dim * v + a, column) = x(b, v);
              modes(dim * v + b, column) = x(a, v);
            }
      return modes;
    }

    /** Columns @p first .. @p first + @p n of the orthonormal factor of modes.
     */
    Eigen::MatrixXd
    orthonormal_columns(const Eigen::MatrixXd &modes,
                        const Eigen::Index first,
                        const Eigen::Index n)
    {
      const Eigen::HouseholderQR<Eigen::MatrixXd> qr(modes);
      Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(modes.rows(), n);
      columns.block(first, 0, n, n).setIdentity();
      columns.applyOnTheLeft(qr.householderQ());
      return columns;
    }
  } // namespace

  Eigen::MatrixXd
  rigid_body_modes(const Eigen::MatrixXd &points)
  {
    const Eigen::MatrixXd modes = rigid_modes(points);
    return orthonormal_columns(modes, 0, modes.cols());
  }

  Eigen::MatrixXd
  deformation_basis(const Eigen::MatrixXd &points)
  {
    const Eigen::MatrixXd modes = rigid_modes(points);
    return orthonormal_columns(modes,
                               modes.cols(),
                               modes.rows() - modes.cols());
  }

  Eigen::MatrixXd
  affine_basis(const Eigen::MatrixXd &points)
  {
    const Eigen::MatrixXd modes = affine_modes(points);
    const Eigen::Index n_rigid  = rigid_modes(points).cols();
    return orthonormal_columns(modes, n_rigid, modes.cols() - n_rigid);
  }

  Eigen::MatrixXd
  hourglass_basis(const Eigen::MatrixXd &points)
  {
    const Eigen::MatrixXd modes = affine_modes(points);
    return orthonormal_columns(modes,
                               modes.cols(),
                               modes.rows() - modes.cols());
  }
} // namespace springfit
