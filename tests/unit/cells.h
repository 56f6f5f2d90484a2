#ifndef springfit_tests_unit_cells_h
#define springfit_tests_unit_cells_h

// Cells and their stiffness, written independently of the program: what the
// unit tests and the benchmarks compare with.

#include <springfit/core/cell_kind.h>
#include <springfit/fit/problem.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>
#include <vector>

namespace springfit::oracle
{
  inline const std::vector<CellKind> all_kinds = {CellKind::triangle,
                                                  CellKind::quadrilateral,
                                                  CellKind::tetrahedron,
                                                  CellKind::hexahedron};

  // Elasticity matrices in Voigt's notation, engineering shear strains last,
  // E = 1.

  inline Eigen::MatrixXd
  isotropic(const unsigned int dim, const double lambda, const double mu)
  {
    const unsigned int n = dim * (dim + 1) / 2;
    Eigen::MatrixXd D    = Eigen::MatrixXd::Zero(n, n);
    D.topLeftCorner(dim, dim).setConstant(lambda);
    D.diagonal().head(dim).array() += 2. * mu;
    D.diagonal().tail(n - dim).setConstant(mu);
    return D;
  }

  inline Eigen::MatrixXd
  plane_stress(const double nu)
  {
    return isotropic(2, nu / (1. - nu * nu), 0.5 / (1. + nu));
  }

  inline Eigen::MatrixXd
  plane_strain(const double nu)
  {
    return isotropic(2, nu / ((1. + nu) * (1. - 2. * nu)), 0.5 / (1. + nu));
  }

  inline Eigen::MatrixXd
  solid(const double nu)
  {
    return isotropic(3, nu / ((1. + nu) * (1. - 2. * nu)), 0.5 / (1. + nu));
  }

  /** Plane stress in 2-d. */
  inline Eigen::MatrixXd
  usual_elasticity(const CellKind kind, const double nu)
  {
    return dimension(kind) == 2 ? plane_stress(nu) : solid(nu);
  }

  /** Strain of nodal displacements, from the shape functions' gradients. */
  inline Eigen::MatrixXd
  strain_matrix(const Eigen::MatrixXd &gradients /* dim x n_nodes */)
  {
    const int dim = gradients.rows();
    Eigen::MatrixXd B =
      Eigen::MatrixXd::Zero(dim * (dim + 1) / 2, gradients.size());
    for (int v = 0; v < gradients.cols(); ++v)
      {
        int row = 0;
        for (; row < dim; ++row)
          B(row, dim * v + row) = gradients(row, v);
        for (int a = 0; a < dim; ++a)
          for (int b = a + 1; b < dim; ++b, ++row)
            {
              B(row, dim * v + a) = gradients(b, v);
              B(row, dim * v + b) = gradients(a, v);
            }
      }
    return B;
  }

  /** P1 in closed form. */
  inline Eigen::MatrixXd
  simplex_stiffness(const Eigen::MatrixXd &points, const Eigen::MatrixXd &D)
  {
    const int dim           = points.rows();
    const Eigen::MatrixXd J = points.rightCols(dim).colwise() - points.col(0);
    Eigen::MatrixXd gradients(dim, dim + 1);
    gradients.rightCols(dim) = J.inverse().transpose();
    gradients.col(0)         = -gradients.rightCols(dim).rowwise().sum();
    const double measure     = std::abs(J.determinant()) / (dim == 2 ? 2. : 6.);
    const Eigen::MatrixXd B  = strain_matrix(gradients);
    return measure * B.transpose() * D * B;
  }

