#include <springfit/fit/cell/stable_neo_hookean.h>
#include <springfit/springs/cell_quadrature.h>
#include <springfit/springs/point_volumes.h>
#include <springfit/springs/volumes.h>
#include <springfit/springs/zero_lengths.h>

#include <Eigen/LU>

#include <numeric>
#include <vector>

namespace springfit
{
  namespace
  {
    std::vector<unsigned int>
    vertices(const FitProblem &problem)
    {
      std::vector<unsigned int> nodes(problem.points.cols());
      std::iota(nodes.begin(), nodes.end(), 0);
      return nodes;
    }

    /** The integrals of grad N_a . grad N_b, n_nodes x n_nodes. */
    Eigen::MatrixXd
    integrals_of_gradients(const FitProblem &problem)
    {
      const Eigen::Index n = problem.points.cols();
      Eigen::MatrixXd W    = Eigen::MatrixXd::Zero(n, n);
      for (const auto &[gradients, weight] : cell_quadrature(problem.kind))
        {
          const Eigen::MatrixXd J = problem.points * gradients.transpose();
          const Eigen::MatrixXd g = J.transpose().inverse() * gradients;
          W += weight * J.determinant() * g.transpose() * g;
        }
      return W;
    }

    /** Lame's constants times the thickness, N/m in 2-d and Pa in 3-d. */
    struct LameConstants
    {
      explicit LameConstants(const FitProblem &problem)
        : lambda(problem.material.thickness *
                 first_lame_constant(problem.points.rows(), problem.material))
        , mu(problem.material.thickness * shear_modulus(problem.material))
      {}

      double lambda, mu;
    };

    Family
    springs(const FitProblem &problem)
    {
      const Eigen::MatrixXd W = integrals_of_gradients(problem);
      const double mu         = LameConstants(problem).mu;
      Family family(zero_lengths(problem.points.rows()));
      for (const auto &[a, b] : problem.springs)
        family.add({a, b}, {{-mu * W(a, b)}, {0.}});
      return family;
    }

    /** The numbers of volumes that are @p rest in the undeformed cell. */
    std::vector<std::vector<double>>
    quadratic(const FitProblem &problem, const std::vector<double> &rest)
    {
      const LameConstants lame(problem);
      const double alpha = 1. + lame.mu / (lame.lambda + lame.mu);
      std::vector<double> k, rest_volume;
      for (const double V : rest)
        {
          k.push_back((lame.lambda + lame.mu) / V);
          rest_volume.push_back(alpha * V);
        }
      return {k, rest_volume};
    }

    std::vector<std::vector<double>>
    logarithmic(const FitProblem &problem, const std::vector<double> &rest)
    {
      const LameConstants lame(problem);
      return {std::vector<double>(rest.size(), lame.mu),
              std::vector<double>(rest.size(), lame.lambda),
              rest};
    }

    Family
    of_cell(const FitProblem &problem,
            const SpringKind &kind,
            const std::vector<std::vector<double>> &numbers)
    {
      Family family(kind);
      family.add(vertices(problem), numbers);
      return family;
    }

    using KindOfVolumes = const SpringKind &(*)(CellKind);

    /** Volumes of the kind that the law and the material ask for. */
    Family
    under_pressure(const FitProblem &problem,
                   const VolumeLaw law,
                   const std::vector<double> &rest,
                   const KindOfVolumes of_quadratic_law,
                   const KindOfVolumes of_logarithmic_law,
                   const KindOfVolumes in_plane_stress)
    {
      if (law == VolumeLaw::quadratic)
        return of_cell(problem,
                       of_quadratic_law(problem.kind),
                       quadratic(problem, rest));
      return of_cell(problem,
                     problem.material.is_in_plane_stress
                       ? in_plane_stress(problem.kind)
                       : of_logarithmic_law(problem.kind),
                     logarithmic(problem, rest));
    }
  } // namespace

  CellModel
  fit_stable_neo_hookean_points(const FitProblem &problem, const VolumeLaw law)
  {
    if (is_simplex(problem.kind))
      return fit_stable_neo_hookean_volume(problem, law);
    return {{springs(problem),
             under_pressure(problem,
                            law,
                            spring_point_volumes(problem.points, problem.kind),
                            &point_volumes,
                            &logarithmic_point_volumes,
                            &logarithmic_point_areas_in_plane_stress)}};
  }

  CellModel
  fit_stable_neo_hookean_volume(const FitProblem &problem, const VolumeLaw law)
  {
    return {{springs(problem),
             under_pressure(problem,
                            law,
                            {spring_volume(problem.points, problem.kind)},
                            &volumes,
                            &logarithmic_volumes,
                            &logarithmic_areas_in_plane_stress)}};
  }


  FittedCell
  fit_stable_neo_hookean(const FitProblem &problem, const FitOptions &options)
  {
    return {options.enrichment == Enrichment::point_volumes
              ? fit_stable_neo_hookean_points(problem, options.volume_law)
              : fit_stable_neo_hookean_volume(problem, options.volume_law)};
  }
} // namespace springfit
