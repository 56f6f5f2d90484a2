#include <springfit/motion/iterative_step_system.h>
#include <springfit/motion/step_matrix.h>
#include <springfit/motion/step_preconditioner.h>
#include <springfit/motion/step_systems.h>
#include <springfit/springs/tangent_matrix.h>

#include <Eigen/Eigenvalues>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <sstream>
#include <vector>

namespace springfit
{
  namespace
  {
    // Up to this fill factors are as fast as a V cycle, whose iterations are
    // several times as many: tests/benchmarks/step_benchmark.cc has the times.
    constexpr double little_fill = 2.;

    // Up to this fill the factors of a matrix that stays are faster than a V
    // cycle: one or two iterations take the place of a dozen.
    constexpr double much_fill = 15.;

    // New factors for each step are as fast as iterations with kept ones if
    // they take no longer than so many solutions, which is about as many
    // iterations, where nodes resist alike in all directions and where they do
    // not.
    constexpr double few_solutions = 5., many_solutions = 50.;

    // Of the least and the largest resistance of a node: below it no single
    // number stands for both, as of membranes, which hardly resist across
    // themselves.
    constexpr double isotropic = 0.05;

    /** Of the median node at rest; 1: it resists alike in all directions. */
    double
    isotropy(const int dim, const MovingBody &body)
    {
      TangentMatrix tangent(dim, step_pattern(body));
      body.elastic->add_tangent(Eigen::MatrixXd::Zero(dim, body.mass.size()),
                                tangent);
      std::vector<double> ratios;
      for (Eigen::Index v = 0; v < body.mass.size(); ++v)
        {
          const Eigen::MatrixXd block =
            tangent.matrix().block(dim * v, dim * v, dim, dim);
          const Eigen::VectorXd eigenvalues =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
              block, Eigen::EigenvaluesOnly)
              .eigenvalues();
          ratios.push_back(eigenvalues[dim - 1] > 0.
                             ? eigenvalues[0] / eigenvalues[dim - 1]
                             : 1.);
        }
      std::nth_element(ratios.begin(),
                       ratios.begin() + ratios.size() / 2,
                       ratios.end());
      return ratios[ratios.size() / 2];
    }

    /** The nodes that have entries in common, as a matrix of ones. */
    Eigen::SparseMatrix<double>
    graph_of(const MovingBody &body)
    {
      NodePattern pattern(body.mass.size());
      body.elastic->add_to_pattern(pattern);
      const auto neighbours = pattern.neighbours();
      std::vector<Eigen::Triplet<double>> entries;
      for (std::size_t v = 0; v < neighbours.size(); ++v)
        {
          entries.emplace_back(v, v, neighbours[v].size() + 1.);
          for (const unsigned int w : neighbours[v])
            if (w != v)
              entries.emplace_back(w, v, -1.);
        }
      Eigen::SparseMatrix<double> graph(neighbours.size(), neighbours.size());
      graph.setFromTriplets(entries.begin(), entries.end());
      return graph;
    }

    /** Counts the entries of factors without computing them. */
    struct SymbolicFactors : Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>
    {
      /** By column, below the diagonal. */
      Eigen::ArrayXd
      n_entries() const
      {
        return m_nonZerosPerCol.cast<double>();
      }
    };

    /** What factors cost, in blocks of two nodes. */
    struct CostOfFactors
    {
      /** Their entries relative to those of half the matrix. */
      double fill;

      /** Products to make them, for each that solves with them. */
      double effort;
    };

    CostOfFactors
    cost_of_factors(const Eigen::SparseMatrix<double> &graph)
    {
      SymbolicFactors factors;
      factors.analyzePattern(graph);
      const Eigen::ArrayXd n = factors.n_entries();
      const double n_entries = n.sum() + n.size();
      return {n_entries / (0.5 * (graph.nonZeros() + graph.cols())),
              0.5 * (n * (n + 1.)).sum() / (2. * n_entries)};
    }
  } // namespace


  ChosenStepSystem
  make_step_system(const int dim,
                   const MovingBody &body,
                   const double tolerance,
                   const WhereIndefinite where)
  {
    const CostOfFactors cost = cost_of_factors(graph_of(body));
    const double least       = isotropy(dim, body);
    const bool is_isotropic  = least >= isotropic;
    std::ostringstream reason;
    reason.precision(2);
    if (is_isotropic)
      reason << "factors of the " << body.mass.size() << " nodes have "
             << cost.fill << " times the entries of the matrix.";
    else
      reason << "nodes resist in one direction " << std::max(least, 0.)
             << " times as much as in another.";

    const auto with = [&](const std::string &preconditioner,
                          std::unique_ptr<StepPreconditioner> built,
                          const PreconditionerLife life) {
      return ChosenStepSystem{
        std::make_unique<IterativeStepSystem>(
          dim, body, std::move(built), life, tolerance, where),
        "The equations of a step are solved by conjugate gradients with " +
          preconditioner + ", because " + reason.str()};
    };
    if (body.elastic->has_constant_tangent() && cost.fill <= much_fill)
      return with("factors of the matrix, which is the same at all steps",
                  factor_preconditioner(dim, body),
                  PreconditionerLife::long_one);
    if (cost.effort <= (is_isotropic ? few_solutions : many_solutions))
      return with("factors of each step's matrix",
                  factor_preconditioner(dim, body),
                  PreconditionerLife::short_one);
    if (cost.fill <= little_fill || !is_isotropic)
      return with("factors of the matrix at rest",
                  factor_preconditioner(dim, body),
                  PreconditionerLife::long_one);
    return with("a multigrid method",
                multigrid_preconditioner(dim, body),
                PreconditionerLife::long_one);
  }
} // namespace springfit
