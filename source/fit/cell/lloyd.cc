#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/fit/cell/lloyd.h>
#include <springfit/fit/cell/regularity.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/volume.h>

#include <cmath>

namespace springfit
{
  Eigen::VectorXd
  fit_lloyd(const Eigen::MatrixXd &points,
            const CellKind kind,
            const IsotropicMaterial &material)
  {
    const auto &pairs = node_pairs(kind);
    const double E_h  = material.youngs_modulus * material.thickness;
    Eigen::VectorXd k(pairs.size());
    switch (kind)
      {
        case CellKind::triangle:
          k.setConstant(std::sqrt(3.) / 4. * E_h);
          break;
        case CellKind::quadrilateral:
          for (Eigen::Index s = 0; s < k.size(); ++s)
            k[s] = (edge_axis(pairs[s]) ? 5. / 16. : 7. / 16.) * E_h;
          break;
          default: {
            const double l =
              std::cbrt(12. / std::sqrt(2.) * volume(points, kind));
            k.setConstant(2. * std::sqrt(2.) / 25. * E_h * l);
          }
      }
    return k;
  }


  std::vector<std::string>
  lloyd_assumptions(const Eigen::MatrixXd &points,
                    const CellKind kind,
                    const IsotropicMaterial &material)
  {
    std::vector<std::string> missed;
    const bool plane = dimension(kind) == 2;
    if (std::abs(material.poissons_ratio - (plane ? 1. / 3. : 1. / 4.)) > 0.01)
      missed.emplace_back(plane ? "Poisson's ratio 1/3 (1/4 in plane strain)"
                                : "Poisson's ratio 1/4");
    if (!is_regular(points, kind))
      missed.emplace_back(regular_cells(kind));
    return missed;
  }


  FittedCell
  fit_lloyd(const FitProblem &problem, const FitOptions &)
  {
    return {coupled_model(
      problem, fit_lloyd(problem.points, problem.kind, problem.material), {})};
  }
} // namespace springfit
