#ifndef springfit_mesh_file_elements_h
#define springfit_mesh_file_elements_h

#include <springfit/core/cell_kind.h>
#include <springfit/mesh/mesh_description.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** The elements of one type of a mesh file. */
  struct FileElements
  {
    std::string type; // as the format calls it
    int dim;          // 0 for a point, ..., 3 for a volume
    unsigned int n_nodes;

    /** None if springfit has no such cells (wedges, second order). */
    std::optional<CellKind> cell_kind;

    std::vector<std::size_t> numbers; // in the file, for messages
    std::vector<unsigned int> ids;    // of the material or the boundary
    std::vector<std::size_t> nodes;   // n_nodes each, numbered around a face
  };

  /** A mesh and what became of the nodes of its file. */
  struct MeshOfElements
  {
    MeshDescription mesh;

    /** None if no cell has the node. */
    std::vector<std::optional<unsigned int>> vertex_of_node;
  };

  /** How to mend a scene whose file holds elements up to dimension @p dim. */
  std::string
  advice_on_dimension(int dim);

  /**
   * The mesh of the elements of dimension @p dim, without ids of boundaries.
   * Nodes without cells are counted in a warning, and so are elements that are
   * neither cells nor sides. @p points holds the nodes in
   * the file's units, @p name becomes the mesh's.
   *
   * @throws InputError when there are no such cells, or of several types, or of
   * a type that is none of CellKind.
   */
  MeshOfElements
  mesh_of_elements(const std::string &name,
                   int dim,
                   const std::vector<MeshPoint> &points,
                   const std::vector<FileElements> &elements);

  /**
   * Give the sides of the boundary the ids of the elements that lie on them;
   * @p elements are those of mesh_of_elements. Elements of one id are a group
   * as label_boundary_groups() has it, those of the id 0 are none.
   */
  void
  label_sides(MeshOfElements &result,
              const std::vector<FileElements> &elements);
} // namespace springfit

#endif
