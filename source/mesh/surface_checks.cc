#include <springfit/core/error.h>
#include <springfit/mesh/cell_names.h>
#include <springfit/mesh/connection.h>
#include <springfit/mesh/mesh_checks.h>

#include <Eigen/Geometry>

namespace springfit
{
  namespace
  {
    /** Twice the area, relative to the product of two edges. */
    double
    relative_area(const MeshDescription &mesh, const unsigned int cell)
    {
      const auto corner = [&](const unsigned int i) {
        return Eigen::Vector3d(mesh.vertices[mesh.cell(cell)[i]].data());
      };
      const Eigen::Vector3d a = corner(1) - corner(0);
      const Eigen::Vector3d b = corner(2) - corner(0);
      const double scale      = a.norm() * b.norm();
      return scale > 0. ? a.cross(b).norm() / scale : 0.;
    }

    void
    check_areas(const MeshDescription &mesh)
    {
      constexpr double rounding = 1e-10;
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        if (!(relative_area(mesh, c) > rounding))
          throw InputError(mesh.name + ": " + describe_cell(mesh, c) +
                             " has no area.",
                           "Move its vertices apart, or mesh the object anew.");
    }
  } // namespace


  void
  check_surface(MeshDescription &mesh)
  {
    check_not_empty(mesh);
    check_coordinates(mesh);
    check_vertices_are_used(mesh);
    check_no_duplicate_cells(mesh);
    check_areas(mesh);
    check_connection(mesh);
  }
} // namespace springfit
