// The tensile specimen of Natsupakpong and Cavusoglu (2010): its outline and
// its meshes.

#include <springfit/mesh/objects.h>
#include <springfit/mesh/specimen_outline.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "measures.h"
#include "messages.h"
#include "scene.h"

using namespace springfit;

namespace
{
  const SpecimenOutline specimen = {0.16, 0.03};

  constexpr double specimen_area = 36e-4; // B^2: 2 x 9 + 2 x 4 x 2 + 2

  double
  second_difference(const std::function<double(double)> &f,
                    const double x,
                    const double h)
  {
    return (f(x - h) - 2. * f(x) + f(x + h)) / (h * h);
  }
} // namespace


TEST(SpecimenOutline, HasThePublishedProportions)
{
  const double B = 0.01;
  EXPECT_NEAR(specimen.straight_part().lowest, 7. * B, 1e-15);
  EXPECT_NEAR(specimen.straight_part().length(), 2. * B, 1e-15);
  EXPECT_NEAR(specimen.transition_length(), 4. * B, 1e-15);
  for (const double x : {0., 1., 3., 13., 14.5, 16.})
    EXPECT_NEAR(specimen.half_width(x * B), 1.5 * B, 1e-15);
  for (const double x : {7., 8., 8.7, 9.})
    EXPECT_NEAR(specimen.half_width(x * B), 0.5 * B, 1e-15);
  EXPECT_NEAR(specimen.half_width(5. * B), B, 1e-15); // half-way
  EXPECT_NEAR(specimen.half_width(11. * B), B, 1e-15);
}

TEST(SpecimenOutline, HasContinuousSecondDerivatives)
{
  // Where its parts meet, slope and curvature are those of a straight line.
  const auto w = [](const double x) { return specimen.half_width(x); };
  // The step's largest second derivative is 10 / sqrt(3), at t = 0.211.
  const double largest = 0.01 / (0.04 * 0.04) * 10. / std::sqrt(3.);
  // Next to them, the half width changes by 0.01 m x 10 (h / 0.04 m)^3.
  for (const double x : {0.03, 0.07, 0.09, 0.13})
    for (const double h : {1e-3, 1e-4})
      {
        EXPECT_LT(std::abs(w(x + h) - w(x - h)) / (2. * h), 8e2 * h * h);
        EXPECT_LT(std::abs(second_difference(w, x, h)), 1.6e3 * h);
      }
  EXPECT_NEAR(second_difference(w, 0.09 + 0.04 * 0.2113248654, 1e-5),
              largest,
              1e-3 * largest);

  // Nowhere does the second derivative jump.
  const double h = 1e-5;
  for (double x = 0.02; x < 0.14; x += h)
    EXPECT_LT(std::abs(second_difference(w, x + h, h) -
                       second_difference(w, x, h)),
              0.01 / std::pow(0.04, 3) * 60. * h * 1.01);
}

TEST(Specimen, OfPlaneCellsHasItsAreaAndItsBoundaries)
{
  const double contour = arc_length(
    [](const double x) {
      return std::array<double, 2>{{x, specimen.half_width(x)}};
    },
    0.,
    0.16);
  for (const std::string cells : {"triangles", "quadrilaterals"})
    {
      double last_error = 1.;
      for (const double h : {0.008, 0.004, 0.002})
        {
          const auto mesh = make_mesh<2>("Object = specimen; Cells = " + cells +
                                         "; Cell size = " + std::to_string(h));
          expect_boundaries(*mesh,
                            {"x min", "x max", "y min", "y max"},
                            {0.03, 0.03, contour, contour},
                            0.004);
          // Chords of length h miss an area as h^2.
          const double error = std::abs(measure_of(*mesh) / specimen_area - 1.);
          EXPECT_LT(error, 200. * h * h);
          EXPECT_LT(error, std::max(0.5 * last_error, 1e-12));
          last_error = error;
          ASSERT_TRUE(mesh->straight_part);
          EXPECT_NEAR(mesh->straight_part->lowest, 0.07, 1e-15);
          EXPECT_NEAR(mesh->straight_part->highest, 0.09, 1e-15);
        }
    }
}

TEST(Specimen, OfSpaceCellsHasItsVolumeAndItsBoundaries)
{
  const double thickness = 0.01;
  const double contour =
    thickness * arc_length(
                  [](const double x) {
                    return std::array<double, 2>{{x, specimen.half_width(x)}};
                  },
                  0.,
                  0.16);
  for (const std::string cells : {"tetrahedra", "hexahedra"})
    {
      const auto mesh  = make_mesh<3>("Object = specimen; Cell size = 0.004; "
                                      "Cells = " +
                                     cells);
      const double end = 0.03 * thickness;
      expect_boundaries(
        *mesh,
        {"x min", "x max", "y min", "y max", "z min", "z max"},
        {end, end, contour, contour, specimen_area, specimen_area},
        0.004);
      EXPECT_NEAR(measure_of(*mesh),
                  specimen_area * thickness,
                  3e-3 * specimen_area * thickness);
      ASSERT_TRUE(mesh->straight_part);
      EXPECT_NEAR(mesh->straight_part->length(), 0.02, 1e-15);
    }
}

TEST(Specimen, HasItsOutlineForItsBoundary)
{
  for (const std::string cells : {"triangles", "quadrilaterals"})
    {
      const auto mesh =
        make_mesh<2>("Object = specimen; Cell size = 0.005; Cells = " + cells);
      for (const auto &face : mesh->triangulation.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() > 1)
          {
            for (const unsigned int v : face->vertex_indices())
              EXPECT_NEAR(std::abs(face->vertex(v)[1]),
                          specimen.half_width(face->vertex(v)[0]),
                          1e-15);
          }
    }
}

