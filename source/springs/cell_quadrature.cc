#include <springfit/springs/cell_quadrature.h>

#include <cmath>
#include <map>

namespace springfit
{
  namespace
  {
    using Quadrature = std::vector<QuadraturePoint>;

    Quadrature
    simplex_quadrature(const int dim)
    {
      Eigen::MatrixXd gradients(dim, dim + 1);
      gradients.col(0).setConstant(-1.);
      gradients.rightCols(dim).setIdentity();
      return {{gradients, dim == 2 ? 1. / 2. : 1. / 6.}};
    }

    /**
     * Gauss' two points per direction: the Jacobian's determinant is of the
     * second degree in each of them.
     */
    Quadrature
    tensor_quadrature(const int dim)
    {
      const int n = 1 << dim;
      // Shape function v in direction e at point q, and its slope.
      const auto upper = [](const int v, const int e) { return v >> e & 1; };
      const auto value = [&](const int v, const int q, const int e) {
        const double xi = 0.5 + (upper(q, e) ? 0.5 : -0.5) / std::sqrt(3.);
        return upper(v, e) ? xi : 1. - xi;
      };
      const auto slope = [&](const int v, const int e) {
        return upper(v, e) ? 1. : -1.;
      };
      Quadrature quadrature;
      for (int q = 0; q < n; ++q)
        {
          Eigen::MatrixXd gradients(dim, n);
          for (int v = 0; v < n; ++v)
            for (int d = 0; d < dim; ++d)
              {
                gradients(d, v) = 1.;
                for (int e = 0; e < dim; ++e)
                  gradients(d, v) *= e == d ? slope(v, e) : value(v, q, e);
              }
          quadrature.push_back({gradients, 1. / n});
        }
      return quadrature;
    }
  } // namespace

  const std::vector<QuadraturePoint> &
  cell_quadrature(const CellKind kind)
  {
    static const std::map<CellKind, Quadrature> table = [] {
      std::map<CellKind, Quadrature> made;
      for (const auto &entry : cell_kind_words())
        {
          const int dim     = dimension(entry.first);
          made[entry.first] = is_simplex(entry.first) ? simplex_quadrature(dim)
                                                      : tensor_quadrature(dim);
        }
      return made;
    }();
    return table.at(kind);
  }
} // namespace springfit
