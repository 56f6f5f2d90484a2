// Tissue, the plane object of Natsupakpong and Cavusoglu (2010): its outline
// and its meshes.

#include <springfit/mesh/tissue_outline.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "measures.h"
#include "messages.h"
#include "scene.h"

using namespace springfit;

namespace
{
  const TissueOutline tissue = {0.06, 0.02};

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

TEST(Tissue, HasItsOwnSize)
{
  EXPECT_NEAR(measure_of(*make_mesh<2>("Object = tissue; Size = ")),
              tissue_area(),
              0.01 * tissue_area());
}

TEST(Tissue, IsNotMadeOfWrongEntries)
{
  using Case = std::pair<std::string, std::vector<std::string>>;
  for (const auto &[entries, words] : std::vector<Case>{
         {"Size = 0.06", {"Geometry/Size", "1 numbers"}},
         {"Cell size = 0.01",
          {"Geometry/Cell size", "too coarse", "0.005 (in m) or less"}},
         {"Cell size = 0.001, 0.002",
          {"Geometry/Cell size", "2 numbers", "one length"}}})
    expect_error([&, e = entries]() { make_mesh<2>("Object = tissue; " + e); },
                 words);
  expect_error([]() { make_mesh<3>("Object = tissue; Cells = tetrahedra"); },
               {"Geometry/Object", "dimension 2"});

  // The largest cells that are allowed do make a mesh.
  EXPECT_GT(worst_shape_quality(*make_mesh<2>("Object = tissue; "
                                              "Cell size = 0.005")),
            0.05);
}
