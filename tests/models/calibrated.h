#ifndef springfit_tests_models_calibrated_h
#define springfit_tests_models_calibrated_h

// What the tests of calibration have in common.

#include <springfit/calibration/calibration.h>
#include <springfit/reference/cell_matrices.h>
#include <springfit/springs/gradients.h>
#include <springfit/springs/network.h>
#include <springfit/springs/volume.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "meshes.h"

namespace springfit::oracle
{
  inline MaterialTable
  two_materials()
  {
    const ElasticConstants soft = {1e4, 0.3, 1000.}, stiff = {3e4, 0.2, 2000.};
    return {{0, {soft, lame_constants(soft), 1.}},
            {1, {stiff, lame_constants(stiff), 1.}}};
  }

  template <int dim, int spacedim>
  std::vector<CalibratedNetwork>
  calibrated(const Mesh<dim, spacedim> &mesh,
             const MaterialTable &materials,
             const std::string &entries = " set Methods = block, frobenius\n",
             const MaterialLaw law      = MaterialLaw::linear)
  {
    const auto folder =
      std::filesystem::temp_directory_path() /
      ("springfit_calibration_test_" + std::to_string(getpid()));
    Session session(MPI_COMM_SELF, folder);
    const auto section =
      make_step<FitSection<spacedim>>("subsection Fit\n" + entries + "end");
    auto networks = calibrate(*section,
                              mesh,
                              make_element<dim, spacedim>(mesh.cell_kind),
                              materials,
                              {},
                              law,
                              session);
    std::filesystem::remove_all(folder);
    return networks;
  }

  /** The number of springs of a kind: "springs", "couplings", ... */
  inline std::size_t
  number_of(const std::string &word, const SpringNetwork &network)
  {
    std::size_t n = 0;
    for (const auto &family : network.families)
      if (family.kind->word() == word)
        n += family.size();
    return n;
  }

  /**
   * The tangent of one spring at rest with respect to its nodes, which are the
   * columns of @p x. Its rest values must be those of its nodes' places.
   */
  inline Eigen::MatrixXd
  tangent_at_rest(const std::string &word,
                  const std::vector<std::vector<double>> &numbers,
                  const Eigen::MatrixXd &x)
  {
    const Eigen::Index dim = x.rows();
    const double k         = numbers[0].at(0);
    const auto expect_rest = [&](const double q, const std::size_t column) {
      EXPECT_NEAR(q, numbers[column].at(0), 1e-12 * std::abs(q));
    };
    if (word == "springs")
      {
        expect_rest((x.col(1) - x.col(0)).norm(), 1);
        const Eigen::VectorXd b = length_gradients(x, {{{0, 1}}});
        return k * b * b.transpose();
      }
    if (word == "couplings")
      {
        expect_rest((x.col(1) - x.col(0)).norm(), 1);
        expect_rest((x.col(3) - x.col(2)).norm(), 2);
        const Eigen::MatrixXd b    = length_gradients(x, {{{0, 1}}, {{2, 3}}});
        const Eigen::MatrixXd term = k * b.col(0) * b.col(1).transpose();
        return term + term.transpose();
      }
    if (word == "angles")
      {
        const Eigen::VectorXd u = x.col(0) - x.col(1);
        const Eigen::VectorXd v = x.col(2) - x.col(1);
        const double cosine     = u.normalized().dot(v.normalized());
        const double sine       = std::sqrt(1. - cosine * cosine);
        EXPECT_NEAR(std::acos(cosine), numbers[1].at(0), 1e-12);
        Eigen::VectorXd g(3 * dim);
        g.head(dim) =
          (cosine * u.normalized() - v.normalized()) / (sine * u.norm());
        g.tail(dim) =
          (cosine * v.normalized() - u.normalized()) / (sine * v.norm());
        g.segment(dim, dim) = -g.head(dim) - g.tail(dim);
        return k * g * g.transpose();
      }
    EXPECT_EQ(word, "volumes");
    const CellKind kind      = cell_kind(dim, x.cols());
    const double rest_volume = numbers[1].at(0);
    // That of the representative, scaled by the third power of a ratio.
    EXPECT_NEAR(volume(x, kind), rest_volume, 1e-13 * rest_volume);
    EXPECT_GT(rest_volume, 0.);
    const Eigen::VectorXd g = volume_gradient(x, kind);
    return k * g * g.transpose();
  }

  /** The tangent at rest of a network, spring by spring. */
  inline Eigen::MatrixXd
  tangent_at_rest(const SpringNetwork &network)
  {
    const Eigen::Index dim = network.nodes.rows();
    Eigen::MatrixXd K =
      Eigen::MatrixXd::Zero(network.nodes.size(), network.nodes.size());
    for (const auto &family : network.families)
      for (std::size_t m = 0; m < family.size(); ++m)
        {
          const unsigned int *nodes = family.nodes(m);
          const unsigned int n      = family.kind->n_nodes();
          Eigen::MatrixXd x(dim, n);
          for (unsigned int a = 0; a < n; ++a)
            x.col(a) = network.nodes.col(nodes[a]);
          const Eigen::MatrixXd of_member =
            tangent_at_rest(family.kind->word(), family.numbers(m), x);
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              K.block(dim * nodes[a], dim * nodes[b], dim, dim) +=
                of_member.block(dim * a, dim * b, dim, dim);
        }
    return K;
  }
} // namespace springfit::oracle

#endif
