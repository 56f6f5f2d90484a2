// A clamped bar against beam theory, and its motion against a generalised
// eigensolver.

#include <springfit/mesh/objects.h>
#include <springfit/motion/direct_step_system.h>
#include <springfit/motion/integrators.h>
#include <springfit/reference/consistent_mass.h>
#include <springfit/reference/nodal_masses.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/response/linear_body.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "meshes.h"
#include "nonlinear.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  constexpr double length = 0.2, height = 0.01, E = 1e6, density = 1000.;

  /** A plane bar along x, clamped at x = 0, of cells that are squares. */
  struct Bar
  {
    Bar()
      : mesh(build_mesh<2>(find_object("box").describe({2,
                                                        2,
                                                        CellKind::quadrilateral,
                                                        {length, height},
                                                        {height / 4.},
                                                        "",
                                                        1.})))
      , element(make_element<2>(mesh->cell_kind))
      , materials({{0, sheet_material(E, 0.)}})
      , nodes(nodes_of(*mesh))
      , elastic(
          FiniteElementBody<2>(*mesh, element, materials, MaterialLaw::linear),
          2,
          nodes.cols())
    {
      body.elastic         = &elastic;
      body.rounding        = 1e-9;
      body.mass            = nodal_masses(*mesh, element, materials);
      body.consistent_mass = consistent_mass(*mesh, element, materials);
      for (Eigen::Index v = 0; v < nodes.cols(); ++v)
        body.held.insert(body.held.end(), 2, nodes(0, v) < 1e-9);
    }

    std::vector<Eigen::Index>
    free_unknowns() const
    {
      std::vector<Eigen::Index> free;
      for (std::size_t i = 0; i < body.held.size(); ++i)
        if (!body.held[i])
          free.push_back(i);
      return free;
    }

    std::unique_ptr<Mesh<2>> mesh;
    Element<2> element;
    MaterialTable materials;
    Eigen::MatrixXd nodes;
    LinearBody elastic;
    MovingBody body;
  };

  /** Column by column of products with displacements of one unknown. */
  template <typename Product>
  Eigen::MatrixXd
  matrix_of(const Product &product, const Eigen::Index n_nodes)
  {
    Eigen::MatrixXd matrix(2 * n_nodes, 2 * n_nodes);
    for (Eigen::Index i = 0; i < matrix.cols(); ++i)
      {
        Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(2, n_nodes);
        unit.reshaped()[i]   = 1.;
        matrix.col(i)        = product(unit).reshaped();
      }
    return matrix;
  }
} // namespace

TEST(Beam, HasTheFrequenciesOfTheoryAndMovesWithThem)
{
  Bar bar;
  const auto free         = bar.free_unknowns();
  const Eigen::MatrixXd K = matrix_of(
    [&](const Eigen::MatrixXd &u) {
      Eigen::MatrixXd product = 0. * u;
      bar.elastic.add_tangent_product(u, u, product);
      return product;
    },
    bar.nodes.cols());
  const Eigen::MatrixXd M =
    matrix_of([&](
                const Eigen::MatrixXd &u) { return mass_product(bar.body, u); },
              bar.nodes.cols());
  const Eigen::MatrixXd free_K = K(free, free), free_M = M(free, free);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
    free_K, free_M);

  // Roots of cos(a) cosh(a) = -1; frequency a^2 sqrt(E I / (rho A L^4)).
  const double roots[] = {1.875104, 4.694091, 7.854757};
  const double unit =
    std::sqrt(E * height * height / (12. * density)) / (length * length);
  for (unsigned int mode = 0; mode < 3; ++mode)
    {
      const double frequency = std::sqrt(solver.eigenvalues()[mode]);
      // The cells lock by some 2 %, and theory has no shear.
      EXPECT_NEAR(frequency,
                  roots[mode] * roots[mode] * unit,
                  0.04 * frequency);

      MotionState state;
      state.displacement = Eigen::MatrixXd::Zero(2, bar.nodes.cols());
      state.velocity = state.acceleration = state.displacement;
      const Eigen::VectorXd shape         = solver.eigenvectors().col(mode);
      for (std::size_t i = 0; i < free.size(); ++i)
        state.displacement.reshaped()[free[i]] = 1e-3 * shape[i];
      DirectStepSystem system(2, bar.body);
      set_acceleration(bar.body, system, state);
      // It passes rest after a quarter of the period.
      const Eigen::MatrixXd begin = mass_product(bar.body, state.displacement);
      const double step           = 2. * M_PI / frequency / 200.;
      double before = 1., now = 1.;
      while (now > 0.)
        {
          before = now;
          generalised_alpha_step(
            bar.body, system, newmark(0.25, 0.5), {1e-10, 5}, step, state);
          now = begin.cwiseProduct(state.displacement).sum() /
                begin.cwiseProduct(begin).sum();
        }
      const double quarter = state.time - step * now / (now - before);
      EXPECT_NEAR(M_PI / (2. * quarter), frequency, 1e-3 * frequency);
    }
}
