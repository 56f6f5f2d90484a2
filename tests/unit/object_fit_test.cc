// Fits of all springs of an object at once, against dense linear algebra.

#include <springfit/core/error.h>
#include <springfit/fit/displacement_fields.h>
#include <springfit/fit/object/compliance.h>
#include <springfit/fit/object/free_body.h>
#include <springfit/fit/object/object_fit.h>
#include <springfit/fit/object/object_stability.h>
#include <springfit/springs/network.h>
#include <springfit/springs/rest_families.h>
#include <springfit/springs/rigid_modes.h>
#include <springfit/springs/volume.h>

#include <gtest/gtest.h>

#include <functional>

#include "cells.h"

using namespace springfit;
using springfit::oracle::all_kinds;
using springfit::oracle::Random;

namespace
{
  /** A box of 2^dim squares or cubes, or of what these are cut into. */
  struct Grid
  {
    Eigen::MatrixXd nodes;
    std::vector<std::vector<unsigned int>> cells;
    CellKind kind;
  };

  Grid
  make_grid(const CellKind kind, const double jitter, Random &random)
  {
    const int dim      = dimension(kind);
    const int n_points = dim == 2 ? 9 : 27;
    Grid grid{Eigen::MatrixXd(dim, n_points), {}, kind};
    for (int p = 0; p < n_points; ++p)
      for (int d = 0, rest = p; d < dim; ++d, rest /= 3)
        grid.nodes(d, p) = rest % 3 + jitter * random(-1., 1.);

    // Kuhn's subdivision: a path of edges for each order of the axes.
    std::vector<std::vector<int>> simplices = {{0, 1, 3}, {0, 3, 2}};
    if (dim == 3)
      simplices = {{0, 1, 3, 7},
                   {0, 3, 2, 7},
                   {0, 2, 6, 7},
                   {0, 6, 4, 7},
                   {0, 4, 5, 7},
                   {0, 5, 1, 7}};
    for (int p = 0; p < n_points; ++p)
      {
        const int i = p % 3, j = p / 3 % 3, k = p / 9;
        if (i == 2 || j == 2 || k == 2)
          continue;
        const auto vertex = [&](const int v) -> unsigned int {
          return p + (v & 1) + 3 * (v >> 1 & 1) + 9 * (v >> 2 & 1);
        };
        if (is_simplex(kind))
          for (const auto &simplex : simplices)
            {
              grid.cells.emplace_back();
              for (const int v : simplex)
                grid.cells.back().push_back(vertex(v));
            }
        else
          {
            grid.cells.emplace_back();
            for (int v = 0; v < n_vertices(kind); ++v)
              grid.cells.back().push_back(vertex(v));
          }
      }
    return grid;
  }

  Eigen::MatrixXd
  points_of(const Grid &grid, const std::vector<unsigned int> &cell)
  {
    return grid.nodes(Eigen::all, cell);
  }

