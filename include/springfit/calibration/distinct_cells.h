#ifndef springfit_calibration_distinct_cells_h
#define springfit_calibration_distinct_cells_h

#include <springfit/mesh/mesh.h>

#include <vector>

namespace springfit
{
  /** The cells of a mesh that one fit serves. */
  struct DistinctCell
  {
    unsigned int representative; // active cell index
    dealii::types::material_id material;
    unsigned int multiplicity;
  };

  /** How a cell repeats a distinct one. */
  struct CellCopy
  {
    unsigned int distinct;

    /**
     * The cell's nodes in the order that makes it a copy of the representative
     * in the representative's own numbering.
     */
    std::vector<unsigned int> nodes;

    /** Length of the cell / length of the representative. */
    double scale;
  };

  struct DistinctCells
  {
    std::vector<DistinctCell> distinct;
    std::vector<CellCopy> copies; // by active cell index
  };

  /**
   * Sort the cells of a mesh by shape and material: rotated, mirrored,
   * renumbered and uniformly scaled copies of a cell have the same spring
   * constants up to the power dim - 2 of the scale.
   */
  template <int dim, int spacedim>
  DistinctCells
  find_distinct_cells(const Mesh<dim, spacedim> &mesh);

  /**
   * The same of constants that depend on the cell's directions: only moved and
   * uniformly scaled copies share them.
   */
  template <int dim, int spacedim>
  DistinctCells
  find_distinct_oriented_cells(const Mesh<dim, spacedim> &mesh);

  /** Each cell as a distinct one, for what does not depend on it alone. */
  template <int dim, int spacedim>
  DistinctCells
  every_cell(const Mesh<dim, spacedim> &mesh);
} // namespace springfit

#endif
