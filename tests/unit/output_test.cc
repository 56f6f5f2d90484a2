// The tables of a network, and which names are those of results.

#include <springfit/output/result_names.h>
#include <springfit/output/tables.h>
#include <springfit/springs/by_table.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/lengths.h>
#include <springfit/springs/network.h>
#include <springfit/springs/rest_families.h>
#include <springfit/springs/zero_lengths.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "cells.h"

using namespace springfit;

namespace
{
  /** An empty folder that does not outlive the test. */
  class Output : public ::testing::Test
  {
  protected:
    Output()
      : folder(
          std::filesystem::temp_directory_path() /
          ("springfit_" +
           std::string(
             ::testing::UnitTest::GetInstance()->current_test_info()->name())))
    {
      std::filesystem::remove_all(folder);
      std::filesystem::create_directory(folder);
    }

    ~Output() override
    {
      std::filesystem::remove_all(folder);
    }

    std::set<std::string>
    files() const
    {
      std::set<std::string> names;
      for (const auto &entry : std::filesystem::directory_iterator(folder))
        names.insert(entry.path().filename().string());
      return names;
    }

    std::vector<std::string>
    lines(const std::string &name) const
    {
      std::ifstream file(folder / name);
      std::vector<std::string> all;
      for (std::string line; std::getline(file, line);)
        all.push_back(line);
      return all;
    }

    const std::filesystem::path folder;
  };

  TEST_F(Output, ANetworkHasATableForEachKindOfItsParts)
  {
    const std::vector<unsigned int> vertices = {0, 1, 2};
    const auto &pairs                        = node_pairs(CellKind::triangle);
    const Eigen::MatrixXd x = oracle::regular_cell(CellKind::triangle);
    const SpringLaw law     = SpringLaw::quadratic;
    NetworkBuilder builder(x);
    builder.add(lengths_at_rest(x, pairs, Eigen::Vector3d(1., 2., 3.), law),
                vertices);
    write_network(folder, "f", builder.build());
    EXPECT_EQ(files(), (std::set<std::string>{"springs_f.csv"}));

    const double stiffness = 0.1 + 0.2; // has no short decimal
    builder.add(couplings_at_rest(x, pairs, {{0, 2, 5.}}, law), vertices);
    builder.add(angles_at_rest(x,
                               {{2, 1, 0}},
                               Eigen::VectorXd::Constant(1, stiffness)),
                vertices);
    builder.add(volume_at_rest(x, CellKind::triangle, 7.), vertices);
    write_network(folder, "f", builder.build());
    EXPECT_EQ(files(),
              (std::set<std::string>{"angles_f.csv",
                                     "couplings_f.csv",
                                     "springs_f.csv",
                                     "volumes_f.csv"}));

    EXPECT_EQ(lines("springs_f.csv").at(0), "i,j,k,rest_length");
    EXPECT_EQ(lines("springs_f.csv").size(), 4u);
    const auto couplings = lines("couplings_f.csv");
    ASSERT_EQ(couplings.size(), 2u);
    EXPECT_EQ(couplings[0],
              "i_a,j_a,i_b,j_b,stiffness,rest_length_a,rest_length_b");
    EXPECT_EQ(couplings[1].substr(0, 12), "0,1,1,2,5,1,");
    EXPECT_NEAR(std::stod(couplings[1].substr(12)), 1., 1e-15);
    EXPECT_EQ(lines("volumes_f.csv").at(0), "n0,n1,n2,k,rest_volume");
    const auto angles = lines("angles_f.csv");
    ASSERT_EQ(angles.size(), 2u);
    EXPECT_EQ(angles[0], "a,middle,c,k,rest_angle");
    EXPECT_EQ(angles[1].substr(0, 6), "0,1,2,");
    std::size_t length = 0;
    EXPECT_EQ(std::stod(angles[1].substr(6), &length), stiffness);
    EXPECT_NEAR(std::stod(angles[1].substr(6 + length + 1)),
                std::acos(0.5),
                1e-15);
  }

  TEST(ResultNames, AreThoseThatStudiesWriteAndNoOthers)
  {
    const std::vector<std::string> models = {"fem", "frobenius"};
    for (const std::string name : {"angles_f.csv",
                                   "comparison.csv",
                                   "couplings_f.csv",
                                   "export_tension_frobenius.inp",
                                   "export_a_b_c_nonlinear.npz",
                                   "families.csv",
                                   "sets.csv",
                                   "fem.pvd",
                                   "my_load_frobenius_volume_nonlinear.csv",
                                   "nodes.csv",
                                   "point_volumes_f.csv",
                                   "reactions.csv",
                                   "springs_f.csv",
                                   "sweep.csv",
                                   "tension_fem.csv",
                                   "tension_fem.vtu",
                                   "volumes_f.csv"})
      EXPECT_TRUE(is_result(name, models)) << name;
    for (const std::string name : {"angles.csv",
                                   "comparison.csv.part",
                                   "export.inp",
                                   "motor_frobenius.inp",
                                   "log.txt",
                                   "my_nodes.csv",
                                   "notes.txt",
                                   "used.prm"})
      EXPECT_FALSE(is_result(name, models)) << name;
  }

  TEST(ByTable, LengthsAndZeroLengthsAreOne)
  {
    Family springs(lengths(3, SpringLaw::quadratic));
    Family zero(zero_lengths(3));
    Family other(lengths(3, SpringLaw::biquadratic));
    springs.add({0, 1}, {{2.}, {1.}});
    zero.add({1, 2}, {{3.}, {0.}});
    other.add({0, 2}, {{4.}, {1.}});
    const auto tables = by_table({springs, other, zero});
    ASSERT_EQ(tables.size(), 2u);
    EXPECT_EQ(tables[0].members.nodes, (std::vector<unsigned int>{0, 1, 1, 2}));
    EXPECT_EQ(tables[0].members.columns,
              (std::vector<std::vector<double>>{{2., 3.}, {1., 0.}}));
    EXPECT_EQ(tables[1].members.nodes, other.members.nodes);
  }
} // namespace
