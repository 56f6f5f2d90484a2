#include <springfit/mesh/cell_names.h>

#include <sstream>

namespace springfit
{
  std::string
  describe_cell(const MeshDescription &mesh, const unsigned int cell)
  {
    const int n_corners = n_vertices(mesh.cell_kind);
    MeshPoint centre    = {{0., 0., 0.}};
    for (int i = 0; i < n_corners; ++i)
      for (int d = 0; d < 3; ++d)
        centre[d] += mesh.vertices[mesh.cell(cell)[i]][d] / n_corners;

    std::ostringstream text;
    text.precision(4);
    text << singular(mesh.cell_kind) << ' '
         << (mesh.cell_numbers.empty() ? cell : mesh.cell_numbers[cell])
         << " (around x = " << centre[0] << ", y = " << centre[1];
    if (dimension(mesh.cell_kind) == 3 || centre[2] != 0.)
      text << ", z = " << centre[2];
    text << " m)";
    return text.str();
  }
} // namespace springfit
