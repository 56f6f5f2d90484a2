#include <springfit/output/csv.h>
#include <springfit/output/response_table.h>

namespace springfit
{
  template <int dim>
  void
  write_cells(const std::filesystem::path &folder, const Mesh<dim> &mesh)
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
                 const std::vector<bool> &fixed,
                 const Eigen::MatrixXd &forces,
                 const Eigen::MatrixXd &displacement)
  {
    CsvTable table("fixed,force_x,force_y,force_z,u_x,u_y,u_z");
    for (Eigen::Index node = 0; node < displacement.cols(); ++node)
      {
        table.new_row();
        table << (fixed[node] ? 1u : 0u);
        for (const Eigen::MatrixXd *field : {&forces, &displacement})
          for (Eigen::Index d = 0; d < 3; ++d)
            table.exactly(d < field->rows() ? (*field)(d, node) : 0.);
      }
    table.write(path);
  }

  template void
  write_cells<2>(const std::filesystem::path &, const Mesh<2> &);
  template void
  write_cells<3>(const std::filesystem::path &, const Mesh<3> &);
} // namespace springfit
