#include <springfit/calibration/states.h>
#include <springfit/core/error.h>
#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/fit/cell/frobenius.h>
#include <springfit/fit/cell/several_states.h>
#include <springfit/springs/negative.h>

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "fits.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  using Energy = std::function<double(const Eigen::VectorXd &)>;

  // Written independently of the program: energies as functions of the nodes'
  // places, their Hessians by finite differences, dense least squares by the
  // singular value decomposition.

  /** Central differences of the fourth order. */
  Eigen::MatrixXd
  hessian(const Energy &energy, const Eigen::MatrixXd &places)
  {
    const Eigen::VectorXd x = places.reshaped();
    const double h          = 2e-3;
    // Second derivatives along a direction: f_ab from a + b and a - b.
    const auto along = [&](const Eigen::VectorXd &d) {
      const auto f = [&](const double t) { return energy(x + t * h * d); };
      return (-f(2.) + 16. * f(1.) - 30. * f(0.) + 16. * f(-1.) - f(-2.)) /
             (12. * h * h);
    };
    const Eigen::Index n = x.size();
    Eigen::MatrixXd H(n, n);
    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index b = 0; b <= a; ++b)
        {
          const auto e_a = Eigen::VectorXd::Unit(n, a);
          const auto e_b = Eigen::VectorXd::Unit(n, b);
          H(a, b)        = H(b, a) =
            a == b ? along(e_a) : (along(e_a + e_b) - along(e_a - e_b)) / 4.;
        }
    return H;
  }

  /** P1 of St. Venant-Kirchhoff's material by the stretched edges. */
  double
  st_venant_kirchhoff_energy(const Eigen::MatrixXd &rest,
                             const Eigen::MatrixXd &places,
                             const double lambda,
                             const double mu)
  {
    const int dim    = rest.rows();
    const auto edges = [dim](const Eigen::MatrixXd &x) {
      return Eigen::MatrixXd(x.rightCols(dim).colwise() - x.col(0));
    };
    const Eigen::MatrixXd J = edges(rest);
    const Eigen::MatrixXd F = edges(places) * J.inverse();
    const Eigen::MatrixXd E =
      (F.transpose() * F - Eigen::MatrixXd::Identity(dim, dim)) / 2.;
    const double measure = std::abs(J.determinant()) / (dim == 2 ? 2. : 6.);
    return measure *
           (lambda * E.trace() * E.trace() / 2. + mu * E.squaredNorm());
  }

  Eigen::VectorXd
  coordinate(const Eigen::VectorXd &x, const int dim, const unsigned int node)
  {
    return x.segment(dim * node, dim);
  }

  double
  elongation_of(const FitProblem &problem,
                const NodePair &spring,
                const Eigen::VectorXd &x)
  {
    const int dim           = problem.points.rows();
    const auto [i, j]       = spring;
    const Eigen::VectorXd d = coordinate(x, dim, j) - coordinate(x, dim, i);
    const double L = (problem.points.col(j) - problem.points.col(i)).norm();
    return problem.law == SpringLaw::quadratic
             ? d.norm() - L
             : (d.squaredNorm() - L * L) / (2. * L);
  }

  /** The area of a polygon, the volume of a tetrahedron. */
  double
  measure_of(const CellKind kind, const Eigen::VectorXd &x)
  {
    const auto node = [&](const unsigned int v) {
      return coordinate(x, dimension(kind), v);
    };
    const auto cross = [](const Eigen::VectorXd &a, const Eigen::VectorXd &b) {
      return a[0] * b[1] - a[1] * b[0];
    };
    if (kind == CellKind::triangle)
      return cross(node(1) - node(0), node(2) - node(0)) / 2.;
    if (kind == CellKind::quadrilateral)
      return cross(node(3) - node(0), node(2) - node(1)) / 2.;
    Eigen::Matrix3d J;
    J << node(1) - node(0), node(2) - node(0), node(3) - node(0);
    return J.determinant() / 6.;
  }

  double
  angle_of(const NodeTriple &angle, const int dim, const Eigen::VectorXd &x)
  {
    const Eigen::VectorXd m = coordinate(x, dim, angle[1]);
    const Eigen::VectorXd u = (coordinate(x, dim, angle[0]) - m).normalized();
    const Eigen::VectorXd v = (coordinate(x, dim, angle[2]) - m).normalized();
    return std::acos(u.dot(v));
  }

  /** The energies of all generalised springs of a cell, constants of one. */
  std::vector<Energy>
  unit_energies(const FitProblem &problem, const Enrichment enrichment)
  {
    std::vector<Energy> energies;
    const auto squared = [&](const auto &q) {
      energies.push_back(
        [q](const Eigen::VectorXd &x) { return 0.5 * q(x) * q(x); });
    };
    const int dim = problem.points.rows();
    for (const NodePair &s : problem.springs)
      squared([&problem, s](const Eigen::VectorXd &x) {
        return elongation_of(problem, s, x);
      });
    if (enrichment == Enrichment::volume)
      squared([&problem](const Eigen::VectorXd &x) {
        return measure_of(problem.kind, x) -
               measure_of(problem.kind, problem.points.reshaped());
      });
    if (enrichment == Enrichment::angles)
      for (const NodeTriple &a : cell_angles(problem.kind))
        squared([&problem, a, dim](const Eigen::VectorXd &x) {
          return angle_of(a, dim, x) -
                 angle_of(a, dim, problem.points.reshaped());
        });
    if (enrichment == Enrichment::coupling)
      for (std::size_t a = 0; a < problem.springs.size(); ++a)
        for (std::size_t b = a + 1; b < problem.springs.size(); ++b)
          energies.push_back([&problem, a, b](const Eigen::VectorXd &x) {
            return elongation_of(problem, problem.springs[a], x) *
                   elongation_of(problem, problem.springs[b], x);
          });
    return energies;
  }

  /** The constants of a model in the order of unit_energies(). */
  Eigen::VectorXd
  constants_of(const FitProblem &problem,
               const CellModel &model,
               const Enrichment enrichment)
  {
    const Eigen::VectorXd k = model.k();
    std::vector<double> c(k.begin(), k.end());
    const auto append = [&](const std::string &word) {
      const Eigen::VectorXd others = oracle::constants_of(model, word);
      EXPECT_GT(others.size(), 0);
      c.insert(c.end(), others.begin(), others.end());
    };
    if (enrichment == Enrichment::volume)
      append("volumes");
    if (enrichment == Enrichment::angles)
      append("angles");
    if (enrichment == Enrichment::coupling)
      {
        // Models may leave out couplings of zero.
        const std::size_t n = k.size();
        for (std::size_t a = 0; a < n; ++a)
          for (std::size_t b = a + 1; b < n; ++b)
            {
              const auto [i_a, j_a]                 = problem.springs[a];
              const auto [i_b, j_b]                 = problem.springs[b];
              const std::vector<unsigned int> nodes = {i_a, j_a, i_b, j_b};
              c.push_back(0.);
              for (const auto &family : model.families)
                if (family.kind->word() == "couplings")
                  for (std::size_t m = 0; m < family.size(); ++m)
                    if (std::equal(nodes.begin(), nodes.end(), family.nodes(m)))
                      c.back() = family.members.columns[0][m];
            }
      }
    return Eigen::Map<const Eigen::VectorXd>(c.data(), c.size());
  }

  struct LeastSquares
  {
    Eigen::MatrixXd A;
    Eigen::VectorXd d;

    Eigen::VectorXd
    minimiser() const
    {
      return A.jacobiSvd(Eigen::ComputeThinU | Eigen::ComputeThinV).solve(d);
    }

    double
    relative_residual(const Eigen::VectorXd &c) const
    {
      return (d - A * c).norm() / d.norm();
    }
  };

  LeastSquares
  brute_force(const FitProblem &problem, const Enrichment enrichment)
  {
    const auto energies  = unit_energies(problem, enrichment);
    const Eigen::Index n = problem.stiffness.size();
    LeastSquares equations{Eigen::MatrixXd(n * (1 + problem.states.size()),
                                           energies.size()),
                           Eigen::VectorXd(n * (1 + problem.states.size()))};
    for (std::size_t p = 0; p <= problem.states.size(); ++p)
      {
        Eigen::MatrixXd places = problem.points;
        if (p > 0)
          places += problem.states[p - 1].displacement;
        const Eigen::MatrixXd R =
          p > 0 ? problem.states[p - 1].stiffness : problem.stiffness;
        equations.d.segment(n * p, n) = R.reshaped();
        for (std::size_t m = 0; m < energies.size(); ++m)
          equations.A.block(n * p, m, n, 1) =
            hessian(energies[m], places).reshaped();
      }
    return equations;
  }

  const std::vector<std::string> state_lists = {"stretch x 1.3",
                                                "stretch y 0.8, shear xy 0.3",
                                                "stretch x 1.3 y 0.9"};

  std::vector<DeformedState>
  displaced(const FitProblem &problem, const std::string &list)
  {
    const int dim = problem.points.rows();
    std::vector<DeformedState> states;
    for (const auto &F : parse_states(list, dim, "Fit/States"))
      states.push_back(
        {(F - Eigen::MatrixXd::Identity(dim, dim)) * problem.points, {}});
    return states;
  }

  /** A random simplex of St. Venant-Kirchhoff's material, nu = 0.3. */
  FitProblem
  st_venant_kirchhoff_problem(const CellKind kind,
                              const std::string &list,
                              Random &random)
  {
    FitProblem problem      = fit_problem(random_cell(kind, random), kind, 0.3);
    const Eigen::MatrixXd D = usual_elasticity(kind, 0.3);
    const double lambda = D(0, 1), mu = (D(0, 0) - D(0, 1)) / 2.;
    problem.states = displaced(problem, list);
    for (auto &state : problem.states)
      state.stiffness = hessian(
        [&](const Eigen::VectorXd &x) {
          return st_venant_kirchhoff_energy(problem.points,
                                            x.reshaped(problem.points.rows(),
                                                       problem.points.cols()),
                                            lambda,
                                            mu);
        },
        problem.points + state.displacement);
    return problem;
  }

  /** A random cell whose reference stiffens in its states by an arbitrary
      symmetric matrix. */
  FitProblem
  arbitrary_problem(const CellKind kind,
                    const std::string &list,
                    Random &random)
  {
    FitProblem problem = random_problem(kind, random);
    problem.states     = displaced(problem, list);
    for (auto &state : problem.states)
      {
        const Eigen::MatrixXd S =
          random.matrix(problem.stiffness.rows(), problem.stiffness.cols());
        state.stiffness = problem.stiffness + 0.1 * problem.stiffness.norm() /
                                                S.norm() * (S + S.transpose());
      }
    return problem;
  }

  FitOptions
  with(const Enrichment enrichment, const bool nonnegative = false)
  {
    FitOptions options;
    options.enrichment  = enrichment;
    options.nonnegative = nonnegative;
    return options;
  }

  const std::vector<CellKind> kinds_of_closed_volume = {CellKind::triangle,
                                                        CellKind::quadrilateral,
                                                        CellKind::tetrahedron};

  const std::vector<SpringLaw> laws = {SpringLaw::quadratic,
                                       SpringLaw::biquadratic};


  TEST(SeveralStates, TheFitIsThatOfBruteForce)
  {
    Random random(61);
    for (const CellKind kind : kinds_of_closed_volume)
      for (const auto &list : state_lists)
        for (const SpringLaw law : laws)
          for (const Enrichment enrichment :
               {Enrichment::none, Enrichment::volume, Enrichment::angles})
            {
              FitProblem problem = arbitrary_problem(kind, list, random);
              problem.law        = law;
              const CellModel model =
                fit_over_states(problem,
                                make_cell_terms(problem, enrichment),
                                0);
              const auto equations = brute_force(problem, enrichment);
              const Eigen::VectorXd c =
                constants_of(problem, model, enrichment);
              EXPECT_LT((c - equations.minimiser()).norm(), 1e-5 * c.norm());
              EXPECT_NEAR(residual_over_states(problem, model),
                          equations.relative_residual(c),
                          1e-7);
            }
  }

  TEST(SeveralStates, TheCoupledFitIsThatOfBruteForce)
  {
    Random random(62);
    for (const CellKind kind : {CellKind::triangle, CellKind::tetrahedron})
      for (const auto &list : state_lists)
        for (const SpringLaw law : laws)
          {
            FitProblem problem    = arbitrary_problem(kind, list, random);
            problem.law           = law;
            const CellModel model = fit_coupled_over_states(problem, 0);
            const auto equations  = brute_force(problem, Enrichment::coupling);
            const Eigen::VectorXd c =
              constants_of(problem, model, Enrichment::coupling);
            EXPECT_LT((c - equations.minimiser()).norm(), 1e-5 * c.norm());
          }
  }

  TEST(SeveralStates, WithoutStatesItIsTheFrobeniusFit)
  {
    Random random(63);
    for (const CellKind kind : all_kinds)
      for (const Enrichment enrichment :
           {Enrichment::none, Enrichment::volume, Enrichment::angles})
        for (const bool nonnegative : {false, true})
          {
            const FitProblem problem = slender_problem(kind, random);
            const auto terms         = make_cell_terms(problem, enrichment);
            const auto n = nonnegative ? terms.n_springs : Eigen::Index(0);
            const CellModel model    = fit_over_states(problem, terms, n);
            const CellModel expected = make_cell_model(
              terms, fit_frobenius(terms.gradients, problem.stiffness, n));
            const Eigen::VectorXd c =
              constants_of(problem, expected, enrichment);
            EXPECT_LT((constants_of(problem, model, enrichment) - c).norm(),
                      1e-10 * c.norm());
            EXPECT_NEAR(residual_over_states(problem, model),
                        residual(problem, expected).norm() /
                          problem.stiffness.norm(),
                        1e-10);
          }
  }

  TEST(SeveralStates, NoOtherConstantsAreBetter)
  {
    // With k >= 0 no other feasible ones.
    Random random(64);
    for (const CellKind kind : all_kinds)
      for (const Enrichment enrichment : {Enrichment::none, Enrichment::volume})
        for (const bool nonnegative : {false, true})
          {
            FitProblem problem =
              arbitrary_problem(kind, "shear yx 0.4", random);
            // A volume that softens it asks for negative springs.
            const auto terms = make_cell_terms(problem, enrichment);
            const CellModel best =
              fit_over_states(problem,
                              terms,
                              nonnegative ? terms.n_springs : 0);
            if (nonnegative)
              EXPECT_EQ(n_negative(best.families), 0u);
            const double residual = residual_over_states(problem, best);
            for (int attempt = 0; attempt < 20; ++attempt)
              {
                Eigen::VectorXd c = springfit::constants_of(best.families);
                const Eigen::VectorXd best_k = best.k();
                auto k                       = c.head(best_k.size());
                k += 1e-3 * best_k.norm() * random.matrix(k.size(), 1);
                if (nonnegative)
                  k = k.cwiseMax(0.).eval();
                if (enrichment == Enrichment::volume)
                  c[k.size()] *= 1. + random(-1e-3, 1e-3);
                const CellModel other{with_constants(best.families, c)};
                EXPECT_GT(residual_over_states(problem, other), residual);
              }
          }
  }

  TEST(SeveralStates, BoundsHoldWhereFreeSpringsAreNegative)
  {
    Random random(65);
    int n_bound = 0;
    for (int cell = 0; cell < 20; ++cell)
      {
        FitProblem problem = slender_problem(CellKind::tetrahedron, random);
        problem.states     = displaced(problem, "stretch z 1.3");
        problem.states[0].stiffness = 1.2 * problem.stiffness;
        const auto free =
          fit(problem, method_named("frobenius"), with(Enrichment::none));
        const auto bounded =
          fit(problem, method_named("frobenius"), with(Enrichment::none, true));
        n_bound += free.n_negative > 0;
        EXPECT_EQ(bounded.n_negative, 0u);
        EXPECT_GE(*bounded.states_residual, *free.states_residual - 1e-14);
      }
    EXPECT_GT(n_bound, 5);
  }

  TEST(SeveralStates, BiquadraticCoupledSimplicesAreStVenantKirchhoffs)
  {
    Random random(66);
    for (const CellKind kind : {CellKind::triangle, CellKind::tetrahedron})
      for (const auto &list : state_lists)
        {
          auto problem = st_venant_kirchhoff_problem(kind, list, random);
          problem.law  = SpringLaw::biquadratic;
          const auto result =
            fit(problem, method_named("frobenius"), with(Enrichment::coupling));
          // The energies are polynomials of the fourth degree: the differences
          // are exact up to rounding.
          EXPECT_LT(*result.states_residual, 1e-8);
          const Eigen::VectorXd c = constants_of(problem,
                                                 fit_coupled_cell(problem),
                                                 Enrichment::coupling);
          EXPECT_LT(
            (constants_of(problem, result, Enrichment::coupling) - c).norm(),
            1e-7 * c.norm());

          problem.law = SpringLaw::quadratic;
          EXPECT_GT(residual_over_states(problem, fit_coupled_cell(problem)),
                    1e-2);
        }
  }

  TEST(SeveralStates, CoupledCellsThatGiveWayAreHeld)
  {
    // A reference that gives way in its state drags the fit along.
    Random random(67);
    for (const CellKind kind : {CellKind::triangle, CellKind::tetrahedron})
      {
        FitProblem problem          = random_problem(kind, random);
        problem.states              = displaced(problem, "stretch x 1.2");
        problem.states[0].stiffness = -3. * problem.stiffness;
        const auto free =
          fit(problem, method_named("frobenius"), with(Enrichment::coupling));
        EXPECT_LT(*free.smallest_eigenvalue, -1e-3);
        const auto held = fit(problem,
                              method_named("frobenius"),
                              with(Enrichment::coupling, true));
        EXPECT_EQ(held.n_negative, 0u);
        EXPECT_GT(*held.smallest_eigenvalue, -1e-10);
        EXPECT_LT(*held.states_residual,
                  residual_over_states(problem, fit_coupled_cell(problem)));
      }
  }

  TEST(SeveralStates, OtherFitsHaveNone)
  {
    Random random(68);
    for (const CellKind kind : all_kinds)
      {
        const auto problem = arbitrary_problem(kind, "stretch x 1.2", random);
        for (const auto &[method, word] : method_words())
          for (const auto &[enrichment, name] : enrichment_words())
            {
              const bool expected =
                word == "frobenius" &&
                (enrichment != Enrichment::coupling || is_simplex(kind));
              EXPECT_EQ(has_states(*method, enrichment, kind), expected);
              if (!expected)
                EXPECT_THROW(fit(problem, *method, with(enrichment)),
                             std::logic_error);
            }
      }
  }

  TEST(SeveralStates, AStateThatIsNoNumberIsRefused)
  {
    Random random(69);
    auto problem = arbitrary_problem(CellKind::triangle, "shear xy 1", random);
    problem.states[0].stiffness(0, 0) = std::nan("");
    EXPECT_THROW(fit(problem, method_named("frobenius"), {}), RunError);
  }


  TEST(States, AreReadAsTheyAreWritten)
  {
    EXPECT_TRUE(parse_states("", 3, "Fit/States").empty());
    EXPECT_TRUE(parse_states(" ", 2, "Fit/States").empty());
    EXPECT_EQ(
      parse_states("stretch x 0.1 y 10, stretch x +.5 y 2., shear xy -1e1",
                   2,
                   "Fit/States")
        .size(),
      3u);

    const auto plane =
      parse_states("stretch x 1.3,  shear  yx -0.25 ", 2, "Fit/States");
    ASSERT_EQ(plane.size(), 2u);
    Eigen::MatrixXd F(2, 2);
    F << 1.3, 0., //
      0., 1.;
    EXPECT_EQ(plane[0], F);
    F << 1., 0., //
      -0.25, 1.;
    EXPECT_EQ(plane[1], F);

    const auto solid =
      parse_states("stretch z 0.5 x 2,shear xz 0.1", 3, "Fit/States");
    ASSERT_EQ(solid.size(), 2u);
    F = Eigen::Vector3d(2., 1., 0.5).asDiagonal();
    EXPECT_EQ(solid[0], F);
    F       = Eigen::Matrix3d::Identity();
    F(0, 2) = 0.1;
    EXPECT_EQ(solid[1], F);
  }

  TEST(States, ThatCannotBeReadAreExplained)
  {
    const std::vector<std::pair<std::string, std::string>> cases = {
      {"strech x 1.3", "Did you mean 'stretch'?"},
      {"stretch", "is no stretch"},
      {"stretch x", "is no stretch"},
      {"stretch x 1.3 y", "is no stretch"},
      {"stretch 1.3 x", "names no direction '1.3'"},
      {"stretch z 1.3", "'z', which there is not in 2-d"},
      {"stretch x 1.3 x 1.2", "the direction x twice"},
      {"stretch x 0", "not positive"},
      {"stretch x -1", "not positive"},
      {"stretch x nan", "'nan' in place of a decimal number"},
      {"stretch x 1.3m", "'1.3m' in place of a decimal number"},
      {"stretch x 1", "the state at rest"},
      {"shear xy 0", "the state at rest"},
      {"shear x 0.3", "two different directions"},
      {"shear xx 0.3", "two different directions"},
      {"shear xz 0.3", "'z', which there is not in 2-d"},
      {"shear xy inf", "'inf' in place of a decimal number"},
      {"stretch x 0x2", "'0x2' in place of a decimal number"},
      {"stretch x 1.3f", "'1.3f' in place of a decimal number"},
      {"stretch x .", "'.' in place of a decimal number"},
      {"stretch x 1e9", "a stretch that is not between 0.1 and 10"},
      {"stretch x 1 y 10.01", "a stretch that is not between 0.1 and 10"},
      {"stretch x 0.0999", "a stretch that is not between 0.1 and 10"},
      {"stretch x 1e-9", "a stretch that is not between 0.1 and 10"},
      {"stretch x 1e400", "a stretch that is not between 0.1 and 10"},
      {"shear xy 10.01", "a shear that is not between -10 and 10"},
      {"shear xy -11", "a shear that is not between -10 and 10"},
      {"shear xy", "is no shear"},
      {"shear xy 0.3, shear xy 0.3", "is given twice"}};
    for (const auto &[text, message] : cases)
      try
        {
          parse_states(text, 2, "Fit/States");
          ADD_FAILURE() << text;
        }
      catch (const EntryError &error)
        {
          EXPECT_EQ(error.entry, "Fit/States");
          EXPECT_NE(std::string(error.what()).find(message), std::string::npos)
            << error.what();
        }
  }
} // namespace