  Eigen::SparseMatrix<double>
  assembled_stiffness(const Grid &grid, const double nu)
  {
    const int dim = grid.nodes.rows();
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto &cell : grid.cells)
      {
        const Eigen::MatrixXd R =
          oracle::stiffness(points_of(grid, cell),
                            grid.kind,
                            oracle::usual_elasticity(grid.kind, nu));
        for (int a = 0; a < R.rows(); ++a)
          for (int b = 0; b < R.cols(); ++b)
            entries.emplace_back(dim * cell[a / dim] + a % dim,
                                 dim * cell[b / dim] + b % dim,
                                 R(a, b));
      }
    Eigen::SparseMatrix<double> R(grid.nodes.size(), grid.nodes.size());
    R.setFromTriplets(entries.begin(), entries.end());
    return R;
  }

  enum class Terms
  {
    springs,
    volumes,
    couplings
  };

  /** All constants one. */
  SpringNetwork
  unit_network(const Grid &grid, const Terms terms)
  {
    NetworkBuilder builder(grid.nodes);
    const auto &pairs = node_pairs(grid.kind);
    // Builders add what cells share.
    std::vector<LengthCoupling> couplings;
    for (unsigned int a = 0; a < pairs.size(); ++a)
      for (unsigned int b = a + 1; b < pairs.size(); ++b)
        couplings.push_back({a, b, 1.});
    for (const auto &cell : grid.cells)
      {
        const Eigen::MatrixXd x = points_of(grid, cell);
        const SpringLaw law     = SpringLaw::quadratic;
        builder.add(
          lengths_at_rest(x, pairs, Eigen::VectorXd::Ones(pairs.size()), law),
          cell);
        if (terms == Terms::volumes)
          builder.add(volume_at_rest(x, grid.kind, 1.), cell);
        if (terms == Terms::couplings)
          builder.add(couplings_at_rest(x, pairs, couplings, law), cell);
      }
    SpringNetwork network = builder.build();
    network.families      = with_constants(network.families,
                                      Eigen::VectorXd::Ones(
                                        constants_of(network.families).size()));
    return network;
  }

  std::vector<EnergyTerm>
  terms_at_rest(const SpringNetwork &network)
  {
    std::vector<EnergyTerm> terms;
    for (const auto &family : network.families)
      for (std::size_t m = 0; m < family.size(); ++m)
        {
          const unsigned int *nodes = family.nodes(m);
          terms.push_back(
            {{nodes, nodes + family.kind->n_nodes()},
             0.,
             {},
             family.kind->hessian(family.members, m, network.nodes)});
        }
    return terms;
  }

  ObjectProblem
  make_problem(const Grid &grid,
               const Terms terms,
               const double nu,
               const bool nonnegative = false)
  {
    const SpringNetwork network = unit_network(grid, terms);
    ObjectProblem problem{grid.nodes,
                          assembled_stiffness(grid, nu),
                          terms_at_rest(network),
                          {}};
    problem.nonnegative.assign(problem.terms.size(), false);
    if (nonnegative)
      for (std::size_t s = 0; s < n_springs(network.families); ++s)
        problem.nonnegative[s] = true;
    return problem;
  }

  /** T_m, n x n, written down anew. */
  Eigen::MatrixXd
  tangent(const ObjectProblem &problem, const std::size_t m)
  {
    const EnergyTerm &term = problem.terms[m];
    const Eigen::Index n   = problem.stiffness.rows();
    const Eigen::Index dim = problem.nodes.rows();
    Eigen::MatrixXd T      = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t a = 0; a < term.nodes.size(); ++a)
      for (std::size_t b = 0; b < term.nodes.size(); ++b)
        T.block(dim * term.nodes[a], dim * term.nodes[b], dim, dim) +=
          term.hessian.block(dim * a, dim * b, dim, dim);
    return T;
  }

  Eigen::VectorXd
  flat(const Eigen::MatrixXd &A)
  {
    return Eigen::Map<const Eigen::VectorXd>(A.data(), A.size());
  }

  /** Dense least squares with the columns image(T_m) and the right image(R). */
  Eigen::VectorXd
  dense_fit(
    const ObjectProblem &problem,
    const std::function<Eigen::VectorXd(const Eigen::MatrixXd &)> &image)
  {
    const Eigen::VectorXd d = image(problem.stiffness);
    Eigen::MatrixXd A(d.size(), problem.terms.size());
    for (std::size_t m = 0; m < problem.terms.size(); ++m)
      A.col(m) = image(tangent(problem, m));
    return A.colPivHouseholderQr().solve(d);
  }

  void
  expect_same_stiffness(const ObjectProblem &problem,
                        const Eigen::VectorXd &c,
                        const Eigen::VectorXd &expected,
                        const double tolerance)
  {
    EXPECT_LT((fitted_stiffness(problem, c) -
               fitted_stiffness(problem, expected))
                .norm(),
              tolerance * problem.stiffness.norm());
  }

  using Fit = std::function<Eigen::VectorXd(const ObjectProblem &)>;

  /** The mean of R's diagonal at a term's nodes, over ||T_m||_F. */
  double
  typical_constant(const ObjectProblem &problem, const std::size_t m)
  {
    const Eigen::MatrixXd R = problem.stiffness;
    const int dim           = problem.nodes.rows();
    const auto &nodes       = problem.terms[m].nodes;
    double sum              = 0.;
    for (const auto node : nodes)
      sum += R.block(dim * node, dim * node, dim, dim).trace();
    return sum / (dim * nodes.size()) / tangent(problem, m).norm();
  }

  /** What fit_displacements() minimises, by dense linear algebra. */
  struct DisplacementError
  {
    Eigen::MatrixXd columns; // the images of the terms and, below, the prior's
    Eigen::VectorXd right_side;

    DisplacementError(const ObjectProblem &problem,
                      const Eigen::MatrixXd &fields,
                      const Eigen::VectorXd &prior,
                      const double weight)
    {
      const Eigen::MatrixXd R = problem.stiffness;
      const Eigen::MatrixXd inverse =
        R.completeOrthogonalDecomposition().pseudoInverse();
      const Eigen::MatrixXd deformations = inverse * R * fields;
      const Eigen::MatrixXd u =
        deformations *
        deformations.colwise().norm().cwiseInverse().asDiagonal() /
        std::sqrt(fields.cols());
      const std::size_t n_terms = problem.terms.size();
      columns = Eigen::MatrixXd::Zero(u.size() + n_terms, n_terms);
      right_side.resize(columns.rows());
      right_side.head(u.size()) = flat(u);
      for (std::size_t m = 0; m < n_terms; ++m)
        {
          const double inverse_scale =
            weight / std::sqrt(n_terms) / typical_constant(problem, m);
          columns.col(m).head(u.size()) =
            flat(inverse * tangent(problem, m) * u);
          columns(u.size() + m, m) = inverse_scale;
          right_side[u.size() + m] = inverse_scale * prior[m];
        }
    }

    double
    operator()(const Eigen::VectorXd &c) const
    {
      return (right_side - columns * c).squaredNorm();
    }
  };

  Eigen::VectorXd
  typical_constants(const ObjectProblem &problem)
  {
    Eigen::VectorXd constants(problem.terms.size());
    for (std::size_t m = 0; m < problem.terms.size(); ++m)
      constants[m] = typical_constant(problem, m);
    return constants;
  }

  /** From a prior that knows nothing but sizes. */
  Eigen::VectorXd
  fit_random_displacements(const ObjectProblem &problem)
  {
    Random random(310);
    return fit_displacements(problem,
                             random.matrix(problem.stiffness.rows(), 12),
                             typical_constants(problem),
                             1e-6);
  }

  const std::vector<Fit> all_object_fits = {fit_matrix,
                                            fit_random_displacements,
                                            fit_compliance};

  TEST(ObjectFit, MatrixIsTheDenseLeastSquares)
  {
    Random random(311);
    for (const CellKind kind : all_kinds)
      for (const Terms terms : {Terms::springs, Terms::volumes})
        {
          const auto problem =
            make_problem(make_grid(kind, 0.1, random), terms, 0.3);
          expect_same_stiffness(problem,
                                fit_matrix(problem),
                                dense_fit(problem, flat),
                                1e-8);
        }
  }

  TEST(ObjectFit, DisplacementsAreTheDenseLeastSquares)
  {
    Random random(312);
    for (const CellKind kind : all_kinds)
      {
        const auto problem =
          make_problem(make_grid(kind, 0.1, random), Terms::volumes, 0.3);
        const Eigen::MatrixXd fields = quadratic_fields(problem.nodes);
        const Eigen::VectorXd prior  = fit_matrix(problem);
        const double weight          = 0.1;
        const DisplacementError error(problem, fields, prior, weight);
        const Eigen::VectorXd expected =
          error.columns.colPivHouseholderQr().solve(error.right_side);
        // Sizes and rigid motions of the fields do not matter.
        const Eigen::MatrixXd rigid = rigid_body_modes(problem.nodes);
        Eigen::MatrixXd others(fields.rows(), fields.cols() + 1);
        others << 7. * fields +
                    rigid * random.matrix(rigid.cols(), fields.cols()),
          rigid.col(0);
        for (const auto &same : {fields, others})
          expect_same_stiffness(problem,
                                fit_displacements(problem, same, prior, weight),
                                expected,
                                1e-7);
      }
  }

  TEST(ObjectFit, NonnegativeDisplacementsAreTheBestOfTheirNeighbours)
  {
    Random random(320);
    for (const CellKind kind : {CellKind::tetrahedron, CellKind::hexahedron})
      {
        const auto problem =
          make_problem(make_grid(kind, 0.2, random), Terms::volumes, 0.1, true);
        const Eigen::MatrixXd fields = quadratic_fields(problem.nodes);
        const Eigen::VectorXd prior  = fit_matrix(problem);
        const double weight          = 0.1;
        const DisplacementError error(problem, fields, prior, weight);
        const Eigen::VectorXd c =
          fit_displacements(problem, fields, prior, weight);
        const double best = error(c);
        EXPECT_LT(best, error(prior));
        const auto feasible = [&](Eigen::VectorXd other) {
          for (Eigen::Index m = 0; m < c.size(); ++m)
            if (problem.nonnegative[m])
              other[m] = std::max(other[m], 0.);
          return other;
        };
        EXPECT_EQ(feasible(c), c);
        EXPECT_GT((c.array() == 0.).count(), 0);
        const Eigen::VectorXd size = typical_constants(problem);
        for (const double step : {1e-4, 1e-2})
          {
            for (Eigen::Index m = 0; m < c.size(); ++m)
              for (const double sign : {-1., 1.})
                {
                  Eigen::VectorXd other = c;
                  other[m] += sign * step * size[m];
                  EXPECT_GE(error(feasible(other)), best * (1. - 1e-9));
                }
            for (int repetition = 0; repetition < 100; ++repetition)
              EXPECT_GE(error(feasible(
                          c + step *
                                size.cwiseProduct(random.matrix(c.size(), 1)))),
                        best * (1. - 1e-9));
          }
      }
  }

  TEST(ObjectFit, ComplianceIsTheDenseLeastSquares)
  {
    Random random(313);
    for (const CellKind kind : all_kinds)
      for (const Terms terms : {Terms::springs, Terms::volumes})
        {
          const auto problem =
            make_problem(make_grid(kind, 0.1, random), terms, 0.3);
          const Eigen::MatrixXd R = problem.stiffness;
          const Eigen::MatrixXd inverse =
            R.completeOrthogonalDecomposition().pseudoInverse();
          const auto expected =
            dense_fit(problem, [&](const Eigen::MatrixXd &T) {
              Eigen::VectorXd image(2 * T.size());
              image << flat(inverse * T * inverse) / inverse.norm(),
                0.03 / R.norm() * flat(T);
              return image;
            });
          expect_same_stiffness(problem,
                                fit_compliance(problem),
                                expected,
                                1e-7);
        }
  }

  /** Of couplings on hexahedra many are dependent. */
  TEST(ObjectFit, RecoversANetwork)
  {
    Random random(314);
    for (const CellKind kind : all_kinds)
      for (const Terms terms :
           {Terms::springs, Terms::volumes, Terms::couplings})
        {
          if (terms == Terms::couplings && kind == CellKind::hexahedron)
            continue;
          auto problem = make_problem(make_grid(kind, 0.1, random), terms, 0.3);
          Eigen::VectorXd c(problem.terms.size());
          for (Eigen::Index m = 0; m < c.size(); ++m)
            c[m] = random(1., 2.);
          if (terms == Terms::couplings)
            for (std::size_t m = 0; m < problem.terms.size(); ++m)
              if (problem.terms[m].nodes.size() == 4)
                c[m] *= 0.02; // stays positive definite
          problem.stiffness = fitted_stiffness(problem, c);
          ASSERT_EQ(FreeBody(problem.stiffness, problem.nodes).n_unstable(),
                    0u);
          for (const auto &fit : all_object_fits)
            expect_same_stiffness(problem, fit(problem), c, 1e-6);
        }
  }

  TEST(ObjectFit, NonnegativeIsTheBestOfItsNeighbours)
  {
    Random random(315);
    const CellKind kind = CellKind::tetrahedron;
    auto problem =
      make_problem(make_grid(kind, 0.2, random), Terms::volumes, 0.1, true);
    const auto matrix_error = [&](const Eigen::VectorXd &c) {
      return (problem.stiffness - fitted_stiffness(problem, c)).squaredNorm();
    };
    const Eigen::VectorXd c = fit_matrix(problem);
    const double best       = matrix_error(c);
    int n_held              = 0;
    for (Eigen::Index m = 0; m < c.size(); ++m)
      {
        n_held += problem.nonnegative[m] && c[m] == 0.;
        EXPECT_TRUE(!problem.nonnegative[m] || c[m] >= 0.);
        const double step =
          1e-3 * problem.stiffness.norm() / problem.terms[m].hessian.norm();
        for (const double sign : {-1., 1.})
          {
            Eigen::VectorXd other = c;
            other[m] += sign * step;
            if (problem.nonnegative[m])
              other[m] = std::max(other[m], 0.);
            EXPECT_GE(matrix_error(other), best * (1. - 1e-12));
          }
      }
    EXPECT_GT(n_held, 0);
  }

  /**
   * On boxes of regular cells springs and an area or volume spring can bear
   * every constant strain as the finite elements do.
   */
  TEST(ObjectFit, PatchTestOfAffineDisplacements)
  {
    Random random(316);
    for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
      for (const double nu : {0., 0.3, 0.45})
        {
          const auto problem =
            make_problem(make_grid(kind, 0., random), Terms::volumes, nu);
          const Eigen::MatrixXd fields = affine_fields(problem.nodes);
          const auto error             = [&](const double weight) {
            const auto K = fitted_stiffness(
              problem,
              fit_displacements(problem, fields, fit_matrix(problem), weight));
            return ((problem.stiffness - K) * fields).norm() /
                   (problem.stiffness * fields).norm();
          };
          EXPECT_LT(error(1e-3), 1e-5);
          // What is left is the weight's doing, with its square.
          EXPECT_LT(error(1e-3), 0.02 * error(1e-2) + 1e-9);
        }
  }

  /** Against the generalised eigenvalue at which dense K(t) turns singular. */
  TEST(ObjectFit, ShareToInstabilityIsWhereAnEigenvalueVanishes)
  {
    Random random(321);
    for (const CellKind kind : all_kinds)
      {
        const Grid grid       = make_grid(kind, 0.1, random);
        const auto problem    = make_problem(grid, Terms::volumes, 0.1);
        const Eigen::Index n  = problem.terms.size();
        Eigen::VectorXd start = Eigen::VectorXd::Ones(n), end = start;
        for (Eigen::Index m = 0; m < n; ++m)
          end[m] = random(-1., 0.5);

        const double share = share_to_instability(problem, start, end);

        // On the deformations K(start) is positive definite, and with C C^T
        // for it K(t) is as I - t (I - C^-1 K(end) C^-T).
        const Eigen::MatrixXd K = fitted_stiffness(problem, start);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(K);
        const Eigen::Index n_rigid = grid.nodes.rows() == 2 ? 3 : 6;
        const Eigen::Index n_soft  = K.cols() - n_rigid;
        ASSERT_GT(solver.eigenvalues()[n_rigid], 1e-6);
        const Eigen::MatrixXd root_inverse =
          solver.eigenvectors().rightCols(n_soft) * solver.eigenvalues()
                                                      .tail(n_soft)
                                                      .cwiseSqrt()
                                                      .cwiseInverse()
                                                      .asDiagonal();
        const Eigen::MatrixXd K_end = fitted_stiffness(problem, end);
        const Eigen::MatrixXd decrease =
          Eigen::MatrixXd::Identity(n_soft, n_soft) -
          root_inverse.transpose() * K_end * root_inverse;
        const double expected =
          1. / Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(decrease)
                 .eigenvalues()[n_soft - 1];
        ASSERT_LT(expected, 1.);
        EXPECT_LE(share, expected + 1e-6);
        EXPECT_GE(share, expected - 1e-3);
      }
  }

  TEST(ObjectFit, FieldsAreWhatTheySay)
  {
    Random random(317);
    for (const int dim : {2, 3})
      {
        const Eigen::MatrixXd x   = random.matrix(dim, 7);
        const Eigen::MatrixXd one = affine_fields(x), two = quadratic_fields(x);
        EXPECT_EQ(one.cols(), dim * (dim + 1) / 2);
        EXPECT_EQ(two.cols(), dim * dim * (dim + 1) / 2);
        // Together with rigid motions: all affine fields.
        Eigen::MatrixXd affine(x.size(), one.cols() + dim * (dim + 1) / 2);
        affine << one, rigid_body_modes(x);
        EXPECT_EQ(affine.colPivHouseholderQr().rank(), dim * (dim + 1));
        // A field is quadratic where its third differences vanish.
        const Eigen::MatrixXd a = random.matrix(dim, 1),
                              b = random.matrix(dim, 1);
        Eigen::MatrixXd line(dim, 6);
        for (int p = 0; p < 6; ++p)
          line.col(p) = a + p * b;
        for (const auto &fields : {affine_fields(line), quadratic_fields(line)})
          for (int p = 0; p < 3; ++p)
            for (int d = 0; d < dim; ++d)
              {
                const auto row = [&](const int q) {
                  return fields.row(dim * q + d);
                };
                EXPECT_LT((row(p + 3) - 3. * row(p + 2) + 3. * row(p + 1) -
                           row(p))
                            .norm(),
                          1e-12);
              }
      }
  }

  TEST(FreeBody, RespondsAsTheMoorePenroseInverse)
  {
    Random random(318);
    for (const CellKind kind : all_kinds)
      {
        const Grid grid = make_grid(kind, 0.1, random);
        const auto R    = assembled_stiffness(grid, 0.3);
        const Eigen::MatrixXd inverse =
          Eigen::MatrixXd(R).completeOrthogonalDecomposition().pseudoInverse();
        const Eigen::MatrixXd f = random.matrix(R.rows(), 3);
        const Eigen::MatrixXd u = FreeBody(R, grid.nodes).respond(f);
        EXPECT_LT((u - inverse * f).norm(), 1e-10 * u.norm());
      }
  }

  TEST(FreeBody, CountsTheNegativeEigenvalues)
  {
    Random random(319);
    for (const CellKind kind : all_kinds)
      {
        const Grid grid    = make_grid(kind, 0.1, random);
        const auto problem = make_problem(grid, Terms::springs, 0.3);
        Eigen::VectorXd c(problem.terms.size());
        for (Eigen::Index m = 0; m < c.size(); ++m)
          c[m] = random(-0.5, 1.);
        const Eigen::MatrixXd K = fitted_stiffness(problem, c);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(K);
        const int n_negative = (solver.eigenvalues().array() < -1e-10).count();
        EXPECT_GT(n_negative, 0);
        EXPECT_EQ(FreeBody(K.sparseView(), grid.nodes).n_unstable(),
                  n_negative);
      }
  }

  /** A cell's edges hold it; each one less lets it fold. */
  TEST(FreeBody, CountsTheMechanisms)
  {
    Random random(322);
    for (const CellKind kind : {CellKind::triangle, CellKind::tetrahedron})
      {
        const Grid grid{oracle::random_cell(kind, random), {{}}, kind};
        Grid cell = grid;
        for (int v = 0; v < n_vertices(kind); ++v)
          cell.cells[0].push_back(v);
        const auto problem = make_problem(cell, Terms::springs, 0.3);
        Eigen::VectorXd c  = Eigen::VectorXd::Ones(problem.terms.size());
        for (Eigen::Index n_cut = 0; n_cut < c.size(); ++n_cut)
          {
            const FreeBody body(fitted_stiffness(problem, c), cell.nodes);
            EXPECT_EQ(body.n_mechanisms(), n_cut);
            EXPECT_EQ(body.n_unstable(), 0u);
            c[n_cut] = 0.;
          }
        // What releases energy is no mechanism.
        c.setOnes();
        c[0] = -0.1;
        EXPECT_EQ(
          FreeBody(fitted_stiffness(problem, c), cell.nodes).n_mechanisms(),
          0u);
      }
  }

  /** Two cells with one node in common, about which they turn. */
  TEST(FreeBody, HasNoResponseOfAHinge)
  {
    Random random(320);
    for (const CellKind kind : {CellKind::triangle, CellKind::tetrahedron})
      for (int repetition = 0; repetition < 20; ++repetition)
        {
          const int dim           = dimension(kind);
          const Eigen::MatrixXd a = oracle::random_cell(kind, random);
          const Eigen::MatrixXd b = oracle::random_cell(kind, random);
          const unsigned int n    = a.cols();
          Eigen::MatrixXd nodes(dim, 2 * n - 1);
          nodes << a, (-b.rightCols(n - 1)).colwise() + (a.col(0) + b.col(0));
          Grid grid{nodes, {{}, {0}}, kind};
          for (unsigned int v = 0; v < n; ++v)
            grid.cells[0].push_back(v);
          for (unsigned int v = n; v < 2 * n - 1; ++v)
            grid.cells[1].push_back(v);
          const FreeBody body(assembled_stiffness(grid, 0.3), nodes);
          EXPECT_EQ(body.n_unstable(), 0u);
          EXPECT_EQ(body.n_mechanisms(), dim == 2 ? 1u : 3u);
          EXPECT_THROW(body.respond(random.matrix(nodes.size(), 1)), RunError);
        }
  }
} // namespace
