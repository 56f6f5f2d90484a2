#ifndef springfit_tests_models_meshes_h
#define springfit_tests_models_meshes_h

#include <springfit/mesh/build_mesh.h>

#include <deal.II/base/parameter_acceptor.h>

#include <memory>
#include <vector>

#include "../unit/cells.h"

namespace springfit::oracle
{
  /** A mesh of a single cell. */
  template <int dim>
  std::unique_ptr<Mesh<dim>>
  single_cell_mesh(const CellKind kind, const Eigen::MatrixXd &points)
  {
    MeshDescription description;
    description.cell_kind = kind;
    for (unsigned int v = 0; v < points.cols(); ++v)
      {
        MeshPoint point{};
        for (int d = 0; d < dim; ++d)
          point[d] = points(d, v);
        description.vertices.push_back(point);
        description.cells.push_back(v);
      }
    description.material_ids = {0};
    return build_mesh<dim>(description);
  }

  /**
   * A box of n^dim unit hexahedra or quadrilaterals scaled to @p size, its
   * inner vertices moved at random by up to @p jitter of the edge; boundary 1
   * is x = 0, boundary 2 is x = size, and all other sides are boundary 0.
   */
  template <int dim>
  std::unique_ptr<Mesh<dim>>
  box_mesh(const unsigned int n,
           const double size,
           const double jitter,
           Random &random)
  {
    MeshDescription description;
    description.cell_kind =
      dim == 2 ? CellKind::quadrilateral : CellKind::hexahedron;
    const unsigned int m        = n + 1;
    const unsigned int n_points = dim == 2 ? m * m : m * m * m;
    for (unsigned int p = 0; p < n_points; ++p)
      {
        const unsigned int index[3] = {p % m, p / m % m, p / (m * m)};
        bool inner                  = true;
        for (int d = 0; d < dim; ++d)
          inner = inner && index[d] > 0 && index[d] < n;
        MeshPoint point{};
        for (int d = 0; d < dim; ++d)
          point[d] =
            size / n * (index[d] + (inner ? random(-jitter, jitter) : 0.));
        description.vertices.push_back(point);

        bool has_cell = true;
        for (int d = 0; d < dim; ++d)
          has_cell = has_cell && index[d] < n;
        if (has_cell)
          {
            for (unsigned int v = 0; v < (1u << dim); ++v)
              description.cells.push_back(p + (v & 1) + (v >> 1 & 1) * m +
                                          (v >> 2 & 1) * m * m);
            description.material_ids.push_back(0);
            for (const unsigned int end : {0u, 1u})
              if (index[0] == (end == 0 ? 0 : n - 1))
                {
                  BoundaryFacet facet;
                  facet.id = 1 + end;
                  for (unsigned int v = 0; v < (1u << dim); ++v)
                    if ((v & 1) == end)
                      facet.vertices.push_back(p + (v & 1) + (v >> 1 & 1) * m +
                                               (v >> 2 & 1) * m * m);
                  description.facets.push_back(facet);
                }
          }
      }
    return build_mesh<dim>(description);
  }

  /** The vertices of a mesh in m, spacedim x n_nodes. */
  template <int dim, int spacedim>
  Eigen::MatrixXd
  nodes_of(const Mesh<dim, spacedim> &mesh)
  {
    const auto &vertices = mesh.triangulation.get_vertices();
    Eigen::MatrixXd nodes(spacedim, vertices.size());
    for (unsigned int v = 0; v < vertices.size(); ++v)
      for (int d = 0; d < spacedim; ++d)
        nodes(d, v) = vertices[v][d];
    return nodes;
  }

  /** A flag per unknown of flags per node. */
  inline std::vector<bool>
  unknowns_of(const unsigned int dim, const std::vector<bool> &nodes)
  {
    std::vector<bool> unknowns;
    for (const bool flag : nodes)
      unknowns.insert(unknowns.end(), dim, flag);
    return unknowns;
  }

  /** The nodes of a cell in the columns of nodes_of(). */
  template <int dim>
  std::vector<unsigned int>
  nodes_of_cell(
    const typename dealii::Triangulation<dim>::active_cell_iterator &cell)
  {
    std::vector<unsigned int> nodes;
    for (const unsigned int v : cell->vertex_indices())
      nodes.push_back(cell->vertex_index(v));
    return nodes;
  }

  /**
   * A step that owns a section of the parameter file, with some of its entries
   * set: @p entries is "subsection Loads\n set Cases = tension\nend".
   */
  template <typename Step>
  std::unique_ptr<Step>
  make_step(const std::string &entries)
  {
    dealii::ParameterAcceptor::clear();
    auto step = std::make_unique<Step>();
    dealii::ParameterAcceptor::declare_all_parameters();
    dealii::ParameterAcceptor::prm.parse_input_from_string(entries);
    dealii::ParameterAcceptor::parse_all_parameters();
    return step;
  }
} // namespace springfit::oracle

#endif
