#include <springfit/mesh/geometry.h>
#include <springfit/studies/mixed_body.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "calibrated.h"

using namespace springfit;

namespace
{
  CalibratedScene<3>
  calibrated_box(const std::string &cells, const std::string &fits)
  {
    CalibratedScene<3> scene;
    scene.mesh =
      oracle::make_step<Geometry<3>>(
        "subsection Geometry\n set Object = box\n set Cells = " + cells +
        "\n set Size = 0.02, 0.02, 0.02\n set Cell size = "
        "0.01\n set Jitter = 0.1\nend")
        ->create(MPI_COMM_SELF, "");
    scene.element   = make_element<3>(scene.mesh->cell_kind);
    scene.materials = oracle::two_materials();
    scene.networks  = oracle::calibrated(*scene.mesh, scene.materials, fits);
    return scene;
  }

  Eigen::MatrixXd
  forces_of(const ElasticBody &body, const Eigen::MatrixXd &displacement)
  {
    Eigen::MatrixXd forces = 0. * displacement;
    body.add_forces(displacement, forces);
    return forces;
  }

  /**
   * What all cells together miss is the difference of the bodies' forces,
   * whichever models they have.
   */
  void
  miss_what_the_bodies_differ_by(const std::string &cells,
                                 const MaterialLaw law,
                                 const Kinematics kinematics)
  {
    const auto scene = calibrated_box(
      cells,
      " set Methods = frobenius, stable neo-hookean\n set Enrichment = none, "
      "volume\n");
    const MixedBody<3, 3> mixed(scene, law, kinematics);
    oracle::Random random(5);
    const auto &nodes = scene.mesh->nodes;
    Eigen::MatrixXd u(3, nodes.size());
    for (Eigen::Index i = 0; i < u.size(); ++i)
      u.data()[i] = random(-5e-4, 5e-4);

    std::vector<unsigned int> models(
      scene.mesh->triangulation.n_active_cells());
    for (std::size_t c = 0; c < models.size(); ++c)
      models[c] = c % mixed.n_models();
    Eigen::MatrixXd missing = 0. * u;
    for (std::size_t c = 0; c < models.size(); ++c)
      {
        const auto of_cell = mixed.missing_forces(c, u)[models[c]];
        for (std::size_t a = 0; a < nodes.of_cells[c].size(); ++a)
          missing.col(nodes.of_cells[c][a]) += of_cell.col(a);
      }

    Eigen::MatrixXd of_body;
    const auto body = mixed.body(models);
    if (kinematics == Kinematics::nonlinear)
      of_body = forces_of(*body, u);
    else
      {
        of_body = 0. * u;
        body->add_tangent_product(0. * u, -u, of_body);
      }
    const auto exact = forces_of(*mixed.exact_body(), u);
    EXPECT_LT((missing - (exact - of_body)).norm(), 1e-12 * exact.norm());
    EXPECT_GT(missing.norm(), 1e-3 * exact.norm());
  }
} // namespace

TEST(MixedBody, MissesWhatTheBodiesDifferBy)
{
  for (const std::string cells : {"tetrahedra", "hexahedra"})
    {
      miss_what_the_bodies_differ_by(cells,
                                     MaterialLaw::linear,
                                     Kinematics::linear);
      miss_what_the_bodies_differ_by(cells,
                                     MaterialLaw::stable_neo_hookean,
                                     Kinematics::nonlinear);
    }
}

TEST(MixedBody, OfTheExactNetworkMissesNothing)
{
  const auto scene =
    calibrated_box("tetrahedra",
                   " set Methods = stable neo-hookean\n set Enrichment = "
                   "volume\n");
  const MixedBody<3, 3> mixed(scene,
                              MaterialLaw::stable_neo_hookean,
                              Kinematics::nonlinear);
  Eigen::MatrixXd u = 0.2 * oracle::nodes_of(*scene.mesh);
  u.row(0) *= 2.;
  const double size = forces_of(*mixed.exact_body(), u).norm();
  for (unsigned int c = 0; c < scene.mesh->triangulation.n_active_cells(); ++c)
    EXPECT_LT(mixed.missing_forces(c, u)[0].norm(), 1e-12 * size);
}
