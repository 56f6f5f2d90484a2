// Grids of files for ParaView. tests/output/check_vtu reads whole files.

#include <springfit/core/error.h>
#include <springfit/output/node_grid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <stdexcept>

using namespace springfit;

namespace
{
  /** A file that does not outlive the test. */
  class Vtu : public ::testing::Test
  {
  protected:
    Vtu()
      : path(std::filesystem::temp_directory_path() /
             (std::string("springfit_") +
              ::testing::UnitTest::GetInstance()->current_test_info()->name() +
              ".vtu"))
    {}

    ~Vtu() override
    {
      std::filesystem::remove(path);
    }

    std::string
    text() const
    {
      std::ifstream file(path);
      return {std::istreambuf_iterator<char>(file), {}};
    }

    const std::filesystem::path path;
  };

  /** Three nodes in a row and a vector at each; the first two are a line. */
  UnstructuredGrid
  line()
  {
    Eigen::MatrixXd places(2, 3), vectors(2, 3);
    places << 0., 1., 2., 5., 5., 5.;
    vectors << 1., 2., 3., 4., 5., 6.;
    auto grid = node_grid(places, {{"displacement", vectors}});
    add_cell(grid, VtkCell::line, {1, 2});
    return grid;
  }

  TEST(NodeGrid, PlacesAndVectorsOfThePlaneHaveNoZ)
  {
    const auto grid = line();
    EXPECT_EQ(grid.points.col(1), Eigen::Vector3d(1., 5., 0.));
    ASSERT_EQ(grid.point_data.size(), 2u);
    EXPECT_EQ(grid.point_data[0].name, "node");
    EXPECT_EQ(std::get<Eigen::MatrixXi>(grid.point_data[0].values),
              Eigen::RowVector3i(0, 1, 2));
    const auto &vectors = std::get<Eigen::MatrixXd>(grid.point_data[1].values);
    ASSERT_EQ(vectors.rows(), 3);
    EXPECT_EQ(vectors.col(2), Eigen::Vector3d(3., 6., 0.));
  }

  // Vertices of the unit cube by deal.II's numbers are their coordinates as
  // binary digits, x first; in VTK's order they go around the bottom, then
  // around the top.
  TEST(NodeGrid, AHexahedronRunsAroundItsFaces)
  {
    std::vector<unsigned int> nodes(8);
    std::iota(nodes.begin(), nodes.end(), 0);
    UnstructuredGrid grid;
    add_cell(grid, CellKind::hexahedron, nodes);
    EXPECT_EQ(grid.connectivity,
              (std::vector<std::int32_t>{0, 1, 3, 2, 4, 5, 7, 6}));
    EXPECT_EQ(grid.offsets, std::vector<std::int64_t>{8});
    EXPECT_EQ(grid.types, std::vector<VtkCell>{VtkCell::hexahedron});
  }

  TEST(Grid, LosesItsLoosePoints)
  {
    const auto grid = without_loose_points(line());
    ASSERT_EQ(grid.points.cols(), 2);
    EXPECT_EQ(grid.points.col(0), Eigen::Vector3d(1., 5., 0.));
    EXPECT_EQ(grid.connectivity, (std::vector<std::int32_t>{0, 1}));
    EXPECT_EQ(std::get<Eigen::MatrixXi>(grid.point_data[0].values),
              Eigen::RowVector2i(1, 2));
    EXPECT_EQ(std::get<Eigen::MatrixXd>(grid.point_data[1].values).col(1),
              Eigen::Vector3d(3., 6., 0.));
  }

  TEST_F(Vtu, NamesMayHaveAnyCharacters)
  {
    auto grid               = line();
    grid.point_data[1].name = "a<b & \"c\"";
    write_vtu(path, grid);
    EXPECT_NE(text().find("Name=\"a&lt;b &amp; &quot;c&quot;\""),
              std::string::npos);
  }

  TEST_F(Vtu, RefusesWhatIsNoNumber)
  {
    auto grid                                                  = line();
    std::get<Eigen::MatrixXd>(grid.point_data[1].values)(0, 1) = std::nan("");
    EXPECT_THROW(write_vtu(path, grid), RunError);
    EXPECT_FALSE(std::filesystem::exists(path));
  }

  TEST_F(Vtu, WantsAValueForEachCell)
  {
    auto grid = line();
    grid.cell_data.push_back({"k", Eigen::MatrixXd(1, 2)});
    EXPECT_THROW(write_vtu(path, grid), std::logic_error);
  }

  // Header of no blocks: as VTK writes it.
  TEST_F(Vtu, HasNoBlocksOfNoNumbers)
  {
    write_vtu(path, UnstructuredGrid());
    EXPECT_NE(text().find("Name=\"connectivity\" format=\"binary\">\n"
                          "AAAAAACAAAAAAAAA\n</DataArray>"),
              std::string::npos);
  }

  TEST_F(Vtu, ASeriesKeepsItsTimes)
  {
    write_pvd(path, {{0., "a.vtu"}, {0.1 + 0.2, "b&c.vtu"}});
    EXPECT_NE(text().find("timestep=\"0.30000000000000004\" group=\"\" "
                          "part=\"0\" file=\"b&amp;c.vtu\""),
              std::string::npos);
  }
} // namespace
