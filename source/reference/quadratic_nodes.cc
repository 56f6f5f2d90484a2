#include <springfit/reference/element.h>
#include <springfit/reference/quadratic_nodes.h>

#include <deal.II/base/utilities.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>

namespace springfit
{
  namespace
  {
    /**
     * The positions of the shape functions that do not vanish on each face: a
     * support point is on a face where the linear functions of all vertices
     * that are not are 0.
     */
    template <int dim, int spacedim>
    std::vector<std::vector<unsigned int>>
    nodes_of_faces(const dealii::FiniteElement<dim, spacedim> &linear,
                   const dealii::FiniteElement<dim, spacedim> &quadratic)
    {
      const auto reference = linear.reference_cell();
      std::vector<std::vector<unsigned int>> nodes;
      for (const unsigned int f : reference.face_indices())
        {
          std::vector<bool> is_on(reference.n_vertices(), false);
          for (const unsigned int v :
               reference.face_reference_cell(f).vertex_indices())
            is_on[reference.face_to_cell_vertices(f, v, 1)] = true;
          nodes.emplace_back();
          for (unsigned int a = 0; a < quadratic.dofs_per_cell; ++a)
            {
              double others = 0.;
              for (unsigned int v = 0; v < is_on.size(); ++v)
                if (!is_on[v])
                  others +=
                    linear.shape_value(v, quadratic.unit_support_point(a));
              if (others < 1e-12)
                nodes.back().push_back(a);
            }
        }
      return nodes;
    }
  } // namespace

  template <int dim, int spacedim>
  Nodes<spacedim>
  quadratic_nodes(const Mesh<dim, spacedim> &mesh)
  {
    const auto linear  = make_element<dim, spacedim>(mesh.cell_kind, 1);
    const auto element = make_element<dim, spacedim>(mesh.cell_kind, 2);
    dealii::DoFHandler<dim, spacedim> dof_handler(mesh.triangulation);
    dof_handler.distribute_dofs(*element.scalar);

    Nodes<spacedim> nodes;
    nodes.degree   = 2;
    nodes.places   = mesh.triangulation.get_vertices();
    nodes.of_faces = nodes_of_faces(*linear.scalar, *element.scalar);

    constexpr auto unknown = dealii::numbers::invalid_unsigned_int;
    std::vector<unsigned int> node_of_dof(dof_handler.n_dofs(), unknown);
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        node_of_dof[cell->vertex_dof_index(v, 0)] = cell->vertex_index(v);

    dealii::FEValues<dim, spacedim> values(
      *element.mapping,
      *element.scalar,
      dealii::Quadrature<dim>(element.scalar->get_unit_support_points()),
      dealii::update_quadrature_points);
    std::vector<dealii::types::global_dof_index> dofs(
      element.scalar->dofs_per_cell);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        nodes.of_cells.emplace_back();
        for (unsigned int a = 0; a < dofs.size(); ++a)
          {
            unsigned int &node = node_of_dof[dofs[a]];
            if (node == unknown)
              {
                node = nodes.places.size();
                nodes.places.push_back(values.quadrature_point(a));
              }
            nodes.of_cells.back().push_back(node);
          }
      }
    return nodes;
  }

  template Nodes<2>
  quadratic_nodes(const Mesh<2> &);
  template Nodes<3>
  quadratic_nodes(const Mesh<2, 3> &);
  template Nodes<3>
  quadratic_nodes(const Mesh<3> &);
} // namespace springfit
