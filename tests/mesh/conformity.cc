// Doubled and hanging vertices: cracks, half-refined cells, and no alarm where
// there is nothing.

#include <springfit/mesh/cell_orientation.h>
#include <springfit/mesh/conformity.h>
#include <springfit/mesh/jitter.h>
#include <springfit/mesh/mesh_checks.h>
#include <springfit/mesh/objects.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "messages.h"
#include "scene.h"

using namespace springfit;

namespace
{
  const std::vector<CellKind> all_kinds = {CellKind::triangle,
                                           CellKind::quadrilateral,
                                           CellKind::tetrahedron,
                                           CellKind::hexahedron};

  /** A mesh of cells given by points; what is equal becomes one vertex. */
  class Builder
  {
  public:
    explicit Builder(const CellKind kind)
    {
      mesh.name      = "The mesh";
      mesh.cell_kind = kind;
    }

    /**
     * Cells with different numbers at one point have vertices of their own
     * there.
     */
    std::function<int(const MeshPoint &point, const MeshPoint &lowest)> copy =
      [](const MeshPoint &, const MeshPoint &) { return 0; };

    void
    add_cell(const std::vector<MeshPoint> &points, const MeshPoint &lowest = {})
    {
      const unsigned int first = mesh.cells.size();
      for (const MeshPoint &point : points)
        {
          const auto [vertex, is_new] =
            vertices_.emplace(std::make_pair(point, copy(point, lowest)),
                              mesh.vertices.size());
          if (is_new)
            mesh.vertices.push_back(point);
          mesh.cells.push_back(vertex->second);
        }
      mesh.material_ids.push_back(0);
      if (scaled_jacobians(mesh, mesh.n_cells() - 1)[0] < 0.)
        std::swap(mesh.cells[first], mesh.cells[first + 1]); // of simplices
    }

    /** A square or cube, of simplices if these are the cells. */
    void
    add_box(const MeshPoint &lowest, const double h)
    {
      const int dim = dimension(mesh.cell_kind);
      std::vector<MeshPoint> corners;
      for (int i = 0; i < 1 << dim; ++i)
        corners.push_back({{lowest[0] + h * (i & 1),
                            lowest[1] + h * (i >> 1 & 1),
                            lowest[2] + h * (i >> 2 & 1)}});
      if (!is_simplex(mesh.cell_kind))
        return add_cell(corners, lowest);
      // Kuhn's: from the first corner to the last one, along the axes.
      std::vector<int> axes(dim);
      std::iota(axes.begin(), axes.end(), 0);
      do
        {
          std::vector<MeshPoint> points = {corners[0]};
          int corner                    = 0;
          for (const int axis : axes)
            points.push_back(corners[corner |= 1 << axis]);
          add_cell(points, lowest);
      } while (std::next_permutation(axes.begin(), axes.end()));
    }

    /** Unit boxes, n of them along each axis; those that @p halved are 2^dim.
     */
    void
    add_grid(
      const int n,
      const std::function<bool(const MeshPoint &)> &halved =
        [](const MeshPoint &) { return false; })
    {
      const int dim = dimension(mesh.cell_kind);
      for (double z = 0; z < (dim == 3 ? n : 1); ++z)
        for (double y = 0; y < n; ++y)
          for (double x = 0; x < n; ++x)
            if (!halved({{x, y, z}}))
              add_box({{x, y, z}}, 1.);
            else
              for (int i = 0; i < 1 << dim; ++i)
                add_box({{x + 0.5 * (i & 1),
                          y + 0.5 * (i >> 1 & 1),
                          z + 0.5 * (i >> 2 & 1)}},
                        0.5);
    }

    MeshDescription mesh;

  private:
    std::map<std::pair<MeshPoint, int>, unsigned int> vertices_;
  };

  bool
  is_at(const MeshPoint &point, const double x, const double y, const double z)
  {
    return point == MeshPoint{{x, y, z}};
  }

  /** Three cells along each axis, the one in the middle halved. */
  MeshDescription
  half_refined(const CellKind kind)
  {
    const double z = dimension(kind) == 3 ? 1. : 0.;
    Builder builder(kind);
    builder.add_grid(3, [z](const MeshPoint &p) { return is_at(p, 1, 1, z); });
    return builder.mesh;
  }

  /** A slit along y = 2 that ends at the vertices with x = 1 and x = 3. */
  MeshDescription
  cracked(const CellKind kind)
  {
    Builder builder(kind);
    builder.copy = [](const MeshPoint &p, const MeshPoint &lowest) {
      return p[1] == 2. && p[0] > 1. && p[0] < 3. && lowest[1] >= 2. ? 1 : 0;
    };
    builder.add_grid(4);
    return builder.mesh;
  }

