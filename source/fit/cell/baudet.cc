#include <springfit/fit/cell/baudet.h>
#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/fit/cell/regularity.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/volume.h>

#include <cmath>

namespace springfit
{
  namespace
  {
    /** The mean length of the edges along each axis of the reference cell. */
    Eigen::VectorXd
    edge_lengths(const Eigen::MatrixXd &points, const CellKind kind)
    {
      const int dim           = dimension(kind);
      Eigen::VectorXd lengths = Eigen::VectorXd::Zero(dim);
      for (const auto &pair : node_pairs(kind))
        if (const auto axis = edge_axis(pair))
          lengths[*axis] += (points.col(pair[1]) - points.col(pair[0])).norm();
      return lengths / (1 << (dim - 1));
    }

    Eigen::VectorXd
    fit_rectangle(const Eigen::MatrixXd &points,
                  const IsotropicMaterial &material)
    {
      const CellKind kind          = CellKind::quadrilateral;
      const Eigen::Array2d lengths = edge_lengths(points, kind);
      const Eigen::Array2d squares = lengths.square();
      const double nu              = material.poissons_ratio;
      const double factor = material.youngs_modulus * material.thickness /
                            (4. * lengths.prod() * (1. + nu));

      const auto &pairs = node_pairs(kind);
      Eigen::VectorXd k(pairs.size());
      for (Eigen::Index s = 0; s < k.size(); ++s)
        if (const auto axis = edge_axis(pairs[s]))
          k[s] =
            factor * (squares[1 - *axis] * (3. * nu + 2.) - squares[*axis]);
        else
          k[s] = factor * squares.sum();
      return k;
    }

    Eigen::VectorXd
    fit_cube(const Eigen::MatrixXd &points, const IsotropicMaterial &material)
    {
      const CellKind kind = CellKind::hexahedron;
      const double nu     = material.poissons_ratio;
      const double factor = material.youngs_modulus *
                            std::cbrt(volume(points, kind)) / (8. * (1. + nu));
      const auto &pairs = node_pairs(kind);
      Eigen::VectorXd k = Eigen::VectorXd::Zero(pairs.size());
      for (Eigen::Index s = 0; s < k.size(); ++s)
        if (edge_axis(pairs[s]))
          k[s] = factor * (4. * nu + 1.);
        else if ((pairs[s][0] ^ pairs[s][1]) == 7u) // opposite corners
          k[s] = factor * 3.;
      return k;
    }
  } // namespace


  Eigen::VectorXd
  fit_baudet(const Eigen::MatrixXd &points,
             const CellKind kind,
             const IsotropicMaterial &material)
  {
    return dimension(kind) == 2 ? fit_rectangle(points, material)
                                : fit_cube(points, material);
  }


  std::vector<LengthCoupling>
  baudet_couplings(const Eigen::MatrixXd &points,
                   const CellKind kind,
                   const IsotropicMaterial &material)
  {
    const int dim  = dimension(kind);
    const double c = material.youngs_modulus *
                     (dim == 2 ? 3. * material.poissons_ratio - 1.
                               : 4. * material.poissons_ratio - 1.) /
                     2.;
    // V c eps_a eps_b, eps_a the sum of n elongations / (n length_a)
    const Eigen::VectorXd lengths = edge_lengths(points, kind);
    const double n                = 1 << (dim - 1);
    const double V_c = c * material.thickness * volume(points, kind) / (n * n);

    const auto &pairs = node_pairs(kind);
    std::vector<LengthCoupling> couplings;
    for (unsigned int s = 0; s < pairs.size(); ++s)
      for (unsigned int t = s + 1; t < pairs.size(); ++t)
        {
          const auto a = edge_axis(pairs[s]), b = edge_axis(pairs[t]);
          if (a && b && *a != *b)
            couplings.push_back({s, t, V_c / (lengths[*a] * lengths[*b])});
        }
    return couplings;
  }


  std::vector<std::string>
  baudet_assumptions(const Eigen::MatrixXd &points,
                     const CellKind kind,
                     const IsotropicMaterial &)
  {
    if (kind == CellKind::quadrilateral)
      return is_rectangle(points) ? std::vector<std::string>{}
                                  : std::vector<std::string>{"rectangles"};
    return is_regular(points, kind)
             ? std::vector<std::string>{}
             : std::vector<std::string>{regular_cells(kind)};
  }


  FittedCell
  fit_baudet(const FitProblem &problem, const FitOptions &options)
  {
    const auto &points   = problem.points;
    const auto &material = problem.material;
    return {coupled_model(problem,
                          fit_baudet(points, problem.kind, material),
                          options.enrichment == Enrichment::coupling
                            ? baudet_couplings(points, problem.kind, material)
                            : std::vector<LengthCoupling>())};
  }
} // namespace springfit
