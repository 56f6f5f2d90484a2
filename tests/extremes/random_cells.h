#ifndef springfit_tests_extremes_random_cells_h
#define springfit_tests_extremes_random_cells_h

// Cells as bad as meshes have them, of materials as odd as there are.

#include <springfit/fit/problem.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <string>

#include "../unit/cells.h"

namespace springfit::oracle
{
  /** A cell to fit, and how it was made. */
  struct ExtremeCell
  {
    FitProblem problem;
    std::string description;
  };

  /** The smallest of det J at the corners, relative to the edges there. */
  inline double
  smallest_corner(const Eigen::MatrixXd &points, const CellKind kind)
  {
    const int dim = points.rows();
    double least  = 1.;
    const int n   = points.cols();
    for (int v = 0; v < n; ++v)
      {
        Eigen::MatrixXd edges(dim, dim);
        if (is_simplex(kind))
          // An even order of the others, so that signs are those of the cell.
          for (int d = 0, w = 0; w < n; ++w)
            {
              if (w != v)
                edges.col(d++) = points.col(w) - points.col(v);
            }
        else
          for (int d = 0; d < dim; ++d)
            edges.col(d) = (v >> d & 1 ? -1. : 1.) *
                           (points.col(v ^ (1 << d)) - points.col(v));
        double determinant = edges.determinant();
        if (is_simplex(kind) && v % 2 == 1)
          determinant = -determinant;
        least = std::min(least, determinant / edges.colwise().norm().prod());
      }
    return least;
  }

  inline double
  log_uniform(Random &random, const double low, const double high)
  {
    return std::exp(random(std::log(low), std::log(high)));
  }

  /** Of edges about 1, positive det J at every corner. */
  inline Eigen::MatrixXd
  extreme_points(const CellKind kind, Random &random, std::string &description)
  {
    const int dim = dimension(kind);
    for (;;)
      {
        Eigen::MatrixXd x  = regular_cell(kind);
        const double share = random();
        if (share < 0.5)
          {
            description = "distorted";
            x += random(0., 0.45) * random.matrix(dim, x.cols());
          }
        else if (share < 0.75)
          {
            description = "stretched";
            x += random(0., 0.2) * random.matrix(dim, x.cols());
            x.row(dim - 1) /= log_uniform(random, 1., 1e4);
          }
        else
          {
            // The whole cell leans until its angles are as small as that, or
            // it is flattened between two of its edges.
            description        = "sliver";
            const double angle = log_uniform(random, 0.1, 30.) * M_PI / 180.;
            x += random(0., 0.05) * random.matrix(dim, x.cols());
            if (kind == CellKind::tetrahedron && random() < 0.5)
              {
                x << 0., 1., 1., 0., //
                  0., 0., 1., 1.,    //
                  0., std::tan(angle), 0., std::tan(angle);
                x += 0.2 * std::tan(angle) * random.matrix(dim, x.cols());
              }
            else
              {
                x.row(0) += std::cos(angle) * x.row(dim - 1);
                x.row(dim - 1) *= std::sin(angle);
              }
          }
        if (smallest_corner(x, kind) < 0.)
          x.row(0) *= -1.;
        if (smallest_corner(x, kind) > 0. &&
            (!is_simplex(kind) || smallest_corner(x, kind) > 1e-7))
          return random.rotation(dim) * x;
      }
  }

  /**
   * nu from -0.99 to 0.4999, E from 1e-3 to 1e12 Pa, edges of 1e-6 to 1e3 m;
   * plane stress and plane strain.
   */
  inline ExtremeCell
  extreme_cell(Random &random)
  {
    const CellKind kind = all_kinds[static_cast<int>(4. * random())];
    const int dim       = dimension(kind);
    ExtremeCell cell;
    Eigen::MatrixXd points = extreme_points(kind, random, cell.description);
    points *= log_uniform(random, 1e-6, 1e3);

    const double modulus = log_uniform(random, 1e-3, 1e12);
    const double share   = random();
    const double nu      = share < 0.2   ? 0.5 - log_uniform(random, 1e-4, 0.1)
                           : share < 0.4 ? -1. + log_uniform(random, 1e-2, 0.5)
                                         : random(0., 0.45);
    const bool is_in_plane_stress = dim == 2 && random() < 0.5;
    const double mu               = modulus / (2. * (1. + nu));
    const double lambda           = is_in_plane_stress
                                      ? modulus * nu / (1. - nu * nu)
                                      : modulus * nu / ((1. + nu) * (1. - 2. * nu));
    const double thickness = dim == 2 ? log_uniform(random, 1e-6, 1e3) : 1.;
    auto material          = isotropic_material(dim, lambda, mu, thickness);
    material.is_in_plane_stress = is_in_plane_stress;
    cell.problem =
      make_fit_problem(points,
                       kind,
                       thickness *
                         stiffness(points, kind, isotropic(dim, lambda, mu)),
                       material);
    return cell;
  }
} // namespace springfit::oracle

#endif
