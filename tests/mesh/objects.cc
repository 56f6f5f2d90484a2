// The objects of Natsupakpong and Cavusoglu (2010): tissue, hollow cylinder and
// tensile specimen, their outlines and their meshes.

#include <springfit/calibration/shape_quality.h>
#include <springfit/mesh/boundaries.h>
#include <springfit/mesh/specimen_outline.h>
#include <springfit/mesh/tissue_outline.h>
#include <springfit/reference/cell_matrices.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "messages.h"
#include "scene.h"

using namespace springfit;

namespace
{
  const SpecimenOutline specimen = {0.16, 0.03};
  const TissueOutline tissue     = {0.06, 0.02};

  constexpr double specimen_area = 36e-4; // B^2: 2 x 9 + 2 x 4 x 2 + 2

  double
  second_difference(const std::function<double(double)> &f,
                    const double x,
                    const double h)
  {
    return (f(x - h) - 2. * f(x) + f(x + h)) / (h * h);
  }

  template <int dim>
  double
  worst_shape_quality(const Mesh<dim> &mesh)
  {
    double worst = 1.;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      worst =
        std::min(worst, shape_quality(cell_points<dim>(cell), mesh.cell_kind));
    return worst;
  }

  /** Both counts within a part of the published ones. */
  template <int dim>
  void
  expect_counts_near(const Mesh<dim> &mesh,
                     const double n_nodes,
                     const double n_cells,
                     const double part)
  {
    EXPECT_NEAR(mesh.triangulation.n_vertices(), n_nodes, part * n_nodes);
    EXPECT_NEAR(mesh.triangulation.n_active_cells(), n_cells, part * n_cells);
  }

  template <int dim>
  void
  expect_boundaries(const Mesh<dim> &mesh,
                    const std::vector<std::string> &names,
                    const std::vector<double> &areas,
                    const double tolerance)
  {
    const auto table = boundary_table(mesh);
    ASSERT_EQ(table.size(), names.size());
    for (unsigned int i = 0; i < names.size(); ++i)
      {
        EXPECT_EQ(table[i].id, i);
        EXPECT_EQ(table[i].name, names[i]);
        EXPECT_NEAR(table[i].area, areas[i], tolerance * areas[i]) << i;
      }
    EXPECT_TRUE(mesh.warnings.empty());
  }

  /** The length of a curve by many chords. */
  double
  arc_length(const std::function<std::array<double, 2>(double)> &point,
             const double begin,
             const double end)
  {
    constexpr int n = 100000;
    double length   = 0.;
    auto last       = point(begin);
    for (int i = 1; i <= n; ++i)
      {
        const auto next = point(begin + (end - begin) * i / n);
        length += std::hypot(next[0] - last[0], next[1] - last[1]);
        last = next;
      }
    return length;
  }

