#include <springfit/core/error.h>
#include <springfit/mesh/sizes.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace springfit
{
  std::string
  text_of(const double value)
  {
    std::ostringstream text;
    text << value;
    return text.str();
  }


  void
  check_dimension(const ObjectRequest &request,
                  const int dim,
                  const std::string &object)
  {
    if (request.dim != dim && request.spacedim == dim)
      throw EntryError("Geometry/Cells",
                       object + " is no surface in space.",
                       "Set it to tetrahedra or hexahedra, or take a box.");
    if (request.dim != dim)
      throw EntryError("Geometry/Object",
                       object + " is an object of dimension " +
                         std::to_string(dim) + ", the scene has dimension " +
                         std::to_string(request.spacedim) + ".",
                       "Set Dimension to " + std::to_string(dim) +
                         ", or take a box.");
  }


  void
  check_lengths(const std::vector<double> &lengths, const std::string &entry)
  {
    for (const double length : lengths)
      if (!(std::isfinite(length) && length > 0.))
        throw EntryError(entry,
                         "'" + text_of(length) + "' is not a positive length.",
                         "Give lengths in m that are greater than 0.");
  }


  void
  check_sizes(const ObjectRequest &request)
  {
    const std::string dim = std::to_string(request.dim);
    if (request.size.size() != static_cast<unsigned int>(request.dim))
      throw EntryError("Geometry/Size",
                       std::to_string(request.size.size()) +
                         " numbers are given for an object of dimension " +
                         dim + ".",
                       "Give " + dim + " lengths in m, separated by commas.");
    check_lengths(request.size, "Geometry/Size");

    const auto n = request.cell_size.size();
    if (n != 1 && n != request.size.size())
      throw EntryError("Geometry/Cell size",
                       std::to_string(n) + " numbers are given.",
                       "Give one length in m, or " + dim +
                         " separated by commas.");
    if (n != 1 && is_simplex(request.cell_kind))
      throw EntryError("Geometry/Cell size",
                       std::to_string(n) + " numbers are given for " +
                         word_of(cell_kind_words(), request.cell_kind) + ".",
                       "Give one length in m: only quadrilaterals and "
                       "hexahedra have a size for each direction.");
    check_lengths(request.cell_size, "Geometry/Cell size");
    check_n_cells(estimate_n_cells(request));
  }


  double
  estimate_n_cells(const ObjectRequest &request)
  {
    // The measure of an equilateral simplex of unit edges is 1 / 2.31 in the
    // plane and 1 / 8.49 in space.
    double n_cells = request.cell_kind == CellKind::triangle      ? 2.31
                     : request.cell_kind == CellKind::tetrahedron ? 8.49
                                                                  : 1.;
    for (unsigned int d = 0; d < request.size.size(); ++d)
      n_cells *= std::max(1., request.size[d] / cell_size_along(request, d));
    return n_cells;
  }


  void
  check_n_cells(const double n_cells)
  {
    constexpr double most = 50e6;
    if (n_cells > most)
      throw EntryError("Geometry/Cell size",
                       "it would give about " + text_of(n_cells) +
                         " cells, more than " + text_of(most) + ".",
                       "Give a larger cell size (in m).");
  }


  double
  cell_size_along(const ObjectRequest &request, const unsigned int direction)
  {
    return request.cell_size[request.cell_size.size() == 1 ? 0 : direction];
  }


  unsigned int
  n_intervals(const double length, const double cell_size)
  {
    return std::max(1., std::round(length / cell_size));
  }
} // namespace springfit
