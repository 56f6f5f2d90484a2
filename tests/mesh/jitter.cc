// Distorted meshes: what moves, how far, and what stays.

#include <springfit/mesh/boundaries.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/jitter.h>
#include <springfit/mesh/mesh_checks.h>
#include <springfit/mesh/objects.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "messages.h"
#include "scene.h"

using namespace springfit;

namespace
{
  /** One unit long in each direction; @p cell_size as in the entry. */
  MeshDescription
  unit_box(const CellKind kind, const std::vector<double> &cell_size)
  {
    const int dim = dimension(kind);
    return find_object("box").describe(
      {dim, dim, kind, std::vector<double>(dim, 1.), cell_size, "", 1.});
  }

  const std::vector<CellKind> all_kinds = {CellKind::triangle,
                                           CellKind::quadrilateral,
                                           CellKind::tetrahedron,
                                           CellKind::hexahedron};

  bool
  is_inside_unit_box(const MeshPoint &point, const int dim)
  {
    return std::all_of(point.begin(), point.begin() + dim, [](const double x) {
      return x > 0. && x < 1.;
    });
  }
} // namespace


TEST(Jitter, MovesTheVerticesInsideOnlyAndByAtMostWhatIsAskedFor)
{
  for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
    {
      // Of different edges, the shortest one counts.
      const int dim = dimension(kind);
      const auto mesh =
        unit_box(kind,
                 dim == 2 ? std::vector<double>{0.05, 0.025}
                          : std::vector<double>{0.1, 0.05, 0.0625});
      const double edge  = dim == 2 ? 0.025 : 0.05;
      const double bound = 0.2 * edge;
      const auto moved   = jittered_vertices(mesh, 0.2);

      ASSERT_EQ(moved.size(), mesh.vertices.size());
      double mean[3] = {0., 0., 0.}, mean_square[3] = {0., 0., 0.};
      double largest        = 0.;
      unsigned int n_inside = 0;
      for (unsigned int v = 0; v < moved.size(); ++v)
        if (!is_inside_unit_box(mesh.vertices[v], dim))
          {
            EXPECT_EQ(moved[v], mesh.vertices[v]);
          }
        else
          {
            ++n_inside;
            for (int d = 0; d < 3; ++d)
              {
                const double step = (moved[v][d] - mesh.vertices[v][d]) / bound;
                mean[d] += step;
                mean_square[d] += step * step;
                largest = std::max(largest, std::abs(step));
              }
          }
      ASSERT_GE(n_inside, 19u * 39u);
      EXPECT_LE(largest, 1. + 1e-12);
      EXPECT_GT(largest, 0.99);
      // Uniform in [-1, 1]: mean 0, variance 1/3; five standard deviations.
      for (int d = 0; d < dim; ++d)
        {
          EXPECT_NEAR(mean[d] / n_inside, 0., 5. / std::sqrt(3. * n_inside));
          EXPECT_NEAR(mean_square[d] / n_inside,
                      1. / 3.,
                      5. * std::sqrt(4. / 45. / n_inside));
        }
      if (dim == 2)
        {
          EXPECT_EQ(mean_square[2], 0.);
        }
    }
}

TEST(Jitter, KnowsDiagonalsFromEdges)
{
  // Rhombi with angles of 30 degrees: a diagonal is half as long as an edge.
  auto mesh = unit_box(CellKind::quadrilateral, {0.05});
  for (MeshPoint &vertex : mesh.vertices)
    vertex = {{vertex[0] + std::sqrt(0.75) * vertex[1], 0.5 * vertex[1], 0.}};
  const auto moved = jittered_vertices(mesh, 0.4);
  double largest   = 0.;
  for (unsigned int v = 0; v < moved.size(); ++v)
    largest = std::max(largest, std::abs(moved[v][0] - mesh.vertices[v][0]));
  EXPECT_LE(largest, 0.4 * 0.05 * (1. + 1e-9));
  EXPECT_GT(largest, 0.39 * 0.05);
}

