#include <springfit/response/distributed_body.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/response/linear_solver.h>
#include <springfit/response/network_body.h>
#include <springfit/response/newton.h>
#include <springfit/response/statics.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nonlinear.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  /** A bar along x of side 0.03, held at x = 0, pulled with a stress. */
  template <int dim>
  struct Bar
  {
    Random random{25};
    std::unique_ptr<Mesh<dim>> mesh = box_mesh<dim>(3, 0.03, 0.2, random);
    Element<dim> element            = make_element<dim>(mesh->cell_kind);
    Eigen::MatrixXd nodes           = nodes_of(*mesh);
    Discretization<dim> discretization{*mesh, held(), MPI_COMM_SELF};

    std::vector<bool>
    held() const
    {
      std::vector<bool> fixed;
      for (Eigen::Index v = 0; v < nodes.cols(); ++v)
        fixed.push_back(nodes(0, v) < 1e-9);
      return unknowns_of(dim, fixed);
    }

    Eigen::MatrixXd
    pull(const double stress, const double thickness) const
    {
      Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(dim, nodes.cols());
      const double cell      = 0.01;
      for (Eigen::Index v = 0; v < nodes.cols(); ++v)
        if (nodes(0, v) > 0.03 - 1e-9)
          {
            double area = thickness;
            for (int d = 1; d < dim; ++d)
              area *= nodes(d, v) < 1e-9 || nodes(d, v) > 0.03 - 1e-9
                        ? 0.5 * cell
                        : cell;
            forces(0, v) = stress * area;
          }
      return forces;
    }
  };
} // namespace

TEST(NonlinearStatics, NeoHookeanBarWithoutLateralContraction)
{
  // nu = 0: P = mu (s - 1/s), s the stretch.
  const Bar<3> bar;
  const auto statics = make_step<Statics<3>>(
    "subsection Response\n set Material law = neo-hookean\nend");
  for (const double P : {8e3, -1.5e3})
    {
      const auto found = statics
                           ->finite_elements(bar.discretization,
                                             *bar.mesh,
                                             bar.element,
                                             {{0, solid_material(1e4, 0.)}})
                           ->respond(load_of_forces(bar.pull(P, 1.)));
      const double p           = P / 5e3;
      const double s           = 0.5 * (p + std::sqrt(p * p + 4.));
      Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(3, bar.nodes.cols());
      expected.row(0)          = (s - 1.) * bar.nodes.row(0);
      EXPECT_EQ(found.load_fraction, 1.);
      EXPECT_LT((found.displacement - expected).norm(), 1e-8 * expected.norm());
    }
}

TEST(NonlinearStatics, TinyLoadsGiveTheLinearResponse)
{
  // The forces' rounding errors are a part of the load far above the
  // tolerance; strains of 1e-8 are what sets the models apart.
  const Bar<3> bar;
  const MaterialTable materials = {{0, solid_material(1e4, 0.3)}};
  Random random(29);
  const auto network = full_network(*bar.mesh, random);
  const auto statics = make_step<Statics<3>>(
    "subsection Response\n set Material law = neo-hookean\n"
    " set Tolerance = 1e-15\nend");
  const auto check =
    [&](const Model &linear, const Model &nonlinear, const double stress) {
      const Eigen::MatrixXd forces = bar.pull(stress, 1.);
      const auto expected          = linear.respond(load_of_forces(forces));
      const auto found             = nonlinear.respond(load_of_forces(forces));
      EXPECT_EQ(found.failure, "");
      EXPECT_LT((found.displacement - expected.displacement).norm(),
                1e-6 * expected.displacement.norm());
    };
  check(*statics->finite_elements_of(MaterialLaw::linear,
                                     bar.discretization,
                                     *bar.mesh,
                                     bar.element,
                                     materials),
        *statics->finite_elements(
          bar.discretization, *bar.mesh, bar.element, materials),
        1e-4);
  const auto springs = [&](const Kinematics kinematics) {
    return statics->springs(
      bar.discretization, *bar.mesh, bar.element, network, "test", kinematics);
  };
  // Springs of 1 N/m in cells of 0.01 m.
  check(*springs(Kinematics::linear), *springs(Kinematics::nonlinear), 1e-6);
}

TEST(NonlinearStatics, AColumnBucklesWhereEulerSays)
{
  // A cantilever as thick as it is long is no slender column, but Euler's
  // stress pi^2 E / 48 is near.
  const Bar<3> bar;
  const auto statics = make_step<Statics<3>>(
    "subsection Response\n set Material law = neo-hookean\nend");
  const auto found = statics
                       ->finite_elements(bar.discretization,
                                         *bar.mesh,
                                         bar.element,
                                         {{0, solid_material(1e4, 0.)}})
                       ->respond(load_of_forces(bar.pull(-6e3, 1.)));
  const double euler = M_PI * M_PI * 1e4 / 48.;
  EXPECT_NEAR(found.load_fraction * 6e3, euler, 0.3 * euler);
  EXPECT_NE(found.failure.find("buckles"), std::string::npos);
}