  std::vector<MeshPoint>
  hanging_points(const MeshDescription &mesh)
  {
    std::vector<MeshPoint> points;
    for (const HangingVertex &found : nonconforming_vertices(mesh).hanging)
      points.push_back(mesh.vertices[found.vertex]);
    return points;
  }

  void
  expect_conforming(const MeshDescription &mesh)
  {
    const auto found = nonconforming_vertices(mesh);
    EXPECT_EQ(found.doubled.size(), 0u) << mesh.name;
    EXPECT_EQ(found.hanging.size(), 0u) << mesh.name;
  }

  /** Trilinear in each unit cube, so that faces become bilinear patches. */
  MeshPoint
  warped(const MeshPoint &p)
  {
    MeshPoint result = p;
    for (int i = 0; i < 8; ++i)
      {
        double weight = 1., phase = 0.;
        for (int d = 0; d < 3; ++d)
          {
            const double low = std::floor(p[d]);
            weight *= (i >> d & 1) ? p[d] - low : 1. - p[d] + low;
            phase += (2.3 + d * d) * (low + (i >> d & 1));
          }
        for (int d = 0; d < 3; ++d)
          result[d] += 0.1 * weight * std::sin(phase * phase * (1. + d));
      }
    return result;
  }

  unsigned int
  vertex_at(const MeshDescription &mesh, const MeshPoint &point)
  {
    const auto found =
      std::find(mesh.vertices.begin(), mesh.vertices.end(), point);
    EXPECT_NE(found, mesh.vertices.end());
    return found - mesh.vertices.begin();
  }

  bool
  tells_of_vertices(const std::vector<std::string> &warnings)
  {
    for (const std::string &warning : warnings)
      if (warning.find("doubled vert") != std::string::npos ||
          warning.find("hang") != std::string::npos)
        return true;
    return false;
  }

