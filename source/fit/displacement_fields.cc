#include <springfit/fit/displacement_fields.h>

#include <cmath>

namespace springfit
{
  namespace
  {
    Eigen::MatrixXd
    unit_coordinates(const Eigen::MatrixXd &nodes)
    {
      const Eigen::MatrixXd x = nodes.colwise() - nodes.rowwise().mean();
      return x / x.cwiseAbs().maxCoeff();
    }

    Eigen::VectorXd
    flat(const Eigen::MatrixXd &nodal)
    {
      return Eigen::Map<const Eigen::VectorXd>(nodal.data(), nodal.size());
    }
  } // namespace

  Eigen::MatrixXd
  affine_fields(const Eigen::MatrixXd &nodes)
  {
    const Eigen::MatrixXd x = unit_coordinates(nodes);
    const Eigen::Index dim  = x.rows();
    Eigen::MatrixXd fields(x.size(), dim * (dim + 1) / 2);
    Eigen::Index shear = dim;
    for (Eigen::Index a = 0; a < dim; ++a)
      for (Eigen::Index b = a; b < dim; ++b)
        {
          const double weight = a == b ? 0.5 : std::sqrt(0.5);
          Eigen::MatrixXd u   = Eigen::MatrixXd::Zero(dim, x.cols());
          u.row(a) += weight * x.row(b);
          u.row(b) += weight * x.row(a);
          fields.col(a == b ? a : shear++) = flat(u);
        }
    return fields;
  }

  Eigen::MatrixXd
  quadratic_fields(const Eigen::MatrixXd &nodes)
  {
    const Eigen::MatrixXd x = unit_coordinates(nodes);
    const Eigen::Index dim  = x.rows();
    Eigen::MatrixXd fields(x.size(), dim * dim * (dim + 1) / 2);
    Eigen::Index f = 0;
    for (Eigen::Index a = 0; a < dim; ++a)
      for (Eigen::Index b = a; b < dim; ++b)
        for (Eigen::Index d = 0; d < dim; ++d)
          {
            Eigen::MatrixXd u = Eigen::MatrixXd::Zero(dim, x.cols());
            u.row(d) =
              (a == b ? 1. : std::sqrt(2.)) * x.row(a).cwiseProduct(x.row(b));
            fields.col(f++) = flat(u);
          }
    return fields;
  }
} // namespace springfit
