#ifndef springfit_mesh_abaqus_cells_h
#define springfit_mesh_abaqus_cells_h

#include <springfit/mesh/abaqus_model.h>
#include <springfit/mesh/abaqus_sets.h>
#include <springfit/mesh/file_elements.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  /** The cells of an Abaqus model as a mesh, and what its labels mean there. */
  class AbaqusCells
  {
  public:
    /**
     * All instances make one mesh, that of their elements of dimension @p dim.
     *
     * @throws InputError when an element has a node that is not defined, and
     * those of mesh_of_elements.
     */
    AbaqusCells(const AbaqusModel &model, const std::string &name, int dim);

    MeshDescription &
    mesh();

    int
    dim() const;

    /** Each cell's instance and element. */
    const std::vector<std::pair<unsigned int, const AbaqusElement *>> &
    elements() const;

    /** None if no cell has the node. */
    std::optional<unsigned int>
    vertex_of(const AbaqusItem &node) const;

    /** The vertices of some nodes in ascending order; none if one has none. */
    std::optional<std::vector<unsigned int>>
    side_of(unsigned int instance, const std::vector<std::size_t> &nodes) const;

  private:
    const AbaqusModel &model_;
    const int dim_;
    std::vector<AbaqusItem> nodes_; // ascending
    MeshOfElements result_;
    std::vector<std::pair<unsigned int, const AbaqusElement *>> elements_;
  };
} // namespace springfit

#endif