TEST(Jitter, OfSimplicesIsBoundedByTheEdgesThere)
{
  for (const CellKind kind : {CellKind::triangle, CellKind::tetrahedron})
    {
      const auto mesh  = unit_box(kind, {0.15});
      const auto moved = jittered_vertices(mesh, 0.1);
      const int dim    = dimension(kind);
      std::vector<double> shortest(moved.size(),
                                   std::numeric_limits<double>::max());
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        for (int i = 0; i < n_vertices(kind); ++i)
          for (int j = 0; j < n_vertices(kind); ++j)
            if (i != j)
              {
                const MeshPoint &a = mesh.vertices[mesh.cell(c)[i]];
                const MeshPoint &b = mesh.vertices[mesh.cell(c)[j]];
                double square      = 0.;
                for (int d = 0; d < 3; ++d)
                  square += (a[d] - b[d]) * (a[d] - b[d]);
                double &edge = shortest[mesh.cell(c)[i]];
                edge         = std::min(edge, std::sqrt(square));
              }
      for (unsigned int v = 0; v < moved.size(); ++v)
        for (int d = 0; d < 3; ++d)
          {
            const double step = std::abs(moved[v][d] - mesh.vertices[v][d]);
            EXPECT_LE(step, 0.1 * shortest[v] * (1. + 1e-9));
            EXPECT_EQ(step > 0.,
                      d < dim && is_inside_unit_box(mesh.vertices[v], dim));
          }
    }
}

TEST(Jitter, IsTheSameEverywhere)
{
  // From 3499211612, 581869302, 3890346734, 3586334585, the first numbers of
  // the Mersenne twister MT19937 with the seed 5489 (Matsumoto and Nishimura
  // 1998), r in [0, 2^32 - 1]: the step is 0.2 (2 r / (2^32 - 1) - 1) edges.
  const auto plane =
    jittered_vertices(unit_box(CellKind::quadrilateral, {0.25}), 0.2);
  EXPECT_NEAR(plane[6][0], 0.281472369209, 1e-12);
  EXPECT_NEAR(plane[6][1], 0.213547700414, 1e-12);
  EXPECT_NEAR(plane[7][0], 0.540579193432, 1e-12);
  EXPECT_NEAR(plane[7][1], 0.283500858998, 1e-12);

  const auto solid =
    jittered_vertices(unit_box(CellKind::hexahedron, {0.25, 0.5, 0.25}), 0.2);
  EXPECT_NEAR(solid[21][0], 0.281472369209, 1e-12);
  EXPECT_NEAR(solid[21][1], 0.463547700414, 1e-12);
  EXPECT_NEAR(solid[21][2], 0.290579193432, 1e-12);
}

TEST(Jitter, KeepsVolumeSidesAndNames)
{
  const auto expect_same = [](const auto &regular, const auto &distorted) {
    const double measure = measure_of(regular);
    EXPECT_NEAR(measure_of(distorted), measure, 1e-12 * measure);
    const auto expected = boundary_table(regular);
    const auto found    = boundary_table(distorted);
    ASSERT_EQ(found.size(), expected.size());
    for (unsigned int i = 0; i < found.size(); ++i)
      {
        EXPECT_EQ(found[i].id, expected[i].id);
        EXPECT_EQ(found[i].name, expected[i].name);
        EXPECT_EQ(found[i].n_faces, expected[i].n_faces);
        EXPECT_EQ(found[i].area, expected[i].area);
      }
    EXPECT_EQ(distorted.warnings, regular.warnings);
    // Something has moved.
    const auto &before = regular.triangulation.get_vertices();
    const auto &after  = distorted.triangulation.get_vertices();
    EXPECT_NE(before, after);
  };
  for (const std::string entries : {"Object = box; Cell size = 0.002",
                                    "Object = box; Cells = triangles",
                                    "Object = tissue; Cells = quadrilaterals",
                                    "Object = specimen",
                                    "Object = specimen; Cells = triangles",
                                    "Object = file; File = plate_v2.msh"})
    expect_same(*make_mesh<2>(entries, MESH_DATA),
                *make_mesh<2>(entries + "; Jitter = 0.2", MESH_DATA));
  for (const std::string entries :
       {"Object = box",
        "Object = cylinder; Cell size = 0.0025",
        "Object = specimen; Cell size = 0.005, 0.0025, 0.0025",
        "Object = hollow cylinder; Cells = tetrahedra; Cell size = 0.003",
        "Object = file; File = rod.geo; Scale = 0.01; Cell size = 0.004; "
        "Cells = tetrahedra"})
    expect_same(*make_mesh<3>(entries, MESH_DATA),
                *make_mesh<3>(entries + "; Jitter = 0.1", MESH_DATA));
}

