#ifndef springfit_calibration_congruence_h
#define springfit_calibration_congruence_h

#include <springfit/core/cell_kind.h>

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace springfit
{
  /**
   * What cells have in common that are copies of each other: to be compared and
   * hashed.
   */
  struct ShapeKey
  {
    CellKind kind;

    /**
     * Distances of the vertices, or their coordinates, relative to the largest
     * distance, as integers.
     */
    std::vector<std::int64_t> lengths;
  };

  bool
  operator==(const ShapeKey &a, const ShapeKey &b);

  bool
  operator!=(const ShapeKey &a, const ShapeKey &b);


  /** A cell's shape, and how the cell is got from it. */
  struct CanonicalShape
  {
    ShapeKey key;

    /**
     * Vertex v of the canonical numbering is vertex permutation[v] of the
     * cell.
     */
    std::vector<unsigned int> permutation;

    /**
     * The largest distance of two vertices, m. The constants of congruent
     * cells of one material (and thickness) are as size^(dim - 2).
     */
    double size;
  };

  /**
   * The canonical form of a cell up to rotations, mirror images, renumberings
   * and uniform scaling. The distances between all vertices determine
   * it up to motions and mirror images; of their sequences under the
   * renumberings in symmetries() the lexicographically smallest one is taken,
   * rounded to 1e-9 of the largest distance.
   *
   * Two congruent cells whose distances differ by rounding errors fall on the
   * two sides of a step once in some million cases, and are fitted twice.
   *
   * @param points dim x n_nodes, m
   */
  CanonicalShape
  canonical_shape(const Eigen::MatrixXd &points, CellKind kind);

  /**
   * The same where directions count: cells have one key if they are moved and
   * uniformly scaled copies of each other, vertex by vertex. The permutation is
   * the identity.
   *
   * @param points dim x n_nodes, m
   */
  CanonicalShape
  oriented_shape(const Eigen::MatrixXd &points, CellKind kind);
} // namespace springfit


template <>
struct std::hash<springfit::ShapeKey>
{
  std::size_t
  operator()(const springfit::ShapeKey &key) const noexcept;
};

#endif
