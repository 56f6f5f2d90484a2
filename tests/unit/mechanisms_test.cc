// No fit with springs >= 0 leaves a cell a mechanism, and what springs of a
// whole object do not hold is found.

#include <springfit/fit/fit.h>
#include <springfit/fit/object/free_motions.h>
#include <springfit/springs/network.h>
#include <springfit/springs/rest_families.h>

#include <gtest/gtest.h>

#include "cells.h"
#include "fits.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  /** The smallest eigenvalue of R on the deformations, relative to ||R||_2. */
  double
  softest(const FitProblem &problem)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      problem.stiffness, Eigen::EigenvaluesOnly);
    const int n_rigid = problem.points.rows() == 2 ? 3 : 6;
    return eigen.eigenvalues()[n_rigid] / eigen.eigenvalues().reverse()[0];
  }

  TEST(Mechanisms, NoFitWithSpringsOverZeroMakesOne)
  {
    Random random(731);
    for (const CellKind kind : all_kinds)
      for (int repetition = 0; repetition < 10; ++repetition)
        for (const double nu : {-0.3, 0.3, 0.49})
          {
            const auto problem =
              fit_problem(random_cell(kind, random), kind, nu);
            for (const char *word :
                 {"block", "frobenius", "spectral", "consistent", "compliance"})
              for (const Enrichment enrichment :
                   {Enrichment::none, Enrichment::volume, Enrichment::angles})
                for (const Norm norm : {Norm::frobenius, Norm::spectral})
                  {
                    FitOptions options = options_of(Engine::barrier, true);
                    options.enrichment = enrichment;
                    options.norm       = norm;
                    const auto result =
                      fit(problem, method_named(word), options);
                    EXPECT_GE(*result.smallest_eigenvalue,
                              0.03 * softest(problem) * (1. - 1e-6))
                      << word << ", " << singular(kind) << ", nu = " << nu;
                    EXPECT_EQ(result.n_negative, 0u);
                    check_certificate(result, options);
                  }
          }
  }

  // Two tetrahedra whose common spring vanished with k >= 0.
  TEST(Mechanisms, NorDoTwoTetrahedra)
  {
    Eigen::MatrixXd nodes(3, 5);
    nodes << .3, .5, .2, .3, -.6, .8, .1, .3, .5, .6, .3, .4, .8, 1., .8;
    for (const std::vector<int> &cell :
         {std::vector<int>{0, 2, 1, 3}, {0, 2, 3, 4}})
      {
        const auto problem =
          fit_problem(nodes(Eigen::all, cell), CellKind::tetrahedron, 0.3);
        const auto result = fit(problem,
                                method_named("frobenius"),
                                options_of(Engine::barrier, true));
        EXPECT_GT(result.k().minCoeff(), 0.);
      }
  }

  /** Springs of stiffness one between these nodes. */
  Eigen::SparseMatrix<double>
  stiffness(const Eigen::MatrixXd &nodes, const std::vector<NodePair> &springs)
  {
    return tangent({lengths_at_rest(nodes,
                                    springs,
                                    Eigen::VectorXd::Ones(springs.size()),
                                    SpringLaw::quadratic)},
                   nodes);
  }

  TEST(Mechanisms, OfSingleNodes)
  {
    // A triangle, a node on one spring, and one on two.
    Eigen::MatrixXd nodes(2, 5);
    nodes << 0., 1., 0., 2., 1., 0., 0., 1., 0.3, 1.;
    const auto K =
      stiffness(nodes, {{0, 1}, {1, 2}, {0, 2}, {1, 3}, {1, 4}, {2, 4}});
    EXPECT_EQ(loose_nodes(K, 2), std::vector<unsigned int>{3});
    const auto motions = find_free_motions(K, nodes);
    EXPECT_EQ(motions.n, 1u);
    EXPECT_EQ(motions.n_of_parts, 0u);
  }

  /**
   * The node that moves furthest where nodes 3 and 4 turn about node 0, once
   * the nearest rigid motion is taken away.
   */
  unsigned int
  furthest_of_fold(const Eigen::MatrixXd &nodes)
  {
    Eigen::MatrixXd fold = Eigen::MatrixXd::Zero(2, 5);
    Eigen::MatrixXd rigid(10, 3);
    for (Eigen::Index v = 0; v < 5; ++v)
      {
        const Eigen::Vector2d turned(-nodes(1, v), nodes(0, v));
        rigid.middleRows<2>(2 * v) << Eigen::Matrix2d::Identity(), turned;
        if (v > 2)
          fold.col(v) = turned; // node 0 is the origin
      }
    const Eigen::VectorXd part =
      fold.reshaped() -
      rigid * rigid.colPivHouseholderQr().solve(fold.reshaped());
    unsigned int furthest = 0;
    part.reshaped(2, 5).colwise().norm().maxCoeff(&furthest);
    return furthest;
  }

  TEST(Mechanisms, OfLargerParts)
  {
    // Two triangles on a hinge; one has a node on a single spring besides.
    Eigen::MatrixXd nodes(2, 6);
    nodes << 0., -1., -1., 1., 5., -2., 0., 1., -1., 0.5, -1., 0.;
    std::vector<NodePair> springs = {
      {0, 1}, {1, 2}, {0, 2}, {0, 3}, {3, 4}, {0, 4}};
    const auto hinge = find_free_motions(stiffness(nodes.leftCols(5), springs),
                                         nodes.leftCols(5));
    EXPECT_EQ(hinge.n, 1u);
    EXPECT_EQ(hinge.n_of_parts, 1u);
    EXPECT_EQ(hinge.moved_node, furthest_of_fold(nodes.leftCols(5)));

    springs.push_back({1, 5});
    const auto K    = stiffness(nodes, springs);
    const auto both = find_free_motions(K, nodes);
    EXPECT_EQ(loose_nodes(K, 2), std::vector<unsigned int>{5});
    EXPECT_EQ(both.n, 2u);
    EXPECT_EQ(both.n_of_parts, 1u);
    EXPECT_NE(both.moved_node, 5u);
  }

  TEST(Mechanisms, HeldBodiesHaveNone)
  {
    Random random(732);
    for (const CellKind kind : all_kinds)
      {
        const Eigen::MatrixXd x = random_cell(kind, random);
        const auto K            = stiffness(x, node_pairs(kind));
        EXPECT_TRUE(loose_nodes(K, x.rows()).empty());
        EXPECT_EQ(find_free_motions(K, x).n, 0u);
      }
  }
} // namespace
