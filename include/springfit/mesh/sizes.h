#ifndef springfit_mesh_sizes_h
#define springfit_mesh_sizes_h

#include <springfit/mesh/objects.h>

#include <string>
#include <vector>

namespace springfit
{
  /** A number as a message shows it: six digits. */
  std::string
  text_of(double value);

  /**
   * @throws EntryError when the scene's dimension is not @p dim; @p object is
   * "a cylinder".
   */
  void
  check_dimension(const ObjectRequest &request,
                  int dim,
                  const std::string &object);

  /** @throws EntryError when a length is not a finite positive number. */
  void
  check_lengths(const std::vector<double> &lengths, const std::string &entry);

  /**
   * Check the entries Size and Cell size of an object that is made here:
   * finite positive numbers, as many as they should be, and at most 50 million
   * cells.
   *
   * @throws EntryError
   */
  void
  check_sizes(const ObjectRequest &request);

  /** About how many cells the box around the object would have. */
  double
  estimate_n_cells(const ObjectRequest &request);

  /** @throws EntryError when @p n_cells is beyond 50 million. */
  void
  check_n_cells(double n_cells);

  /** The cell size along x, y or z (@p direction 0, 1 or 2), in m. */
  double
  cell_size_along(const ObjectRequest &request, unsigned int direction);

  /** How many cells of about the size @p cell_size fill @p length: >= 1. */
  unsigned int
  n_intervals(double length, double cell_size);
} // namespace springfit

#endif
