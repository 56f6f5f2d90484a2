#include <springfit/calibration/calibration.h>
#include <springfit/calibration/object_scope.h>

#include <gtest/gtest.h>

#include <string>

#include "calibrated.h"

using namespace springfit;
using oracle::calibrated;
using oracle::number_of;
using oracle::tangent_at_rest;
using oracle::two_materials;

namespace
{
  constexpr double youngs_modulus = 1e4; // of two_materials()

  /** R - K of a network on a mesh. */
  template <int dim>
  Eigen::MatrixXd
  missed(const Mesh<dim> &mesh, const SpringNetwork &network)
  {
    return Eigen::MatrixXd(object_stiffness(mesh,
                                            make_element<dim>(mesh.cell_kind),
                                            two_materials())) -
           tangent_at_rest(network);
  }
} // namespace

TEST(ObjectScope, OfASingleCellIsThatOfTheCell)
{
  oracle::Random random(331);
  const auto mesh = oracle::single_cell_mesh<3>(
    CellKind::hexahedron, oracle::random_cell(CellKind::hexahedron, random));
  for (const std::string nonnegative : {"false", "true"})
    {
      const std::string entries =
        " set Methods = frobenius, compliance\n set Nonnegative = " +
        nonnegative + "\n";
      const auto cell = calibrated(*mesh, two_materials(), entries);
      const auto object =
        calibrated(*mesh, two_materials(), entries + " set Scope = object\n");
      ASSERT_EQ(object.size(), 2u);
      for (int n : {0, 1})
        {
          EXPECT_LT((tangent_at_rest(cell[n].network) -
                     tangent_at_rest(object[n].network))
                      .norm(),
                    1e-6 * youngs_modulus);
          EXPECT_NEAR(object[n].cells[0].result.spectral_residual,
                      cell[n].cells[0].result.spectral_residual,
                      1e-4);
          EXPECT_NEAR(object[n].cells[0].result.frobenius_residual,
                      cell[n].cells[0].result.frobenius_residual,
                      1e-8);
        }
    }
}

/** Couplings of all lengths reproduce P1 exactly. */
TEST(ObjectScope, CouplingsOfASimplexAreItsStiffness)
{
  oracle::Random random(332);
  const auto mesh = oracle::single_cell_mesh<3>(
    CellKind::tetrahedron, oracle::random_cell(CellKind::tetrahedron, random));
  for (const auto &network :
       calibrated(*mesh,
                  two_materials(),
                  " set Methods = frobenius, compliance\n"
                  " set Enrichment = coupling\n set Scope = object\n"))
    {
      EXPECT_EQ(number_of("couplings", network.network), 15u);
      EXPECT_LT(missed(*mesh, network.network).norm(), 1e-6 * youngs_modulus);
    }
}

/** Fits cell by cell are among those that the object can choose from. */
TEST(ObjectScope, FrobeniusIsBelowThatOfTheCells)
{
  oracle::Random random(333);
  const auto mesh = oracle::box_mesh<3>(2, 1., 0.2, random);
  for (const std::string nonnegative : {"false", "true"})
    {
      const std::string entries = " set Methods = frobenius\n"
                                  " set Nonnegative = " +
                                  nonnegative + "\n";
      const auto cell = calibrated(*mesh, two_materials(), entries);
      const auto object =
        calibrated(*mesh, two_materials(), entries + " set Scope = object\n");
      const double error = missed(*mesh, object[0].network).norm();
      EXPECT_LT(error, 0.999 * missed(*mesh, cell[0].network).norm());
      EXPECT_NEAR(error / (missed(*mesh, object[0].network) +
                           tangent_at_rest(object[0].network))
                            .norm(),
                  object[0].cells[0].result.frobenius_residual,
                  1e-10);
      EXPECT_EQ(object[0].network.mass, cell[0].network.mass);
    }
}
