#include <springfit/core/error.h>
#include <springfit/fit/cell/cell_terms.h>
#include <springfit/springs/gradients.h>
#include <springfit/springs/rest_families.h>
#include <springfit/springs/volume.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    Eigen::MatrixXd
    gradients_of(const FitProblem &problem, const Enrichment enrichment)
    {
      switch (enrichment)
        {
          case Enrichment::none:
            return Eigen::MatrixXd(problem.gradients.rows(), 0);
          case Enrichment::volume:
            return volume_gradient(problem.points, problem.kind);
          case Enrichment::angles:
            return angle_gradients(problem.points, cell_angles(problem.kind));
          case Enrichment::point_volumes:
          case Enrichment::coupling:
            break;
        }
      throw std::logic_error("an enrichment has no terms of rank one");
    }

    void
    check_volume(const FitProblem &problem)
    {
      const double size =
        (problem.points.colwise() - problem.points.rowwise().mean())
          .colwise()
          .norm()
          .maxCoeff();
      const double V = volume(problem.points, problem.kind);
      if (!(std::abs(V) > 1e-12 * std::pow(size, problem.points.rows())))
        throw RunError("its volume is zero, and so has no gradient.",
                       "Improve the mesh there.");
    }
  } // namespace

  CellTerms
  make_cell_terms(const FitProblem &problem, const Enrichment enrichment)
  {
    if (enrichment == Enrichment::volume)
      check_volume(problem);

    const Eigen::MatrixXd &springs = problem.gradients;
    const Eigen::MatrixXd others   = gradients_of(problem, enrichment);

    CellTerms terms;
    terms.unit      = unit_families(problem, enrichment);
    terms.n_springs = springs.cols();
    terms.norms     = Eigen::VectorXd::Ones(springs.cols() + others.cols());
    terms.norms.tail(others.cols()) = others.colwise().norm();
    terms.gradients.resize(springs.rows(), terms.norms.size());
    terms.gradients << springs, others.colwise().normalized();
    return terms;
  }


  Families
  unit_families(const FitProblem &problem, const Enrichment enrichment)
  {
    const auto ones = [](const std::size_t n) -> Eigen::VectorXd {
      return Eigen::VectorXd::Ones(n);
    };
    Families families = {lengths_at_rest(problem.points,
                                         problem.springs,
                                         ones(problem.springs.size()),
                                         problem.law)};
    switch (enrichment)
      {
        case Enrichment::none:
          break;
        case Enrichment::volume:
          families.push_back(volume_at_rest(problem.points, problem.kind, 1.));
          break;
        case Enrichment::point_volumes:
          throw std::logic_error("points of a cell have no volumes at rest");
          case Enrichment::angles: {
            const auto &triples = cell_angles(problem.kind);
            families.push_back(
              angles_at_rest(problem.points, triples, ones(triples.size())));
            break;
          }
          case Enrichment::coupling: {
            std::vector<LengthCoupling> couplings;
            for (unsigned int a = 0; a < problem.springs.size(); ++a)
              for (unsigned int b = a + 1; b < problem.springs.size(); ++b)
                couplings.push_back({a, b, 1.});
            families.push_back(couplings_at_rest(
              problem.points, problem.springs, couplings, problem.law));
            break;
          }
      }
    return families;
  }


  CellModel
  make_cell_model(const CellTerms &terms, const Eigen::VectorXd &constants)
  {
    const Eigen::VectorXd stiffness =
      constants.cwiseQuotient(terms.norms.cwiseAbs2());
    return {with_constants(terms.unit, stiffness)};
  }
} // namespace springfit
