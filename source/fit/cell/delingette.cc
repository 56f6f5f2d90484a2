#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/fit/cell/delingette.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/volume.h>

#include <Eigen/LU>

namespace springfit
{
  namespace
  {
    struct Triangle
    {
      Eigen::Vector3d length;             // of each spring
      Eigen::Vector3d opposite_cotangent; // of the angle opposite to it
      double lambda_plus_M;               // times h / (8 A)
      double M;                           // times h / (8 A)
    };

    Triangle
    triangle(const Eigen::MatrixXd &points, const IsotropicMaterial &material)
    {
      const double area   = volume(points, CellKind::triangle);
      const double nu     = material.poissons_ratio;
      const double factor = material.youngs_modulus * material.thickness /
                            ((1. - nu * nu) * 8. * area);
      // lambda + M = E / (1 - nu^2)
      Triangle triangle{{}, {}, factor, factor * (1. - nu)};
      const auto &pairs = node_pairs(CellKind::triangle);
      for (unsigned int s = 0; s < 3; ++s)
        {
          const auto [i, j]              = pairs[s];
          const unsigned int opposite    = 3 - i - j;
          const Eigen::Vector2d to_i     = points.col(i) - points.col(opposite);
          const Eigen::Vector2d to_j     = points.col(j) - points.col(opposite);
          triangle.length[s]             = (to_j - to_i).norm();
          triangle.opposite_cotangent[s] = to_i.dot(to_j) / (2. * area);
        }
      return triangle;
    }
  } // namespace


  Eigen::VectorXd
  fit_delingette(const Eigen::MatrixXd &points,
                 const IsotropicMaterial &material)
  {
    const Triangle t = triangle(points, material);
    return t.length.array().square() *
           (2. * t.lambda_plus_M * t.opposite_cotangent.array().square() + t.M);
  }


  std::vector<LengthCoupling>
  delingette_couplings(const Eigen::MatrixXd &points,
                       const IsotropicMaterial &material)
  {
    const Triangle t = triangle(points, material);
    std::vector<LengthCoupling> couplings;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = a + 1; b < 3; ++b)
        couplings.push_back({a,
                             b,
                             t.length[a] * t.length[b] *
                               (2. * t.lambda_plus_M * t.opposite_cotangent[a] *
                                  t.opposite_cotangent[b] -
                                t.M)});
    return couplings;
  }


  FittedCell
  fit_delingette(const FitProblem &problem, const FitOptions &options)
  {
    return {
      coupled_model(problem,
                    fit_delingette(problem.points, problem.material),
                    options.enrichment == Enrichment::coupling
                      ? delingette_couplings(problem.points, problem.material)
                      : std::vector<LengthCoupling>())};
  }
} // namespace springfit
