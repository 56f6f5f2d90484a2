#ifndef springfit_mesh_numbered_elements_h
#define springfit_mesh_numbered_elements_h

#include <springfit/mesh/file_elements.h>
#include <springfit/mesh/known_numbers.h>
#include <springfit/mesh/mesh_description.h>
#include <springfit/mesh/mesh_text.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace springfit
{
  /**
   * The nodes and elements of a file that gives them numbers of its own choice,
   * in any order: the mesh that they make, and what their numbers mean in it.
   */
  class NumberedElements
  {
  public:
    NumberedElements();

    /** @throws InputError when there is a node of that number already. */
    void
    add_node(std::size_t number,
             const MeshPoint &point,
             const TextPlace &place);

    /**
     * @p type tells the shape; its lists are empty. @p nodes are numbers.
     *
     * @throws InputError when there is an element of that number already.
     */
    void
    add_element(const FileElements &type,
                std::size_t number,
                unsigned int id,
                const std::vector<std::size_t> &nodes,
                const TextPlace &place);

    /**
     * Make the mesh, whose vertices are in the order of the nodes' numbers.
     * After it nothing is added.
     *
     * @throws InputError when an element has a node that is not there, and
     * those of mesh_of_elements.
     */
    void
    make_mesh(const std::string &name, int dim);

    /** After make_mesh(): the ids of the elements become those of their sides,
     * as label_sides() has it. */
    void
    label_sides_by_ids();

    MeshDescription &
    mesh();

    bool
    has_node(std::size_t number) const;

    bool
    has_element(std::size_t number) const;

    /** After make_mesh(), of a node that is there; none if no cell has it. */
    std::optional<unsigned int>
    vertex_of(std::size_t node) const;

    /** After make_mesh(), of an element that is there; none if it is no cell.
     */
    std::optional<unsigned int>
    cell_of(std::size_t element) const;

    /**
     * After make_mesh(): the vertices of an element of dimension dim - 1 in
     * ascending order; none if it is no such element, or has nodes that no cell
     * has.
     */
    std::optional<std::vector<unsigned int>>
    side_of(std::size_t element) const;

  private:
    struct Element
    {
      std::size_t type, position; // in elements_, and in its lists
      TextPlace place;
    };

    KnownNumbers known_nodes_, known_elements_;
    std::map<std::size_t, MeshPoint> nodes_;
    std::unordered_map<std::size_t, std::size_t> index_of_node_;

    /** Their nodes are numbers until the mesh is made, and indices then. */
    std::vector<FileElements> elements_;
    std::unordered_map<std::size_t, Element> element_of_number_;
    MeshOfElements result_;
  };
} // namespace springfit

#endif
