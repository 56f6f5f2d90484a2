#include <springfit/core/cell_kind.h>
#include <springfit/output/network_vtu.h>
#include <springfit/springs/by_table.h>

#include <cstddef>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    /** Whether the nodes of a kind are the vertices of a cell, n0, n1, ... */
    bool
    is_of_cells(const SpringKind &kind)
    {
      return kind.node_names().front() == "n0";
    }

    CellKind
    cell_of(const SpringKind &kind, const Eigen::Index dim)
    {
      switch (kind.n_nodes())
        {
          case 3:
            return CellKind::triangle;
          case 4:
            return dim == 2 ? CellKind::quadrilateral : CellKind::tetrahedron;
          case 8:
            return CellKind::hexahedron;
          default:
            throw std::logic_error("'" + kind.word() + "' are of no cell");
        }
    }

    void
    add_member(UnstructuredGrid &grid,
               const SpringKind &kind,
               const Eigen::Index dim,
               const std::vector<unsigned int> &nodes)
    {
      if (is_of_cells(kind))
        add_cell(grid, cell_of(kind, dim), nodes);
      else
        add_cell(grid,
                 nodes.size() == 2 ? VtkCell::line : VtkCell::poly_line,
                 nodes);
    }
  } // namespace

  void
  write_network_vtu(const std::filesystem::path &folder,
                    const std::string &name,
                    const SpringNetwork &network,
                    const std::vector<NodalField> &fields)
  {
    const auto nodes = node_grid(network.nodes, fields);
    for (const auto &family : by_table(network.families))
      {
        const auto &kind = *family.kind;
        auto grid        = nodes;
        for (std::size_t m = 0; m < family.size(); ++m)
          add_member(grid,
                     kind,
                     network.nodes.rows(),
                     {family.nodes(m), family.nodes(m) + kind.n_nodes()});
        for (std::size_t c = 0; c < kind.columns().size(); ++c)
          {
            const auto &column = kind.columns()[c];
            grid.cell_data.push_back(
              {column.name,
               Eigen::MatrixXd(Eigen::Map<const Eigen::MatrixXd>(
                 family.members.columns[c].data(),
                 column.width,
                 family.size()))});
          }
        write_vtu(folder / (kind.word() + '_' + name + ".vtu"), grid);
      }
  }
} // namespace springfit
