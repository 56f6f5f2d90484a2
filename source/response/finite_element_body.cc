#include <springfit/response/finite_element_body.h>

namespace springfit
{
  namespace
  {
    template <typename Cell>
    Eigen::MatrixXd
    on_vertices(const Eigen::MatrixXd &displacement, const Cell &cell)
    {
      Eigen::MatrixXd of_cell(displacement.rows(), cell->n_vertices());
      for (const unsigned int v : cell->vertex_indices())
        of_cell.col(v) = displacement.col(cell->vertex_index(v));
      return of_cell;
    }
  } // namespace

  template <int dim>
  FiniteElementBody<dim>::FiniteElementBody(const Mesh<dim> &mesh,
                                            const Element<dim> &element,
                                            const MaterialTable &materials,
                                            const MaterialLaw law)
    : materials_(materials), energy_(element, law)
  {
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      cells_.push_back(cell);
  }

  template <int dim>
  unsigned int
  FiniteElementBody<dim>::n_terms() const
  {
    return cells_.size();
  }

  template <int dim>
  unsigned int
  FiniteElementBody<dim>::first_node(const unsigned int term) const
  {
    return cells_[term]->vertex_index(0);
  }

  template <int dim>
  std::optional<EnergyTerm>
  FiniteElementBody<dim>::evaluate(const unsigned int term,
                                   const Eigen::MatrixXd &displacement) const
  {
    const auto &cell = cells_[term];
    return energy_.evaluate(cell,
                            materials_.at(cell->material_id()),
                            on_vertices(displacement, cell));
  }

  template <int dim>
  unsigned int
  n_inverted_cells(const Mesh<dim> &mesh,
                   const Element<dim> &element,
                   const Eigen::MatrixXd &displacement)
  {
    CellEnergy<dim> energy(element, MaterialLaw::linear);
    unsigned int n = 0;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      if (!(energy.smallest_jacobian(cell, on_vertices(displacement, cell)) >
            0.))
        ++n;
    return n;
  }

  template class FiniteElementBody<2>;
  template class FiniteElementBody<3>;
  template unsigned int
  n_inverted_cells<2>(const Mesh<2> &,
                      const Element<2> &,
                      const Eigen::MatrixXd &);
  template unsigned int
  n_inverted_cells<3>(const Mesh<3> &,
                      const Element<3> &,
                      const Eigen::MatrixXd &);
} // namespace springfit
