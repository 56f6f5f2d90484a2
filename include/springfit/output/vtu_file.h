#ifndef springfit_output_vtu_file_h
#define springfit_output_vtu_file_h

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace springfit
{
  /** Types of cells by the numbers that VTK gives them. */
  enum class VtkCell : std::uint8_t
  {
    line          = 3,
    poly_line     = 4,
    triangle      = 5,
    quadrilateral = 9,
    tetrahedron   = 10,
    hexahedron    = 12
  };

  /** Numbers with a name: a row per component, a column per point or cell. */
  struct VtuArray
  {
    std::string name;
    std::variant<Eigen::MatrixXd, Eigen::MatrixXi> values;
  };

  /** What a file shows: cells that share their points. */
  struct UnstructuredGrid
  {
    Eigen::Matrix3Xd points; // m

    /** Of one cell after the other, in VTK's order, its points from 0. */
    std::vector<std::int32_t> connectivity;

    /** For each cell where its points end in the connectivity. */
    std::vector<std::int64_t> offsets;

    std::vector<VtkCell> types;

    std::vector<VtuArray> point_data;
    std::vector<VtuArray> cell_data;
  };

  void
  add_cell(UnstructuredGrid &grid,
           VtkCell type,
           const std::vector<unsigned int> &points);

  /**
   * The grid with those of its points alone that belong to a cell, in the same
   * order.
   */
  UnstructuredGrid
  without_loose_points(const UnstructuredGrid &grid);

  /**
   * A grid as VTK's XML file of an UnstructuredGrid, its numbers in full
   * precision, compressed by zlib and coded in base64: "VTK File Formats" of
   * the VTK User's Guide. The same grid is the same bytes.
   *
   * @throws RunError when a number is not finite or the file cannot be written.
   * @throws std::logic_error when an array has not a column for each point or
   * cell.
   */
  void
  write_vtu(const std::filesystem::path &path, const UnstructuredGrid &grid);

  /** A series of files in the folder of @p path, each with its place in it. */
  void
  write_pvd(const std::filesystem::path &path,
            const std::vector<std::pair<double, std::string>> &files);
} // namespace springfit

#endif
