#include <springfit/reference/element.h>
#include <springfit/response/discretization.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/vector.h>

namespace springfit
{
  template <int dim>
  template <int dim_of_cells>
  Discretization<dim>::Discretization(const Mesh<dim_of_cells, dim> &mesh,
                                      const std::vector<bool> &held,
                                      const MPI_Comm communicator)
    : nodes_(mesh.nodes.places), held_(held), communicator_(communicator)
  {
    const auto element =
      make_element<dim_of_cells, dim>(mesh.cell_kind, mesh.nodes.degree);
    const dealii::FESystem<dim_of_cells, dim> elements(*element.scalar, dim);
    dealii::DoFHandler<dim_of_cells, dim> dof_handler(mesh.triangulation);
    dof_handler.distribute_dofs(elements);
    dealii::DoFRenumbering::subdomain_wise(dof_handler);

    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(communicator);
    const auto owned_by_rank =
      dealii::DoFTools::locally_owned_dofs_per_subdomain(dof_handler);
    locally_owned_ = rank < owned_by_rank.size()
                       ? owned_by_rank[rank]
                       : dealii::IndexSet(dof_handler.n_dofs());

    dofs_.resize(dim * n_nodes());
    std::vector<dealii::types::global_dof_index> of_cell(
      elements.dofs_per_cell);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const auto &nodes = mesh.nodes.of(cell);
        cell->get_dof_indices(of_cell);
        for (unsigned int i = 0; i < of_cell.size(); ++i)
          {
            const auto [d, a]         = elements.system_to_component_index(i);
            dofs_[dim * nodes[a] + d] = of_cell[i];
          }
      }

    for (unsigned int v = 0; v < n_nodes(); ++v)
      for (int d = 0; d < dim; ++d)
        if (held[dim * v + d])
          constraints_.add_line(dof(v, d));
    constraints_.close();

    // Every rank knows all cells, and with them all entries of its own rows.
    pattern_.reinit(dof_handler.n_dofs(), dof_handler.n_dofs(), locally_owned_);
    dealii::DoFTools::make_sparsity_pattern(dof_handler,
                                            pattern_,
                                            constraints_,
                                            /*keep_constrained_dofs*/ true);
  }

  template <int dim>
  const std::vector<dealii::Point<dim>> &
  Discretization<dim>::nodes() const
  {
    return nodes_;
  }

  template <int dim>
  dealii::types::global_dof_index
  Discretization<dim>::dof(const unsigned int v, const unsigned int d) const
  {
    return dofs_[dim * v + d];
  }

  template <int dim>
  unsigned int
  Discretization<dim>::n_nodes() const
  {
    return nodes_.size();
  }

  template <int dim>
  const std::vector<bool> &
  Discretization<dim>::held() const
  {
    return held_;
  }

  template <int dim>
  const dealii::AffineConstraints<double> &
  Discretization<dim>::constraints() const
  {
    return constraints_;
  }

  template <int dim>
  const dealii::IndexSet &
  Discretization<dim>::locally_owned() const
  {
    return locally_owned_;
  }

  template <int dim>
  std::vector<bool>
  Discretization<dim>::owned_nodes() const
  {
    std::vector<bool> owned(n_nodes());
    for (unsigned int v = 0; v < n_nodes(); ++v)
      owned[v] = locally_owned_.is_element(dof(v, 0));
    return owned;
  }

  template <int dim>
  MPI_Comm
  Discretization<dim>::communicator() const
  {
    return communicator_;
  }

  template <int dim>
  void
  Discretization<dim>::initialize(Matrix &matrix) const
  {
    matrix.reinit(
      locally_owned_, locally_owned_, pattern_, communicator_, false);
  }

  template <int dim>
  typename Discretization<dim>::Vector
  Discretization<dim>::to_vector(const Eigen::MatrixXd &nodal) const
  {
    Vector vector(locally_owned_, communicator_);
    for (unsigned int v = 0; v < n_nodes(); ++v)
      for (int d = 0; d < dim; ++d)
        if (locally_owned_.is_element(dof(v, d)) &&
            !constraints_.is_constrained(dof(v, d)))
          vector(dof(v, d)) = nodal(d, v);
    vector.compress(dealii::VectorOperation::insert);
    return vector;
  }

  template <int dim>
  Eigen::MatrixXd
  Discretization<dim>::to_nodal(const Vector &vector) const
  {
    const dealii::Vector<double> everywhere(vector);
    Eigen::MatrixXd nodal(dim, n_nodes());
    for (unsigned int v = 0; v < n_nodes(); ++v)
      for (int d = 0; d < dim; ++d)
        nodal(d, v) = everywhere(dof(v, d));
    return nodal;
  }

  template class Discretization<2>;
  template class Discretization<3>;
  template Discretization<2>::Discretization(const Mesh<2> &,
                                             const std::vector<bool> &,
                                             MPI_Comm);
  template Discretization<3>::Discretization(const Mesh<2, 3> &,
                                             const std::vector<bool> &,
                                             MPI_Comm);
  template Discretization<3>::Discretization(const Mesh<3> &,
                                             const std::vector<bool> &,
                                             MPI_Comm);
} // namespace springfit