TEST(Jitter, OfNothingChangesNothing)
{
  for (const CellKind kind : all_kinds)
    {
      auto mesh         = unit_box(kind, {0.3});
      const auto before = mesh.vertices;
      jitter(mesh, 0.);
      EXPECT_EQ(mesh.vertices, before);
      EXPECT_TRUE(mesh.warnings.empty());
    }
}

TEST(Jitter, OfAMeshWithoutVerticesInsideGivesAWarning)
{
  auto mesh         = unit_box(CellKind::hexahedron, {0.1, 0.1, 1.});
  const auto before = mesh.vertices;
  jitter(mesh, 0.3);
  EXPECT_EQ(mesh.vertices, before);
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_NE(mesh.warnings[0].find("no vertex inside"), std::string::npos);
}

TEST(Jitter, ThatTurnsACellInsideOutIsRefusedAndALowerOneNamed)
{
  for (const CellKind kind : all_kinds)
    {
      const auto mesh = unit_box(kind, {dimension(kind) == 2 ? 0.02 : 0.1});
      auto jittered   = mesh;
      double lower    = 0.;
      try
        {
          jitter(jittered, 0.49);
          FAIL() << "nothing is thrown";
        }
      catch (const EntryError &error)
        {
          const std::string message = error.what();
          EXPECT_EQ(error.entry, "Geometry/Jitter");
          EXPECT_EQ(message.find("Geometry/Jitter: 0.49 turns " +
                                 singular(kind)),
                    0u)
            << message;
          EXPECT_NE(message.find("around x = "), std::string::npos);
          const auto place = message.find("Lower it to ");
          ASSERT_NE(place, std::string::npos);
          lower = std::stod(message.substr(place + 12));
        }
      EXPECT_EQ(jittered.vertices, mesh.vertices);

      EXPECT_GT(lower, 0.1);
      EXPECT_NO_THROW(jitter(jittered, lower));
      EXPECT_NO_THROW(check_mesh(jittered));
      EXPECT_TRUE(jittered.warnings.empty());
      auto beyond = mesh;
      expect_error([&]() { jitter(beyond, lower + 0.01); },
                   {"Geometry/Jitter", "inside out"});
    }
}

TEST(Jitter, OfNextToFlatCellsIsRefusedAtAnyHundredth)
{
  // A square about a vertex that is nearly on one of its sides.
  MeshDescription mesh;
  mesh.name         = "The mesh";
  mesh.cell_kind    = CellKind::triangle;
  mesh.vertices     = {{{0., 0., 0.}},
                       {{1., 0., 0.}},
                       {{1., 1., 0.}},
                       {{0., 1., 0.}},
                       {{0.5, 1e-9, 0.}}};
  mesh.cells        = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  mesh.material_ids = {0, 0, 0, 0};
  int n_refused     = 0;
  for (const double fraction : {0.004, 0.3})
    try
      {
        auto jittered = mesh;
        jitter(jittered, fraction);
      }
    catch (const EntryError &error)
      {
        ++n_refused;
        const std::string message = error.what();
        EXPECT_NE(message.find(fraction < 0.01 ? "Lower it to less than 0.004"
                                               : "Lower it to less than 0.01"),
                  std::string::npos)
          << message;
      }
  EXPECT_EQ(n_refused, 2);
}

TEST(Jitter, OutOfRangeIsRefused)
{
  for (const std::string value : {"-0.1", "0.5", "1e300"})
    expect_error([&]() { make_mesh<2>("Jitter = " + value); },
                 {"Geometry/Jitter", "out of range", "less than 0.5"});
  EXPECT_NO_THROW(make_mesh<2>("Cell size = 0.01; Jitter = 0.49"));
}