  void
  expect_words(const std::string &text, const std::vector<std::string> &words)
  {
    for (const std::string &word : words)
      EXPECT_NE(text.find(word), std::string::npos)
        << "'" << word << "' is missing in: " << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
} // namespace


TEST(Conformity, grids_conform)
{
  for (const CellKind kind : all_kinds)
    {
      Builder builder(kind);
      builder.add_grid(4);
      check_mesh(builder.mesh);
      EXPECT_TRUE(builder.mesh.warnings.empty());
      expect_conforming(builder.mesh);
    }
}

TEST(Conformity, a_halved_cell_has_hanging_vertices_on_its_edges_and_faces)
{
  EXPECT_EQ(hanging_points(half_refined(CellKind::quadrilateral)).size(), 4u);
  EXPECT_EQ(hanging_points(half_refined(CellKind::triangle)).size(), 4u);
  // 12 edges and 6 faces, of tetrahedra along the faces' diagonals
  EXPECT_EQ(hanging_points(half_refined(CellKind::hexahedron)).size(), 18u);
  EXPECT_EQ(hanging_points(half_refined(CellKind::tetrahedron)).size(), 18u);
}

TEST(Conformity, vertices_on_the_outside_do_not_hang)
{
  // 3 faces of the cube in the corner have neighbours, with 9 edges.
  for (const auto &[kind, n] : std::vector<std::pair<CellKind, unsigned int>>{
         {CellKind::quadrilateral, 2}, {CellKind::hexahedron, 12}})
    {
      Builder builder(kind);
      builder.add_grid(3, [](const MeshPoint &p) { return is_at(p, 0, 0, 0); });
      const auto points = hanging_points(builder.mesh);
      EXPECT_EQ(points.size(), n);
      for (const MeshPoint &p : points)
        EXPECT_TRUE(p[0] == 1. || p[1] == 1. || p[2] == 1.);
    }
}

TEST(Conformity, one_of_two_triangles_in_four)
{
  Builder builder(CellKind::triangle);
  const MeshPoint a{{0, 0, 0}}, b{{1, 0, 0}}, c{{0, 1, 0}}, d{{1, 1, 0}},
    ab{{0.5, 0, 0}}, bc{{0.5, 0.5, 0}}, ca{{0, 0.5, 0}};
  for (const auto &cell : {std::vector<MeshPoint>{b, d, c},
                           {a, ab, ca},
                           {ab, b, bc},
                           {ca, bc, c},
                           {ab, bc, ca}})
    builder.add_cell(cell);
  EXPECT_EQ(hanging_points(builder.mesh), (std::vector<MeshPoint>{bc}));
  EXPECT_EQ(nonconforming_vertices(builder.mesh).hanging[0].cell, 0u);
}

TEST(Conformity, one_of_two_tetrahedra_in_eight)
{
  Builder builder(CellKind::tetrahedron);
  const std::vector<MeshPoint> p = {{{0, 0, 0}},
                                    {{1, 0, 0}},
                                    {{0, 1, 0}},
                                    {{0, 0, 1}}};
  const auto middle              = [&](const int i, const int j) {
    return MeshPoint{{0.5 * (p[i][0] + p[j][0]),
                      0.5 * (p[i][1] + p[j][1]),
                      0.5 * (p[i][2] + p[j][2])}};
  };
  builder.add_cell({p[1], p[2], p[3], {{1, 1, 1}}});
  for (int i = 0; i < 4; ++i)
    builder.add_cell({p[i],
                      middle(i, (i + 1) % 4),
                      middle(i, (i + 2) % 4),
                      middle(i, (i + 3) % 4)});
  const std::vector<MeshPoint> ring = {middle(0, 1),
                                       middle(1, 2),
                                       middle(2, 3),
                                       middle(0, 3)};
  for (int i = 0; i < 4; ++i)
    builder.add_cell({middle(0, 2), middle(1, 3), ring[i], ring[(i + 1) % 4]});
  check_mesh(builder.mesh);

  EXPECT_EQ(hanging_points(builder.mesh).size(), 3u);
  for (const MeshPoint &point : hanging_points(builder.mesh))
    EXPECT_EQ(point[0] + point[1] + point[2], 1.);
}

TEST(Conformity, a_vertex_inside_a_triangular_face)
{
  Builder builder(CellKind::tetrahedron);
  const MeshPoint o{{0, 0, 0}}, a{{1, 0, 0}}, b{{0, 1, 0}}, c{{0, 0, 1}},
    inside{{0.25, 0.25, 0.5}};
  builder.add_cell({a, b, c, {{1, 1, 1}}});
  builder.add_cell({o, a, b, inside});
  builder.add_cell({o, b, c, inside});
  builder.add_cell({o, c, a, inside});
  EXPECT_EQ(hanging_points(builder.mesh), (std::vector<MeshPoint>{inside}));
}

TEST(Conformity, warped_faces_are_bilinear_patches_or_triangles)
{
  const auto flat = half_refined(CellKind::hexahedron);
  auto mesh       = flat;
  std::transform(flat.vertices.begin(),
                 flat.vertices.end(),
                 mesh.vertices.begin(),
                 warped);
  EXPECT_EQ(nonconforming_vertices(mesh).hanging.size(), 18u);

  // In the middle of one of the diagonals instead; off the face it is a hole.
  const unsigned int v = vertex_at(flat, {{2, 1.5, 1.5}});
  const auto patch     = mesh.vertices[v];
  for (const auto &ends :
       {std::pair<MeshPoint, MeshPoint>{{{2, 1, 1}}, {{2, 2, 2}}},
        {{{2, 2, 1}}, {{2, 1, 2}}}})
    {
      const MeshPoint &a = mesh.vertices[vertex_at(flat, ends.first)],
                      &b = mesh.vertices[vertex_at(flat, ends.second)];
      for (int d = 0; d < 3; ++d)
        mesh.vertices[v][d] = 0.5 * (a[d] + b[d]);
      EXPECT_GT(std::abs(mesh.vertices[v][0] - patch[0]), 1e-3);
      EXPECT_EQ(nonconforming_vertices(mesh).hanging.size(), 18u);
    }
  mesh.vertices[v] = patch;
  mesh.vertices[v][0] -= 1e-3;
  EXPECT_EQ(nonconforming_vertices(mesh).hanging.size(), 17u);
}

TEST(Conformity, warped_grids_conform)
{
  for (const CellKind kind : all_kinds)
    {
      Builder builder(kind);
      builder.add_grid(4);
      for (MeshPoint &vertex : builder.mesh.vertices)
        {
          const double z = vertex[2];
          vertex         = warped(vertex);
          if (dimension(kind) == 2)
            vertex[2] = z;
        }
      expect_conforming(builder.mesh);
    }
}

TEST(Conformity, a_crack_has_doubled_vertices_but_not_at_its_tips)
{
  for (const CellKind kind : all_kinds)
    {
      MeshDescription mesh = cracked(kind);
      const auto found     = nonconforming_vertices(mesh);
      ASSERT_EQ(found.doubled.size(), dimension(kind) == 2 ? 1u : 5u);
      EXPECT_TRUE(found.hanging.empty());
      for (const auto &group : found.doubled)
        {
          ASSERT_EQ(group.size(), 2u);
          EXPECT_LT(group[0], group[1]);
          EXPECT_EQ(mesh.vertices[group[0]], mesh.vertices[group[1]]);
          EXPECT_EQ(mesh.vertices[group[0]][0], 2.);
          EXPECT_EQ(mesh.vertices[group[0]][1], 2.);
        }

      check_mesh(mesh);
      ASSERT_EQ(mesh.warnings.size(), 1u);
      expect_words(mesh.warnings[0],
                   {"The mesh",
                    dimension(kind) == 2 ? "at 1 position:" : "at 5 positions:",
                    "x = 2, y = 2",
                    "(m)",
                    "opens or overlaps",
                    "If this is no crack",
                    "'Coherence Mesh;'"});
    }
}

TEST(Conformity, a_thin_slit_is_no_crack)
{
  for (const CellKind kind : all_kinds)
    for (const double width : {1e-2, 1e-5})
      {
        MeshDescription mesh = cracked(kind);
        for (const auto &group : nonconforming_vertices(mesh).doubled)
          mesh.vertices[group[1]][1] += width;
        expect_conforming(mesh);
      }
}

TEST(Conformity, has_a_tolerance_relative_to_the_cells)
{
  for (const double scale : {1e-9, 1e6})
    for (const double shift : {1e-7, 1e-5})
      {
        MeshDescription crack = cracked(CellKind::quadrilateral);
        const auto doubled    = nonconforming_vertices(crack).doubled;
        crack.vertices[doubled[0][1]][1] += shift;
        MeshDescription hanging = half_refined(CellKind::hexahedron);
        hanging.vertices[vertex_at(hanging, {{2, 1.5, 1.5}})][0] -= shift;
        for (MeshDescription *mesh : {&crack, &hanging})
          for (MeshPoint &vertex : mesh->vertices)
            for (double &x : vertex)
              x *= scale;
        const bool is_near = shift < 1e-6;
        EXPECT_EQ(nonconforming_vertices(crack).doubled.size(),
                  is_near ? 1u : 0u);
        EXPECT_EQ(nonconforming_vertices(hanging).hanging.size(),
                  is_near ? 18u : 17u);
      }
}

TEST(Conformity, cells_may_be_very_thin)
{
  for (const CellKind kind : all_kinds)
    {
      Builder builder(kind);
      builder.add_grid(4);
      for (MeshPoint &vertex : builder.mesh.vertices)
        vertex[1] *= 1e-8;
      expect_conforming(builder.mesh);
    }
}

// Two pairs of tetrahedra, above and below a square or warped quadrilateral.
TEST(Conformity, different_diagonals_are_told)
{
  for (const double warp : {0., 0.1})
    for (const bool is_crossed : {false, true})
      {
        const MeshPoint a{{0., 0., warp}}, b{{1., 0., 0.}}, c{{1., 1., warp}},
          d{{0., 1., 0.}}, top{{0.5, 0.5, 1.}}, bottom{{0.5, 0.5, -1.}};
        Builder builder(CellKind::tetrahedron);
        builder.add_cell({a, b, c, top});
        builder.add_cell({a, c, d, top});
        if (is_crossed)
          {
            builder.add_cell({a, b, d, bottom});
            builder.add_cell({b, c, d, bottom});
          }
        else
          {
            builder.add_cell({a, b, c, bottom});
            builder.add_cell({a, c, d, bottom});
          }
        check_mesh(builder.mesh);
        bool is_told = false;
        for (const std::string &warning : builder.mesh.warnings)
          is_told = is_told || warning.find("1 quadrilateral between cells") !=
                                 std::string::npos;
        EXPECT_EQ(is_told, is_crossed);
      }
  Builder alone(CellKind::tetrahedron);
  alone.add_cell(
    {{{0., 0., 0.}}, {{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}});
  check_mesh(alone.mesh);
  EXPECT_TRUE(alone.mesh.warnings.empty());
}

TEST(Conformity, hanging_vertices_are_told_in_one_line)
{
  for (const CellKind kind : all_kinds)
    {
      MeshDescription mesh = half_refined(kind);
      check_mesh(mesh);
      ASSERT_EQ(mesh.warnings.size(), 1u);
      expect_words(mesh.warnings[0],
                   {"The mesh",
                    dimension(kind) == 2 ? "4 vertices" : "18 vertices",
                    "x = 1.5, y = 1",
                    "; ... (m)",
                    "the first one in " + singular(kind) + " ",
                    "opens or overlaps",
                    "half-refined"});
    }
}

TEST(Conformity, parts_that_touch_are_told_once)
{
  for (const CellKind kind : all_kinds)
    {
      Builder builder(kind);
      builder.copy = [](const MeshPoint &, const MeshPoint &lowest) {
        return lowest[1] >= 1. ? 1 : 0;
      };
      builder.add_grid(2);
      MeshDescription apart = builder.mesh;
      check_mesh(builder.mesh);
      ASSERT_EQ(builder.mesh.warnings.size(), 1u);
      expect_words(builder.mesh.warnings[0],
                   {"2 parts",
                    dimension(kind) == 2 ? "at 3 positions" : "at 9 positions",
                    "x = 0, y = 1",
                    "'Coherence Mesh;'"});

      for (unsigned int v = 0; v < apart.vertices.size(); ++v)
        if (std::count(apart.cells.begin() + apart.cells.size() / 2,
                       apart.cells.end(),
                       v) > 0 &&
            dimension(kind) == 2)
          apart.vertices[v][1] += 0.5;
      if (dimension(kind) == 3)
        continue;
      check_mesh(apart);
      ASSERT_EQ(apart.warnings.size(), 1u);
      expect_words(apart.warnings[0],
                   {"2 parts", "none of their vertices coincide"});
      EXPECT_EQ(apart.warnings[0].find("Coherence Mesh"), std::string::npos);
    }
}

TEST(Conformity, parts_that_do_not_match_hang_in_each_other)
{
  Builder builder(CellKind::hexahedron);
  builder.add_box({{0, 0, 0}}, 1.);
  builder.copy = [](const MeshPoint &, const MeshPoint &) { return 1; };
  builder.add_box({{0.25, 0.25, 1}}, 0.5);
  check_mesh(builder.mesh);
  ASSERT_EQ(builder.mesh.warnings.size(), 2u);
  expect_words(builder.mesh.warnings[0], {"2 parts", "coincide"});
  expect_words(builder.mesh.warnings[1],
               {"4 vertices", "x = 0.25, y = 0.25, z = 1", "one body"});
}

TEST(Conformity, the_objects_conform_also_with_jitter)
{
  for (const Object &object : objects())
    for (const auto &[dim, size] : object.default_size)
      for (const CellKind kind : all_kinds)
        for (const double h : {0.005, 0.0013})
          {
            const ObjectRequest request{dim, dim, kind, size, {h}, "", 1.};
            if (dimension(kind) != dim)
              continue;
            try
              {
                object.check(request);
              }
            catch (const InputError &)
              {
                continue; // not of these cells, or too coarse
              }
            SCOPED_TRACE(object.name + " of " + singular(kind));
            MeshDescription mesh = object.describe(request);
            check_mesh(mesh);
            EXPECT_FALSE(tells_of_vertices(mesh.warnings));
            mesh.vertices = jittered_vertices(mesh, 0.2);
            expect_conforming(mesh);
          }
  EXPECT_TRUE(make_mesh<3>("Jitter = 0.2")->warnings.empty());
}

TEST(Conformity, files_and_scripts_conform)
{
  const std::string bracket =
    "Object = file; File = bracket.geo; Scale = 1e-3; Cells = tetrahedra; "
    "Cell size = 0.003";
  EXPECT_FALSE(tells_of_vertices(make_mesh<3>(bracket, PARAMETERS)->warnings));
  for (const std::string file : {"plate_v2.msh", "plate_v41.msh", "plate.inp"})
    EXPECT_FALSE(tells_of_vertices(
      make_mesh<2>("Object = file; File = " + file, MESH_DATA)->warnings));
  for (const std::string cells : {"triangles", "quadrilaterals"})
    EXPECT_FALSE(tells_of_vertices(
      make_mesh<2>("Object = file; File = plate.geo; Scale = 0.001; "
                   "Cell size = 0.001; Cells = " +
                     cells,
                   MESH_DATA)
        ->warnings));
}

TEST(Conformity, a_half_refined_file_is_told)
{
  const auto mesh =
    make_mesh<2>("Object = file; File = half_refined.msh", MESH_DATA);
  ASSERT_TRUE(tells_of_vertices(mesh->warnings));
  for (const std::string &warning : mesh->warnings)
    if (warning.find("hang") != std::string::npos)
      expect_words(warning,
                   {"half_refined.msh",
                    "1 vertex that hangs",
                    "x = 0.01, y = 0.005 (m)",
                    "quadrilateral 5"});
}