  /** Q1 by Gauss' quadrature, two points per direction. */
  inline Eigen::MatrixXd
  tensor_stiffness(const Eigen::MatrixXd &points, const Eigen::MatrixXd &D)
  {
    const int dim     = points.rows();
    const int n       = 1 << dim;
    Eigen::MatrixXd R = Eigen::MatrixXd::Zero(dim * n, dim * n);
    for (int q = 0; q < n; ++q)
      {
        Eigen::MatrixXd reference(dim, n); // d N_v / d xi_d
        for (int v = 0; v < n; ++v)
          for (int d = 0; d < dim; ++d)
            {
              double product = 1.;
              for (int e = 0; e < dim; ++e)
                {
                  const double xi =
                    0.5 + (q >> e & 1 ? 0.5 : -0.5) / std::sqrt(3.);
                  const bool upper = v >> e & 1;
                  if (e == d)
                    product *= upper ? 1. : -1.;
                  else
                    product *= upper ? xi : 1. - xi;
                }
              reference(d, v) = product;
            }
        const Eigen::MatrixXd J = points * reference.transpose();
        const Eigen::MatrixXd B =
          strain_matrix(J.inverse().transpose() * reference);
        R += std::abs(J.determinant()) / n * B.transpose() * D * B;
      }
    return R;
  }

  inline Eigen::MatrixXd
  stiffness(const Eigen::MatrixXd &points,
            const CellKind kind,
            const Eigen::MatrixXd &D)
  {
    return is_simplex(kind) ? simplex_stiffness(points, D)
                            : tensor_stiffness(points, D);
  }

  /** Equilateral triangle, square, regular tetrahedron, cube; all edges 1. */
  inline Eigen::MatrixXd
  regular_cell(const CellKind kind)
  {
    const int dim = dimension(kind);
    Eigen::MatrixXd points(dim, n_vertices(kind));
    if (kind == CellKind::triangle)
      points << 0., 1., 0.5, //
        0., 0., std::sqrt(3.) / 2.;
    else if (kind == CellKind::tetrahedron)
      points << 0., 1., 0.5, 0.5,                       //
        0., 0., std::sqrt(3.) / 2., std::sqrt(3.) / 6., //
        0., 0., 0., std::sqrt(2. / 3.);
    else
      for (int v = 0; v < points.cols(); ++v)
        for (int d = 0; d < dim; ++d)
          points(d, v) = v >> d & 1;
    return points;
  }

  /** Numbers in [0, 1) that are the same with every standard library. */
  class Random
  {
  public:
    explicit Random(const unsigned int seed) : engine_(seed)
    {}

    double
    operator()()
    {
      return engine_() / 4294967296.;
    }

    double
    operator()(const double low, const double high)
    {
      return low + (high - low) * (*this)();
    }

    Eigen::MatrixXd
    matrix(const int n_rows, const int n_columns)
    {
      Eigen::MatrixXd m(n_rows, n_columns);
      for (int j = 0; j < n_columns; ++j)
        for (int i = 0; i < n_rows; ++i)
          m(i, j) = (*this)(-1., 1.);
      return m;
    }

    /** A proper rotation. */
    Eigen::MatrixXd
    rotation(const int dim)
    {
      Eigen::MatrixXd Q =
        Eigen::HouseholderQR<Eigen::MatrixXd>(matrix(dim, dim)).householderQ();
      if (Q.determinant() < 0.)
        Q.col(0) *= -1.;
      return Q;
    }

  private:
    std::mt19937 engine_;
  };

  /** Every coordinate moved by up to 20 % of the edge. */
  inline Eigen::MatrixXd
  random_cell(const CellKind kind, Random &random)
  {
    const Eigen::MatrixXd regular = regular_cell(kind);
    return regular + 0.2 * random.matrix(regular.rows(), regular.cols());
  }

  inline FitProblem
  fit_problem(const Eigen::MatrixXd &points,
              const CellKind kind,
              const double nu)
  {
    return make_fit_problem(points,
                            kind,
                            stiffness(points, kind, usual_elasticity(kind, nu)),
                            {1., nu, 1.});
  }

  /** A random cell with nu in 0 .. 0.45. */
  inline FitProblem
  random_problem(const CellKind kind, Random &random)
  {
    const Eigen::MatrixXd points = random_cell(kind, random);
    return fit_problem(points, kind, random(0., 0.45));
  }
} // namespace springfit::oracle

#endif