  /** The integral of x dy around the tissue; exact for trigonometric ones. */
  double
  tissue_area()
  {
    constexpr int n = 64;
    double area     = 0.;
    for (int i = 0; i < n; ++i)
      {
        const double angle = 2. * M_PI * i / n;
        area += tissue.point(angle)[0] * tissue.tangent(angle)[1];
      }
    return area * 2. * M_PI / n;
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

TEST(TissueOutline, IsClosedSmoothAndConvexWithTheExtentsAskedFor)
{
  double lowest_x = 1., highest_x = 0., lowest_y = 1., highest_y = 0.;
  constexpr int n = 720;
  for (int i = 0; i < n; ++i)
    {
      const double angle = 2. * M_PI * i / n;
      const auto p       = tissue.point(angle);
      lowest_x           = std::min(lowest_x, p[0]);
      highest_x          = std::max(highest_x, p[0]);
      lowest_y           = std::min(lowest_y, p[1]);
      highest_y          = std::max(highest_y, p[1]);
      EXPECT_NEAR(p[0], tissue.point(angle + 2. * M_PI)[0], 1e-15);
      EXPECT_NEAR(p[1], tissue.point(angle + 2. * M_PI)[1], 1e-15);

      // The tangent is the derivative, never vanishes and turns left.
      const double h  = 1e-5;
      const auto t    = tissue.tangent(angle);
      const auto next = tissue.point(angle + h), last = tissue.point(angle - h);
      for (int d = 0; d < 2; ++d)
        EXPECT_NEAR(t[d], (next[d] - last[d]) / (2. * h), 1e-9);
      EXPECT_GT(std::hypot(t[0], t[1]), 1e-3);
      const auto ahead = tissue.tangent(angle + h);
      EXPECT_GT(t[0] * ahead[1] - t[1] * ahead[0], 0.);
    }
  EXPECT_NEAR(lowest_x, 0., 1e-15);
  EXPECT_NEAR(highest_x, 0.06, 1e-15);
  EXPECT_NEAR(lowest_y, 0., 1e-15);
  EXPECT_NEAR(highest_y, 0.02, 1e-15);
}

TEST(TissueOutline, FindsAngles)
{
  for (const double x : {0.003, 0.03, 0.057})
    {
      const double angle = tissue.upper_angle(x);
      EXPECT_NEAR(tissue.point(angle)[0], x, 1e-15);
      EXPECT_NEAR(tissue.point(2. * M_PI - angle)[0], x, 1e-15);
    }
  for (double angle = 0.01; angle < 6.28; angle += 0.3)
    {
      // A little off the outline, along its normal.
      const auto p = tissue.point(angle), t = tissue.tangent(angle);
      const double off = 1e-5 / std::hypot(t[0], t[1]);
      EXPECT_NEAR(tissue.nearest_angle(p[0] + off * t[1], p[1] - off * t[0]),
                  angle,
                  1e-9);
    }
}

TEST(Tissue, HasItsAreaAndItsEnds)
{
  const double cut    = 0.05 * 0.06;
  const auto point    = [](const double angle) { return tissue.point(angle); };
  const double at_min = tissue.upper_angle(cut);
  const double at_max = tissue.upper_angle(0.06 - cut);
  const std::vector<double> lengths = {
    arc_length(point, at_min, 2. * M_PI - at_min),
    arc_length(point, -at_max, at_max),
    arc_length(point, at_max, at_min) +
      arc_length(point, 2. * M_PI - at_min, 2. * M_PI - at_max)};
  for (const std::string cells : {"triangles", "quadrilaterals"})
    {
      double last_missing = 1.;
      for (const double h : {0.003, 0.0015, 0.00075})
        {
          const auto mesh = make_mesh<2>("Object = tissue; Cells = " + cells +
                                         "; Cell size = " + std::to_string(h));
          expect_boundaries(*mesh, {"x min", "x max", "side"}, lengths, 0.01);
          // Inscribed in a convex outline, the error falls with h^2.
          const double missing = 1. - measure_of(*mesh) / tissue_area();
          EXPECT_GT(missing, 0.);
          EXPECT_LT(missing, 0.35 * last_missing);
          EXPECT_LT(missing, 0.02);
          last_missing = missing;
        }
    }
}

TEST(Tissue, IsPulledAlongItsLength)
{
  // The vector area of each end: the integral of the normal.
  const auto mesh = make_mesh<2>("Object = tissue; Cells = triangles");
  dealii::Tensor<1, 2> ends[2];
  for (const auto &face : mesh->triangulation.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() < 2)
      {
        const auto edge = face->vertex(1) - face->vertex(0);
        dealii::Tensor<1, 2> normal;
        normal[0]         = edge[1];
        normal[1]         = -edge[0];
        const auto middle = 0.5 * (face->vertex(0) + face->vertex(1)) -
                            dealii::Point<2>(0.03, 0.01);
        ends[face->boundary_id()] += normal * middle > 0. ? normal : -normal;
      }
  EXPECT_GT(ends[1][0], 0.01);
  EXPECT_LT(std::abs(ends[1][1]), 1e-12);
  EXPECT_LT(ends[0][0], -0.01);
  EXPECT_LT(std::abs(ends[0][1]), 1e-12);
}

TEST(Tissue, HasThePublishedCounts)
{
  auto mesh =
    make_mesh<2>("Object = tissue; Cells = triangles; Cell size = 0.00278");
  expect_counts_near(*mesh, 210, 366, 0.01);
  EXPECT_GT(worst_shape_quality(*mesh), 0.7);
  mesh =
    make_mesh<2>("Object = tissue; Cells = quadrilaterals; Cell size = 0.002");
  EXPECT_EQ(mesh->cell_kind, CellKind::quadrilateral);
  expect_counts_near(*mesh, 445, 405, 0.04);
  EXPECT_GT(worst_shape_quality(*mesh), 0.6);
}

TEST(Tissue, HasConvexQuadrilateralsAtEverySize)
{
  for (const std::string size : {"0.06, 0.02", "0.02, 0.02", "0.01, 0.05"})
    for (const double h : {0.0008, 0.0013, 0.0018, 0.0024})
      {
        const auto mesh = make_mesh<2>(
          "Object = tissue; Cells = quadrilaterals; Size = " + size +
          "; Cell size = " + std::to_string(h));
        EXPECT_GT(worst_shape_quality(*mesh), 0.05) << size << ' ' << h;
      }
}

TEST(HollowCylinder, HasItsVolumeAndItsBoundaries)
{
  const double R = 0.01, r = 0.006, disc = M_PI * R * R;
  const std::vector<std::string> names = {"x min", "x max", "mantle", "hole"};
  const std::vector<double> areas      = {disc,
                                          disc,
                                          2. * M_PI * R * 0.02,
                                          4. * M_PI * r * r};
  const double volume = disc * 0.02 - 4. / 3. * M_PI * r * r * r;
  for (const double h : {0.003, 0.0015})
    {
      const auto mesh = make_mesh<3>("Object = hollow cylinder; "
                                     "Cells = tetrahedra; Cell size = " +
                                     std::to_string(h));
      expect_boundaries(*mesh, names, areas, 0.1 * std::pow(h / 0.003, 2));
      const double error = std::abs(measure_of(*mesh) / volume - 1.);
      EXPECT_LT(error, 0.01 * std::pow(h / 0.003, 2));
      for (const auto &face : mesh->triangulation.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == 3)
          {
            for (const unsigned int v : face->vertex_indices())
              EXPECT_NEAR(face->vertex(v).distance({0.01, 0., 0.}), r, 1e-9);
          }
      EXPECT_FALSE(mesh->straight_part);
    }
}

TEST(HollowCylinder, HasThePublishedCounts)
{
  const auto mesh = make_mesh<3>("Object = hollow cylinder; "
                                 "Cells = tetrahedra; Cell size = 0.002884");
  expect_counts_near(*mesh, 404, 1559, 0.12);
  EXPECT_GT(worst_shape_quality(*mesh), 0.1);
}

TEST(HollowCylinder, HasARadiusThatFollowsFromSize)
{
  const auto mesh = make_mesh<3>("Object = hollow cylinder; "
                                 "Cells = tetrahedra; Cell size = 0.002; "
                                 "Size = 0.03, 0.01, 0.01");
  EXPECT_NEAR(boundary_table(*mesh)[3].area,
              4. * M_PI * 0.003 * 0.003,
              0.1 * 4. * M_PI * 0.003 * 0.003);
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
        {2, CellKind::quadrilateral, {0.16, 0.03}, {0.005}, "", 1.});
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

TEST(Objects, HaveTheirOwnSizes)
{
  EXPECT_NEAR(measure_of(*make_mesh<2>("Object = specimen; Size = ")),
              specimen_area,
              1e-3 * specimen_area);
  EXPECT_NEAR(measure_of(*make_mesh<2>("Object = tissue; Size = ")),
              tissue_area(),
              0.01 * tissue_area());
  EXPECT_NEAR(measure_of(*make_mesh<3>("Object = box")), 8e-6, 1e-18);
}

TEST(Entries, ThatNoObjectCanBeMadeOfAreRefused)
{
  using Case = std::pair<std::string, std::vector<std::string>>;
  for (const auto &[entries, words] : std::vector<Case>{
         {"Object = hollow cylinder", {"Geometry/Object", "dimension 3"}},
         {"Object = tissue; Size = 0.06", {"Geometry/Size", "1 numbers"}},
         {"Object = tissue; Cell size = 0.01",
          {"Geometry/Cell size", "too coarse", "0.005 (in m) or less"}},
         {"Object = tissue; Cell size = 0.001, 0.002",
          {"Geometry/Cell size", "2 numbers", "one length"}},
         {"Object = specimen; Cell size = 0.02",
          {"Geometry/Cell size", "transition", "0.01 (in m) or less"}},
         {"Object = specimen; Cell size = 0.0101, 0.005",
          {"0.0101 along x", "0.01 (in m) along x or less"}},
         {"Object = specimen; Cell size = 0.005, 0.02",
          {"0.02 along y", "0.01 (in m) along y or less"}},
         {"Object = specimen; Size = 0.16, 0.015; Cell size = 0.006",
          {"0.005 (in m) or less"}}})
    expect_error([&, e = entries]() { make_mesh<2>(e); }, words);
  for (const auto &[entries, words] : std::vector<Case>{
         {"Object = tissue; Cells = tetrahedra",
          {"Geometry/Object", "dimension 2"}},
         {"Object = hollow cylinder", {"Geometry/Cells", "tetrahedra"}},
         {"Object = hollow cylinder; Cells = tetrahedra; "
          "Size = 0.012, 0.02, 0.02",
          {"Geometry/Size", "0.0132 m"}},
         {"Object = hollow cylinder; Cells = tetrahedra; Cell size = 0.007",
          {"Geometry/Cell size", "0.006 (in m) or less"}},
         {"Object = specimen; Cells = tetrahedra; Cell size = 0.004; "
          "Size = 0.16, 0.03, 0.002",
          {"thickness", "0.002 (in m) or less"}}})
    expect_error([&, e = entries]() { make_mesh<3>(e); }, words);

  // The largest cells that are allowed do make a mesh.
  EXPECT_GT(worst_shape_quality(*make_mesh<2>("Object = specimen; "
                                              "Cell size = 0.01")),
            0.5);
  EXPECT_GT(worst_shape_quality(*make_mesh<2>("Object = tissue; "
                                              "Cell size = 0.005")),
            0.05);
}
