#include <springfit/motion/step_preconditioner.h>
#include <springfit/motion/step_systems.h>
#include <springfit/springs/tangent_matrix.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include <sstream>
#include <vector>

namespace springfit
{
  namespace
  {
    // Up to this fill factors are as fast as a V cycle, whose iterations are
    // several times as many: tests/benchmarks/step_benchmark.cc has the times.
    constexpr double little_fill = 2.;

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
      double
      n_entries() const
      {
        return m_nonZerosPerCol.cast<double>().sum() + m_nonZerosPerCol.size();
      }
    };

    /** The entries of the factors relative to those of half the matrix. */
    double
    fill_of_factors(const Eigen::SparseMatrix<double> &graph)
    {
      SymbolicFactors factors;
      factors.analyzePattern(graph);
      return factors.n_entries() / (0.5 * (graph.nonZeros() + graph.cols()));
    }
  } // namespace


  ChosenStepSystem
  make_step_system(const int dim,
                   const MovingBody &body,
                   const double tolerance)
  {
    const double fill         = fill_of_factors(graph_of(body));
    const bool is_for_factors = fill <= little_fill;
    std::ostringstream reason;
    reason.precision(2);
    reason << "The equations of a step are solved by conjugate gradients with "
           << (is_for_factors ? "factors of the matrix at rest"
                              : "a multigrid method")
           << ", because factors of the " << body.mass.size() << " nodes have "
           << fill << " times the entries of the matrix.";
    auto preconditioner = is_for_factors ? factor_preconditioner(dim, body)
                                         : multigrid_preconditioner(dim, body);
    return {std::make_unique<IterativeStepSystem>(
              dim, body, std::move(preconditioner), tolerance),
            reason.str()};
  }
} // namespace springfit