TEST(Specimen, HasCellsOfOneProportion)
{
  // Twice as long as wide everywhere, up to the rounding of their numbers.
  const auto mesh =
    make_mesh<2>("Object = specimen; Cell size = 0.001, 0.0005");
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    {
      const double length = cell->vertex(1)[0] - cell->vertex(0)[0];
      const double width  = cell->vertex(2)[1] - cell->vertex(0)[1];
      EXPECT_NEAR(length / width, 2., 0.15);
    }
}

TEST(Specimen, HasThePublishedCounts)
{
  const auto plane =
    make_mesh<2>("Object = specimen; Cells = triangles; Cell size = 0.0075");
  expect_counts_near(*plane, 125, 192, 0.08);
  EXPECT_GT(worst_shape_quality(*plane), 0.7);
  const auto mapped =
    make_mesh<2>("Object = specimen; Cell size = 0.0029, 0.0025");
  expect_counts_near(*mapped, 329, 266, 0.05);
  EXPECT_GT(worst_shape_quality(*mapped), 0.9);
  const auto solid =
    make_mesh<3>("Object = specimen; Cells = tetrahedra; Cell size = 0.00598");
  expect_counts_near(*solid, 538, 1500, 0.05);
  EXPECT_GT(worst_shape_quality(*solid), 0.1);
  const auto layers =
    make_mesh<3>("Object = specimen; Cell size = 0.0028, 0.0025, 0.0033");
  expect_counts_near(*layers, 4 * 349, 3 * 281, 0.04);
  EXPECT_GT(worst_shape_quality(*layers), 0.9);
}

TEST(Specimen, HasASizeThatScalesItsOutline)
{
  const auto mesh =
    make_mesh<2>("Object = specimen; Size = 0.32, 0.015; Cell size = 0.002");
  EXPECT_NEAR(measure_of(*mesh), specimen_area, 1e-3 * specimen_area);
  EXPECT_NEAR(mesh->straight_part->lowest, 0.14, 1e-15);
}

TEST(Specimen, KeepsItsStraightPartOnTheWayToOtherRanks)
{
  for (const std::string object : {"specimen", "box"})
    {
      const auto sent = find_object(object).describe(
        {2, 2, CellKind::quadrilateral, {0.16, 0.03}, {0.005}, "", 1.});
      const auto received = dealii::Utilities::unpack<MeshDescription>(
        dealii::Utilities::pack(sent));
      EXPECT_EQ(received.vertices, sent.vertices);
      ASSERT_EQ(received.straight_part.has_value(), object == "specimen");
      if (received.straight_part)
        {
          EXPECT_EQ(received.straight_part->lowest, sent.straight_part->lowest);
          EXPECT_EQ(received.straight_part->highest,
                    sent.straight_part->highest);
        }
    }
}

TEST(Specimen, OfOneCellAcrossItsStraightPartGivesAWarning)
{
  const auto warnings = [](const CellKind kind,
                           const std::vector<double> &cell_size) {
    const bool plane = dimension(kind) == 2;
    return find_object("specimen")
      .describe({dimension(kind),
                 dimension(kind),
                 kind,
                 plane ? std::vector<double>{0.16, 0.03}
                       : std::vector<double>{0.16, 0.03, 0.01},
                 cell_size,
                 "",
                 1.})
      .warnings;
  };
  // Mapped meshes have as many cells everywhere as at half the grip's width.
  for (const auto &[size, n_across] :
       std::vector<std::pair<double, int>>{{0.015, 1}, {0.0075, 2}, {0.005, 3}})
    for (const auto &found :
         {warnings(CellKind::quadrilateral, {0.005, size}),
          warnings(CellKind::hexahedron, {0.005, size, 0.005})})
      {
        ASSERT_EQ(found.size(), n_across == 1 ? 1u : 0u);
        if (n_across == 1)
          {
            EXPECT_NE(found[0].find("one cell wide"), std::string::npos);
          }
      }
  // gmsh's tetrahedra as large as the straight part is wide.
  EXPECT_EQ(warnings(CellKind::tetrahedron, {0.01}).size(), 1u);
  for (const CellKind kind : {CellKind::triangle, CellKind::tetrahedron})
    EXPECT_TRUE(warnings(kind, {0.003}).empty());
}

TEST(Specimen, HasItsOwnSize)
{
  EXPECT_NEAR(measure_of(*make_mesh<2>("Object = specimen; Size = ")),
              specimen_area,
              1e-3 * specimen_area);
}

TEST(Specimen, IsNotMadeOfWrongEntries)
{
  using Case = std::pair<std::string, std::vector<std::string>>;
  for (const auto &[entries, words] : std::vector<Case>{
         {"Cell size = 0.02",
          {"Geometry/Cell size", "transition", "0.01 (in m) or less"}},
         {"Cell size = 0.0101, 0.005",
          {"0.0101 along x", "0.01 (in m) along x or less"}},
         {"Cell size = 0.005, 0.02",
          {"0.02 along y", "0.01 (in m) along y or less"}},
         {"Size = 0.16, 0.015; Cell size = 0.006", {"0.005 (in m) or less"}}})
    expect_error([&,
                  e = entries]() { make_mesh<2>("Object = specimen; " + e); },
                 words);
  expect_error(
    []() {
      make_mesh<3>("Object = specimen; Cells = tetrahedra; "
                   "Cell size = 0.004; Size = 0.16, 0.03, 0.002");
    },
    {"thickness", "0.002 (in m) or less"});

  // The largest cells that are allowed do make a mesh.
  EXPECT_GT(worst_shape_quality(*make_mesh<2>("Object = specimen; "
                                              "Cell size = 0.01")),
            0.5);
}
