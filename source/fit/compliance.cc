#include <springfit/core/error.h>
#include <springfit/fit/compliance.h>
#include <springfit/fit/free_body.h>
#include <springfit/fit/quadratic_program.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    // Of ||E||_F, see the header. Four unstructured meshes of tetrahedra (377
    // to 1454 cells, springs and volumes) are stable with 0.01 to 0.1, and
    // their errors hardly change.
    constexpr double matrix_weight = 0.03;

    /** T_m as a sum of factor v v^T, of a spring just one. */
    struct Dyads
    {
      std::vector<Eigen::Index> term;
      std::vector<double> factor;
      Eigen::SparseMatrix<double> vectors; // a column for each
    };

    Dyads
    find_dyads(const ObjectProblem &problem)
    {
      Dyads dyads;
      std::vector<Eigen::Triplet<double>> entries;
      for (std::size_t m = 0; m < problem.terms.size(); ++m)
        {
          const auto &[nodes, energy, gradient, hessian] = problem.terms[m];
          const Eigen::Index dim = hessian.rows() / nodes.size();
          const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(hessian);
          const Eigen::VectorXd &eigenvalues = solver.eigenvalues();
          const double rounding = 1e-12 * eigenvalues.cwiseAbs().maxCoeff();
          for (Eigen::Index r = 0; r < eigenvalues.size(); ++r)
            if (std::abs(eigenvalues[r]) > rounding)
              {
                for (Eigen::Index a = 0; a < hessian.rows(); ++a)
                  entries.emplace_back(dim * nodes[a / dim] + a % dim,
                                       dyads.term.size(),
                                       solver.eigenvectors()(a, r));
                dyads.term.push_back(m);
                dyads.factor.push_back(eigenvalues[r]);
              }
        }
      dyads.vectors.resize(problem.stiffness.rows(), dyads.term.size());
      dyads.vectors.setFromTriplets(entries.begin(), entries.end());
      return dyads;
    }

    /** @throws RunError when the dense equations would not fit into memory. */
    void
    check_size(const std::size_t n)
    {
      constexpr std::size_t largest = 12000; // 1.2 GB
      if (n > largest)
        throw RunError("The fit 'compliance' of the whole object has dense "
                       "matrices of " +
                         std::to_string(n) +
                         " rows, as many as there are springs, volume springs "
                         "and twice the couplings: more than " +
                         std::to_string(largest) + '.',
                       "Take a coarser mesh, or the fit 'frobenius', whose "
                       "matrices are sparse.");
    }
  } // namespace

  Eigen::VectorXd
  fit_compliance(const ObjectProblem &problem)
  {
    const Dyads dyads = find_dyads(problem);
    check_size(dyads.term.size());
    const FreeBody body(problem.stiffness, problem.nodes);
    if (body.n_unstable() > 0)
      throw RunError("The stiffness of the finite elements is not positive "
                     "definite.",
                     "Check the mesh and the material.");

    const auto &V           = dyads.vectors;
    const Eigen::MatrixXd Y = body.respond(V); // R^+ V
    // What the errors are relative to, squared.
    const Eigen::Index n = V.rows();
    const double of_compliance =
      body.respond(Eigen::MatrixXd::Identity(n, n)).squaredNorm();
    const double of_stiffness =
      problem.stiffness.squaredNorm() / (matrix_weight * matrix_weight);

    // <v v^T, w w^T> = (v^T (R^+)^2 w)^2 and (v^T w)^2
    const Eigen::MatrixXd products =
      (Y.transpose() * Y).cwiseAbs2() / of_compliance +
      Eigen::MatrixXd(V.transpose() * V).cwiseAbs2() / of_stiffness;
    // <v v^T, R> = v^T (R^+)^3 v and v^T R v
    const Eigen::MatrixXd V_dense = V;
    const Eigen::VectorXd g_dyads =
      Y.cwiseProduct(body.respond(Y)).colwise().sum() / of_compliance +
      V_dense.cwiseProduct(problem.stiffness * V_dense).colwise().sum() /
        of_stiffness;

    const Eigen::Index n_terms = problem.terms.size();
    Eigen::MatrixXd G          = Eigen::MatrixXd::Zero(n_terms, n_terms);
    Eigen::VectorXd g          = Eigen::VectorXd::Zero(n_terms);
    for (std::size_t r = 0; r < dyads.term.size(); ++r)
      {
        g[dyads.term[r]] += dyads.factor[r] * g_dyads[r];
        for (std::size_t s = 0; s < dyads.term.size(); ++s)
          G(dyads.term[s], dyads.term[r]) +=
            dyads.factor[s] * dyads.factor[r] * products(s, r);
      }
    return minimise_quadratic(G, g, problem.nonnegative);
  }
} // namespace springfit
