#ifndef springfit_studies_place_in_mesh_h
#define springfit_studies_place_in_mesh_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>

#include <deal.II/base/point.h>

#include <Eigen/Core>

#include <string>

namespace springfit
{
  /**
   * By which weights of the nodes a place (m) of a user's moves.
   *
   * @throws EntryError when it is outside of the mesh by more than a hundredth
   * of its size: a coarse mesh cuts curves short.
   */
  template <int dim, int spacedim>
  Eigen::VectorXd
  place_in_mesh(const dealii::Point<spacedim> &place,
                const Mesh<dim, spacedim> &mesh,
                const Element<dim, spacedim> &element,
                const std::string &entry);
} // namespace springfit

#endif
