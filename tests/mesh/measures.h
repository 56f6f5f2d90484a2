#ifndef springfit_tests_mesh_measures_h
#define springfit_tests_mesh_measures_h

#include <springfit/calibration/shape_quality.h>
#include <springfit/mesh/boundaries.h>
#include <springfit/mesh/mesh.h>
#include <springfit/reference/cell_frame.h>
#include <springfit/reference/cell_matrices.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

/** Of the cell that has the worst. */
template <int dim>
double
worst_shape_quality(const springfit::Mesh<dim> &mesh)
{
  double worst = 1.;
  for (const auto &cell : mesh.triangulation.active_cell_iterators())
    worst = std::min(worst,
                     springfit::shape_quality(springfit::cell_points<dim>(cell),
                                              mesh.cell_kind));
  return worst;
}

/** Both counts within a part of the published ones. */
template <int dim>
void
expect_counts_near(const springfit::Mesh<dim> &mesh,
                   const double n_nodes,
                   const double n_cells,
                   const double part)
{
  EXPECT_NEAR(mesh.triangulation.n_vertices(), n_nodes, part * n_nodes);
  EXPECT_NEAR(mesh.triangulation.n_active_cells(), n_cells, part * n_cells);
}

/** Names and areas of the boundaries 0, 1, ..., and no warning. */
template <int dim>
void
expect_boundaries(const springfit::Mesh<dim> &mesh,
                  const std::vector<std::string> &names,
                  const std::vector<double> &areas,
                  const double tolerance)
{
  const auto table = springfit::boundary_table(mesh);
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
inline double
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

#endif