TEST(NonlinearStatics, ALoadBeyondTheLimitSaysHowFarItGot)
{
  // St. Venant-Kirchhoff, nu = 0: P = E (s^3 - s) / 2 has its minimum
  // -E / (3 sqrt 3) at s = 1 / sqrt 3; no material carries more compression.
  // On one layer across nothing can buckle before.
  const Bar<2> bar;
  const auto statics = make_step<Statics<2>>(
    "subsection Response\n set Material law = st venant-kirchhoff\nend");
  const auto model   = statics->finite_elements(bar.discretization,
                                              *bar.mesh,
                                              bar.element,
                                              {{0, sheet_material(1e4, 0.)}});
  const double limit = 1e4 / (3. * std::sqrt(3.));
  const auto carried =
    model->respond(load_of_forces(bar.pull(-0.5 * limit, 0.5)));
  EXPECT_TRUE(carried.failure.empty());
  const auto found = model->respond(load_of_forces(bar.pull(-2. * limit, 0.5)));
  EXPECT_LE(found.load_fraction, 0.5);
  EXPECT_GT(found.load_fraction, 0.25);
  EXPECT_NE(found.failure.find("% of the load"), std::string::npos);
  EXPECT_TRUE(found.displacement.allFinite());
  EXPECT_GT(found.displacement.norm(), 0.);
}

TEST(Newton, ConvergesQuadratically)
{
  const Bar<3> bar;
  const auto material                = solid_material(1e4, 0.3);
  const SolverFactory<3> make_solver = [](const auto &matrix) {
    return make_direct_solver<3>(matrix);
  };
  Eigen::MatrixXd forces = bar.pull(1e3, 1.);
  forces.row(1)          = 0.3 * forces.row(0);
  Random random(26);
  const auto network = full_network(*bar.mesh, random);
  const NetworkBody springs(network);
  for (const auto law : hyperelastic)
    {
      const FiniteElementBody<3> cells(*bar.mesh,
                                       bar.element,
                                       {{0, material}},
                                       law);
      for (const BodyOfMembers *body :
           {static_cast<const BodyOfMembers *>(&cells),
            static_cast<const BodyOfMembers *>(&springs)})
        {
          const double scale = body == &springs ? 1e-2 : 1.;
          const double load  = scale * forces.norm();
          DistributedBody<3> distributed(bar.discretization, *body);
          const auto result =
            newton<3>(bar.discretization,
                      distributed,
                      make_solver,
                      bar.discretization.to_vector(scale * forces),
                      Eigen::MatrixXd::Zero(3, bar.nodes.cols()),
                      1e-11 * load);
          EXPECT_EQ(result.failure, "");
          const auto &r = result.residuals;
          ASSERT_GE(r.size(), 4u);
          // The order from the last three residuals above rounding.
          std::size_t last = r.size() - 1;
          while (last > 3 && r[last] < 1e-12 * load)
            --last;
          const double order = std::log(r[last] / r[last - 1]) /
                               std::log(r[last - 1] / r[last - 2]);
          EXPECT_GT(order, 1.7);
        }
    }
}

namespace
{
  /** Two springs between (-1, 0), (1, 0), both held, and (0, h). */
  SpringNetwork
  shallow_truss(const Mesh<2> &mesh, const double k)
  {
    const Eigen::MatrixXd points = nodes_of(mesh);
    NetworkBuilder builder(points);
    builder.add(lengths_at_rest(points,
                                node_pairs(CellKind::triangle),
                                Eigen::Vector3d(1., k, k),
                                SpringLaw::quadratic),
                {0, 1, 2});
    return builder.build();
  }
} // namespace

TEST(NonlinearSprings, ShallowTrussFollowsItsCurveUpToTheLimit)
{
  // von Mises' truss: with y the height of the apex and l = sqrt(1 + y^2) the
  // load is F = 2 k (L - l) y / l.
  const double h = 0.5, k = 10.;
  Eigen::MatrixXd points(2, 3);
  points << -1., 1., 0., 0., 0., h;
  const auto mesh    = single_cell_mesh<2>(CellKind::triangle, points);
  const auto element = make_element<2>(mesh->cell_kind);
  const auto network = shallow_truss(*mesh, k);
  const Discretization<2> discretization(*mesh,
                                         unknowns_of(2, {true, true, false}),
                                         MPI_COMM_SELF);
  const auto statics = make_step<Statics<2>>("");
  const auto model   = statics->springs(
    discretization, *mesh, element, network, "test", Kinematics::nonlinear);
  const double L   = std::sqrt(1. + h * h);
  const auto force = [&](const double y) {
    const double l = std::sqrt(1. + y * y);
    return 2. * k * (L - l) * y / l;
  };
  double limit = 0.;
  for (double y = 0.; y < h; y += 1e-4)
    limit = std::max(limit, force(y));

  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(2, 3);
  forces(1, 2)           = -force(0.45);
  const auto found       = model->respond(load_of_forces(forces));
  EXPECT_TRUE(found.failure.empty());
  EXPECT_NEAR(h + found.displacement(1, 2), 0.45, 1e-9);
  EXPECT_NEAR(found.displacement(0, 2), 0., 1e-9);

  // Beyond the limit the truss snaps through: the cell turns inside out.
  forces(1, 2)       = -1.5 * limit;
  const auto snapped = model->respond(load_of_forces(forces));
  EXPECT_LE(snapped.load_fraction, 1. / 1.5);
  EXPECT_GT(snapped.load_fraction, 1. / 1.5 - 0.02);
  EXPECT_NE(snapped.failure.find("turn inside out"), std::string::npos);
}
