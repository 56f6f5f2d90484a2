#include <springfit/core/error.h>
#include <springfit/fit/object/compliance.h>
#include <springfit/fit/object/free_body.h>
#include <springfit/fit/programs/quadratic_program.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
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
      constexpr std::size_t largest = 12000;
      // The matrix of the equations and its factors, n x n each: measured, 240
      // MB more than the program itself for 3882 constants.
      const double gigabytes = 2. * sizeof(double) * n * n / 1e9;
      if (n > largest)
        {
          std::ostringstream text;
          text.precision(2);
          text << "The fit 'compliance' has dense equations for " << n
               << " constants, more than " << largest
               << ": they would take about " << gigabytes << " GB of memory.";
          throw RunError(
            text.str(),
            "Take a coarser mesh, or the fit 'consistent', of single "
            "cells or, with 'Scope = object', of the whole.");
        }
    }

    /** min c^T G c / 2 - g^T c */
    struct Equations
    {
      Eigen::MatrixXd G;
      Eigen::VectorXd g;
    };

    /** Calls work(first, n) for ranges of columns that are at most 256 wide. */
    template <typename Work>
    void
    for_blocks(const Eigen::Index n_columns, const Work &work)
    {
      const Eigen::Index width = 256;
      for (Eigen::Index first = 0; first < n_columns; first += width)
        work(first, std::min(width, n_columns - first));
    }

    /** By blocks of columns, so that G is the only large matrix but for Y. */
    Equations
    normal_equations(const ObjectProblem &problem)
    {
      const Dyads dyads = find_dyads(problem);
      const FreeBody body(problem.stiffness, problem.nodes);
      if (body.n_unstable() > 0)
        throw RunError("The stiffness of the finite elements is not positive "
                       "definite.",
                       "Check the mesh and the material.");

      const auto &V              = dyads.vectors;
      const Eigen::Index n       = V.rows();
      const Eigen::Index n_dyads = V.cols();

      // What the errors are relative to, squared.
      double of_compliance = 0.;
      for_blocks(n, [&](const Eigen::Index first, const Eigen::Index n_block) {
        Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(n, n_block);
        unit.middleRows(first, n_block).setIdentity();
        of_compliance += body.respond(unit).squaredNorm();
      });
      const double of_stiffness =
        problem.stiffness.squaredNorm() / (matrix_weight * matrix_weight);

      Eigen::MatrixXd Y(n, n_dyads); // R^+ V
      for_blocks(n_dyads,
                 [&](const Eigen::Index first, const Eigen::Index n_block) {
                   Y.middleCols(first, n_block) =
                     body.respond(V.middleCols(first, n_block));
                 });

      const Eigen::Index n_terms = problem.terms.size();
      Equations equations{Eigen::MatrixXd::Zero(n_terms, n_terms),
                          Eigen::VectorXd::Zero(n_terms)};
      for_blocks(
        n_dyads, [&](const Eigen::Index first, const Eigen::Index n_block) {
          const Eigen::MatrixXd Y_block = Y.middleCols(first, n_block);
          const Eigen::MatrixXd V_block = V.middleCols(first, n_block);
          // <v v^T, w w^T> = (v^T (R^+)^2 w)^2 and (v^T w)^2
          const Eigen::MatrixXd products =
            (Y.transpose() * Y_block).cwiseAbs2() / of_compliance +
            (V.transpose() * V_block).cwiseAbs2() / of_stiffness;
          // <v v^T, R> = v^T (R^+)^3 v and v^T R v
          const Eigen::VectorXd of_reference =
            Y_block.cwiseProduct(body.respond(Y_block)).colwise().sum() /
              of_compliance +
            V_block.cwiseProduct(problem.stiffness * V_block).colwise().sum() /
              of_stiffness;
          for (Eigen::Index r = 0; r < n_block; ++r)
            {
              const Eigen::Index term = dyads.term[first + r];
              const double factor     = dyads.factor[first + r];
              equations.g[term] += factor * of_reference[r];
              for (Eigen::Index s = 0; s < n_dyads; ++s)
                equations.G(dyads.term[s], term) +=
                  dyads.factor[s] * factor * products(s, r);
            }
        });
      return equations;
    }
  } // namespace

  Eigen::VectorXd
  fit_compliance(const ObjectProblem &problem)
  {
    check_size(problem.terms.size());
    Equations equations = normal_equations(problem);
    return minimise_quadratic(std::move(equations.G),
                              equations.g,
                              problem.nonnegative);
  }
} // namespace springfit
