#include <springfit/output/csv.h>
#include <springfit/output/response_table.h>

#include <algorithm>

namespace springfit
{
  template <int dim, int spacedim>
  void
  write_cells(const std::filesystem::path &folder,
              const Mesh<dim, spacedim> &mesh)
  {
    std::string header = "v0";
    for (int v = 1; v < n_vertices(mesh.cell_kind); ++v)
      header += ",v" + std::to_string(v);
    CsvTable table(header);
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        table.new_row();
        for (const unsigned int v : cell->vertex_indices())
          table << cell->vertex_index(v);
      }
    table.write(folder / "cells.csv");
  }

  void
  write_response(const std::filesystem::path &path,
                 const std::vector<bool> &held,
                 const Eigen::MatrixXd &forces,
                 const Eigen::MatrixXd &displacement,
                 const Eigen::MatrixXd &reactions)
  {
    const Eigen::Index dim = forces.rows();
    CsvTable table("fixed,force_x,force_y,force_z,u_x,u_y,u_z,held_x,held_y,"
                   "held_z,reaction_x,reaction_y,reaction_z");
    const auto add_vector = [&](const Eigen::MatrixXd &field,
                                const Eigen::Index node) {
      for (Eigen::Index d = 0; d < 3; ++d)
        table.exactly(d < dim ? field(d, node) : 0.);
    };
    for (Eigen::Index node = 0; node < displacement.cols(); ++node)
      {
        const auto first = held.begin() + dim * node;
        table.new_row();
        table << (std::count(first, first + dim, true) == dim ? 1u : 0u);
        add_vector(forces, node);
        add_vector(displacement, node);
        for (Eigen::Index d = 0; d < 3; ++d)
          table << (d < dim && first[d] ? 1u : 0u);
        add_vector(reactions, node);
      }
    table.write(path);
  }

  template void
  write_cells<2>(const std::filesystem::path &, const Mesh<2> &);
  template void
  write_cells<2, 3>(const std::filesystem::path &, const Mesh<2, 3> &);
  template void
  write_cells<3>(const std::filesystem::path &, const Mesh<3> &);
} // namespace springfit
