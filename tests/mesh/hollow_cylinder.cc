// The hollow cylinder of Natsupakpong and Cavusoglu (2010).

#include <springfit/mesh/boundaries.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "measures.h"
#include "messages.h"
#include "scene.h"

using namespace springfit;


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

TEST(HollowCylinder, IsNotMadeOfWrongEntries)
{
  expect_error([]() { make_mesh<2>("Object = hollow cylinder"); },
               {"Geometry/Object", "dimension 3"});
  expect_error([]() { make_mesh<3>("Object = hollow cylinder"); },
               {"Geometry/Cells", "tetrahedra"});

  using Case = std::pair<std::string, std::vector<std::string>>;
  for (const auto &[entries, words] : std::vector<Case>{
         {"Size = 0.012, 0.02, 0.02", {"Geometry/Size", "0.0132 m"}},
         {"Cell size = 0.007", {"Geometry/Cell size", "0.006 (in m) or less"}}})
    expect_error(
      [&, e = entries]() {
        make_mesh<3>("Object = hollow cylinder; Cells = tetrahedra; " + e);
      },
      words);
}
