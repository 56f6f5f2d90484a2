#ifndef springfit_comparison_interpolation_h
#define springfit_comparison_interpolation_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>

#include <deal.II/base/point.h>

#include <Eigen/SparseCore>

#include <vector>

namespace springfit
{
  /** From the nodes of a mesh to any points, by the shape functions. */
  struct Interpolation
  {
    /** n_nodes x n_points: fields as rows times this are those at the points.
     */
    Eigen::SparseMatrix<double> weights;

    /**
     * Of each point from the cell that it is taken to be in, m: 0 inside, and
     * not less than the true distance outside. There, as where a coarse mesh
     * cuts a curve short, the nearest cell's functions go on.
     */
    std::vector<double> distances;
  };

  /** @param element of the degree of the mesh's nodes */
  template <int dim, int spacedim>
  Interpolation
  interpolation(const Mesh<dim, spacedim> &mesh,
                const Element<dim, spacedim> &element,
                const std::vector<dealii::Point<spacedim>> &points);
} // namespace springfit

#endif
