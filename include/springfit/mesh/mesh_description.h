#ifndef springfit_mesh_mesh_description_h
#define springfit_mesh_mesh_description_h

#include <springfit/core/cell_kind.h>
#include <springfit/mesh/interval.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** x, y, z in m; z = 0 in a plane mesh. */
  using MeshPoint = std::array<double, 3>;

  /** Vertices of a side of a cell: an edge in 2-d, a face in 3-d. */
  struct BoundaryFacet
  {
    std::vector<unsigned int> vertices; // 2, 3 or 4, in any order
    unsigned int id = 0;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &vertices &id;
    }
  };

  /**
   * A mesh as numbers: what a geometry makes, what the checks look at and what
   * one rank sends to the others. Lengths in m.
   */
  struct MeshDescription
  {
    /** What a message calls the mesh: "The box", "Mesh file 'a.msh'". */
    std::string name;

    CellKind cell_kind = CellKind::triangle;
    std::vector<MeshPoint> vertices;

    /**
     * Vertices of all cells, n_vertices(cell_kind) for each, in deal.II's
     * numbering: simplices counter-clockwise, the others lexicographically.
     */
    std::vector<unsigned int> cells;

    /** One for each cell. */
    std::vector<unsigned int> material_ids;

    /** Numbers of the cells in their file; empty without a file. */
    std::vector<std::size_t> cell_numbers;

    /**
     * First cells of the groups that were numbered together (gmsh's surfaces
     * or volumes), in ascending order; empty if all cells were.
     */
    std::vector<unsigned int> group_begins;

    /** Sides on the boundary; those not listed have the id 0. */
    std::vector<BoundaryFacet> facets;

    /** An id may have several names, and a name several ids. */
    std::multimap<unsigned int, std::string> boundary_names;
    std::multimap<unsigned int, std::string> material_names;

    /** Names of the file that are no boundary or no material, and why. */
    std::map<std::string, std::string> unused_boundary_names;
    std::map<std::string, std::string> unused_material_names;

    std::vector<std::string> warnings;

    /** Which cells the user left out, if any: "120 of 1000 cells, ...". */
    std::string left_out;

    /**
     * Where along x the cross section is constant by design, so that a tensile
     * test measures there.
     */
    std::optional<Interval> straight_part;

    unsigned int
    n_cells() const
    {
      return cells.size() / n_vertices(cell_kind);
    }

    /** The n_vertices(cell_kind) vertices of a cell. */
    const unsigned int *
    cell(const unsigned int index) const
    {
      return cells.data() + std::size_t(index) * n_vertices(cell_kind);
    }

    unsigned int *
    cell(const unsigned int index)
    {
      return cells.data() + std::size_t(index) * n_vertices(cell_kind);
    }

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &name &cell_kind &vertices &cells &material_ids &cell_numbers
        &group_begins &facets &boundary_names &material_names
          &unused_boundary_names &unused_material_names &warnings &left_out;

      bool has_straight_part = straight_part.has_value();
      archive &has_straight_part;
      if (has_straight_part)
        {
          Interval interval = straight_part.value_or(Interval());
          archive &interval;
          straight_part = interval;
        }
    }
  };
} // namespace springfit

#endif
