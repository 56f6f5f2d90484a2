#include <springfit/core/words.h>
#include <springfit/mesh/boundaries.h>
#include <springfit/response/boundary_parts.h>
#include <springfit/response/region.h>

namespace springfit
{
  namespace
  {
    template <int dim, int spacedim, typename Condition>
    Faces<dim, spacedim>
    selected_faces(const Mesh<dim, spacedim> &mesh, const Condition &condition)
    {
      Faces<dim, spacedim> faces;
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && condition(cell->face(f)))
            faces.push_back({cell, f});
      return faces;
    }
  } // namespace

  template <int dim, int spacedim>
  Faces<dim, spacedim>
  faces_of_boundaries(const Mesh<dim, spacedim> &mesh,
                      const std::string &boundaries,
                      const std::string &entry)
  {
    const auto ids = find_boundaries(mesh, split_at_commas(boundaries), entry);
    return selected_faces(mesh, [&](const auto &face) {
      return ids.count(face->boundary_id()) > 0;
    });
  }

  template <int dim, int spacedim>
  Faces<dim, spacedim>
  faces_where(const Mesh<dim, spacedim> &mesh,
              const std::string &condition,
              const std::string &entry)
  {
    const Region<spacedim> region(condition, entry);
    return selected_faces(mesh, [&](const auto &face) {
      for (const unsigned int v : face->vertex_indices())
        if (!region.contains(face->vertex(v)))
          return false;
      return true;
    });
  }

  template <int dim, int spacedim>
  std::vector<bool>
  nodes_of_faces(const Mesh<dim, spacedim> &mesh,
                 const Faces<dim, spacedim> &faces)
  {
    std::vector<bool> nodes(mesh.nodes.size(), false);
    for (const auto &[cell, number] : faces)
      for (const unsigned int a : mesh.nodes.of_faces[number])
        nodes[mesh.nodes.of(cell)[a]] = true;
    return nodes;
  }

  template <int dim, int spacedim>
  std::vector<bool>
  nodes_where(const Mesh<dim, spacedim> &mesh,
              const std::string &condition,
              const std::string &entry)
  {
    const Region<spacedim> region(condition, entry);
    const auto &places = mesh.nodes.places;
    std::vector<bool> nodes(places.size());
    for (unsigned int v = 0; v < places.size(); ++v)
      nodes[v] = region.contains(places[v]);
    return nodes;
  }

  template Faces<2>
  faces_of_boundaries(const Mesh<2> &,
                      const std::string &,
                      const std::string &);
  template Faces<2>
  faces_where(const Mesh<2> &, const std::string &, const std::string &);
  template std::vector<bool>
  nodes_of_faces(const Mesh<2> &, const Faces<2> &);
  template std::vector<bool>
  nodes_where(const Mesh<2> &, const std::string &, const std::string &);
  template Faces<2, 3>
  faces_of_boundaries(const Mesh<2, 3> &,
                      const std::string &,
                      const std::string &);
  template Faces<3>
  faces_of_boundaries(const Mesh<3> &,
                      const std::string &,
                      const std::string &);
  template Faces<2, 3>
  faces_where(const Mesh<2, 3> &, const std::string &, const std::string &);
  template Faces<3>
  faces_where(const Mesh<3> &, const std::string &, const std::string &);
  template std::vector<bool>
  nodes_of_faces(const Mesh<2, 3> &, const Faces<2, 3> &);
  template std::vector<bool>
  nodes_of_faces(const Mesh<3> &, const Faces<3> &);
  template std::vector<bool>
  nodes_where(const Mesh<2, 3> &, const std::string &, const std::string &);
  template std::vector<bool>
  nodes_where(const Mesh<3> &, const std::string &, const std::string &);
} // namespace springfit
