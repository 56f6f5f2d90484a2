#include <springfit/comparison/interpolation.h>
#include <springfit/core/error.h>
#include <springfit/studies/place_in_mesh.h>

#include <deal.II/base/bounding_box.h>

#include <cmath>
#include <sstream>

namespace springfit
{
  template <int dim, int spacedim>
  Eigen::VectorXd
  place_in_mesh(const dealii::Point<spacedim> &place,
                const Mesh<dim, spacedim> &mesh,
                const Element<dim, spacedim> &element,
                const std::string &entry)
  {
    const auto there = interpolation(mesh, element, {place});
    const dealii::BoundingBox<spacedim> box(mesh.triangulation.get_vertices());
    double square = 0.;
    for (int d = 0; d < spacedim; ++d)
      square += std::pow(box.side_length(d), 2);
    if (there.distances[0] > 0.01 * std::sqrt(square))
      {
        std::ostringstream what;
        what << "the point (" << place << ") m is outside of the mesh, about "
             << there.distances[0] << " m away.";
        throw EntryError(entry,
                         what.str(),
                         "Give a place in the object, in m.");
      }
    return Eigen::VectorXd(there.weights.col(0));
  }

  template Eigen::VectorXd
  place_in_mesh(const dealii::Point<2> &,
                const Mesh<2> &,
                const Element<2> &,
                const std::string &);
  template Eigen::VectorXd
  place_in_mesh(const dealii::Point<3> &,
                const Mesh<2, 3> &,
                const Element<2, 3> &,
                const std::string &);
  template Eigen::VectorXd
  place_in_mesh(const dealii::Point<3> &,
                const Mesh<3> &,
                const Element<3> &,
                const std::string &);
} // namespace springfit
