#include <springfit/core/error.h>
#include <springfit/fit/nonnegative_least_squares.h>
#include <springfit/fit/several_states.h>
#include <springfit/springs/network.h>
#include <springfit/springs/network_terms.h>
#include <springfit/springs/volume.h>

#include <numeric>
#include <vector>

namespace springfit
{
  namespace
  {
    /** The forces of a cell as a network of its own. */
    SpringNetwork
    network_of(const FitProblem &problem, const CellModel &model)
    {
      std::vector<unsigned int> nodes(problem.points.cols());
      std::iota(nodes.begin(), nodes.end(), 0);
      NetworkBuilder builder(problem.points);
      builder.add_springs(nodes, problem.springs, model.k);
      builder.add_couplings(nodes, problem.springs, model.couplings);
      if (model.angle_stiffness.size() > 0)
        builder.add_angles(nodes,
                           cell_angles(problem.kind),
                           model.angle_stiffness);
      if (model.volume_stiffness)
        builder.add_volume(nodes,
                           *model.volume_stiffness,
                           volume(problem.points, problem.kind));
      SpringNetwork network = builder.build();
      network.law           = problem.law;
      return network;
    }

    template <int dim>
    Eigen::MatrixXd
    tangent(const SpringNetwork &network, const Eigen::MatrixXd &displacement)
    {
      Eigen::MatrixXd K =
        Eigen::MatrixXd::Zero(displacement.size(), displacement.size());
      for (unsigned int t = 0; t < n_terms(network); ++t)
        {
          const auto term = evaluate_term<dim>(network, t, displacement);
          if (!term)
            throw RunError("in one of the 'States' a length is zero or an "
                           "angle straight or folded.",
                           "Name smaller deformations.");
          const auto &nodes = term->nodes;
          for (std::size_t a = 0; a < nodes.size(); ++a)
            for (std::size_t b = 0; b < nodes.size(); ++b)
              K.block<dim, dim>(dim * nodes[a], dim * nodes[b]) +=
                term->hessian.template block<dim, dim>(dim * a, dim * b);
        }
      return K;
    }

    std::vector<DeformedState>
    all_states(const FitProblem &problem)
    {
      std::vector<DeformedState> states = problem.states;
      states.insert(states.begin(),
                    {Eigen::MatrixXd::Zero(problem.points.rows(),
                                           problem.points.cols()),
                     problem.stiffness});
      return states;
    }

    /** The entries of K(x_p), of all states one below the other. */
    Eigen::VectorXd
    stacked_tangents(const FitProblem &problem, const CellModel &model)
    {
      const auto states    = all_states(problem);
      const Eigen::Index n = problem.stiffness.size();
      Eigen::VectorXd entries(n * states.size());
      for (std::size_t p = 0; p < states.size(); ++p)
        entries.segment(n * p, n) =
          tangent(problem, model, states[p].displacement).reshaped();
      return entries;
    }

    /** The same of R(x_p). */
    Eigen::VectorXd
    stacked_references(const FitProblem &problem)
    {
      const auto states    = all_states(problem);
      const Eigen::Index n = problem.stiffness.size();
      Eigen::VectorXd entries(n * states.size());
      for (std::size_t p = 0; p < states.size(); ++p)
        entries.segment(n * p, n) = states[p].stiffness.reshaped();
      return entries;
    }

    /**
     * The constants c of models that are to be added up, each given with a
     * constant of one.
     */
    Eigen::VectorXd
    fit_models(const FitProblem &problem,
               const std::vector<CellModel> &models,
               const Eigen::Index n_nonnegative)
    {
      const Eigen::VectorXd d = stacked_references(problem);
      Eigen::MatrixXd A(d.size(), models.size());
      for (std::size_t m = 0; m < models.size(); ++m)
        A.col(m) = stacked_tangents(problem, models[m]);
      return nonnegative_least_squares(A.transpose() * A,
                                       A.transpose() * d,
                                       n_nonnegative);
    }
  } // namespace

  Eigen::MatrixXd
  tangent(const FitProblem &problem,
          const CellModel &model,
          const Eigen::MatrixXd &displacement)
  {
    const SpringNetwork network = network_of(problem, model);
    return displacement.rows() == 2 ? tangent<2>(network, displacement)
                                    : tangent<3>(network, displacement);
  }


  double
  residual_over_states(const FitProblem &problem, const CellModel &model)
  {
    const Eigen::VectorXd R = stacked_references(problem);
    return (R - stacked_tangents(problem, model)).norm() / R.norm();
  }


  CellModel
  fit_over_states(const FitProblem &problem,
                  const CellTerms &terms,
                  const Eigen::Index n_nonnegative)
  {
    const Eigen::Index n = terms.norms.size();
    std::vector<CellModel> models;
    for (Eigen::Index m = 0; m < n; ++m)
      models.push_back(make_cell_model(terms, Eigen::VectorXd::Unit(n, m)));
    return make_cell_model(terms, fit_models(problem, models, n_nonnegative));
  }


  CellModel
  fit_coupled_over_states(const FitProblem &problem,
                          const Eigen::Index n_nonnegative)
  {
    const unsigned int n = problem.springs.size();
    std::vector<CellModel> models;
    for (unsigned int s = 0; s < n; ++s)
      models.push_back({Eigen::VectorXd::Unit(n, s)});
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = a + 1; b < n; ++b)
        models.push_back({Eigen::VectorXd::Zero(n), {{a, b, 1.}}});

    const Eigen::VectorXd c = fit_models(problem, models, n_nonnegative);
    CellModel model{c.head(n)};
    for (Eigen::Index m = n; m < c.size(); ++m)
      {
        model.couplings.push_back(models[m].couplings.front());
        model.couplings.back().stiffness = c[m];
      }
    return model;
  }
} // namespace springfit
