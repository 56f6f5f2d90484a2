#ifndef springfit_response_boundary_parts_h
#define springfit_response_boundary_parts_h

#include <springfit/mesh/mesh.h>
#include <springfit/response/loaded_surface.h>

#include <string>
#include <vector>

namespace springfit
{
  // Parts of a mesh that a user names: by boundaries (ids or names between
  // commas), or by a condition on the place, see Region. All of them take the
  // name of the parameter for errors, and throw EntryError when a boundary is
  // unknown or a condition cannot be understood. Nothing found is no error.

  template <int dim, int spacedim = dim>
  using Faces = std::vector<typename LoadedSurface<dim, spacedim>::Face>;

  template <int dim, int spacedim>
  Faces<dim, spacedim>
  faces_of_boundaries(const Mesh<dim, spacedim> &mesh,
                      const std::string &boundaries,
                      const std::string &entry);

  /** Faces of the boundary all of whose vertices meet the condition. */
  template <int dim, int spacedim>
  Faces<dim, spacedim>
  faces_where(const Mesh<dim, spacedim> &mesh,
              const std::string &condition,
              const std::string &entry);

  /** A flag per node: those of these faces. */
  template <int dim, int spacedim>
  std::vector<bool>
  nodes_of_faces(const Mesh<dim, spacedim> &mesh,
                 const Faces<dim, spacedim> &faces);

  /** A flag per node, inside the body as well. */
  template <int dim, int spacedim>
  std::vector<bool>
  nodes_where(const Mesh<dim, spacedim> &mesh,
              const std::string &condition,
              const std::string &entry);
} // namespace springfit

#endif
