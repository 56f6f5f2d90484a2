#include <springfit/reference/cell_matrices.h>
#include <springfit/response/stiffness_matrices.h>
#include <springfit/springs/length.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

namespace springfit
{
  namespace
  {
    /** Add a dense matrix on the dofs of some nodes. */
    template <int dim>
    void
    add(const Discretization<dim> &discretization,
        const Eigen::MatrixXd &dense,
        const std::vector<unsigned int> &nodes,
        dealii::FullMatrix<double> &buffer,
        std::vector<dealii::types::global_dof_index> &dofs,
        typename Discretization<dim>::Matrix &matrix)
    {
      const unsigned int n = dense.rows();
      buffer.reinit(n, n);
      dofs.resize(n);
      for (unsigned int a = 0; a < n; ++a)
        {
          dofs[a] = discretization.dof(nodes[a / dim], a % dim);
          for (unsigned int b = 0; b < n; ++b)
            buffer(a, b) = dense(a, b);
        }
      discretization.constraints().distribute_local_to_global(buffer,
                                                              dofs,
                                                              matrix);
    }
  } // namespace

  template <int dim>
  void
  assemble_finite_elements(const Discretization<dim> &discretization,
                           const Element<dim> &element,
                           const MaterialTable &materials,
                           typename Discretization<dim>::Matrix &matrix)
  {
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(discretization.communicator());
    CellMatrices<dim> cell_matrices(element);
    dealii::FullMatrix<double> buffer;
    std::vector<dealii::types::global_dof_index> dofs;
    std::vector<unsigned int> nodes;

    matrix = 0.;
    for (const auto &cell :
         discretization.mesh().triangulation.active_cell_iterators())
      if (cell->subdomain_id() == rank)
        {
          nodes.clear();
          for (const unsigned int v : cell->vertex_indices())
            nodes.push_back(cell->vertex_index(v));
          add(discretization,
              cell_matrices.stiffness(cell, materials.at(cell->material_id())),
              nodes,
              buffer,
              dofs,
              matrix);
        }
    matrix.compress(dealii::VectorOperation::add);
  }

  template <int dim>
  void
  assemble_springs(const Discretization<dim> &discretization,
                   const SpringNetwork &network,
                   typename Discretization<dim>::Matrix &matrix)
  {
    dealii::FullMatrix<double> buffer;
    std::vector<dealii::types::global_dof_index> dofs;

    matrix = 0.;
    for (unsigned int s = 0; s < network.stiffness.size(); ++s)
      if (discretization.locally_owned().is_element(
            discretization.dof(network.i[s], 0)))
        {
          const Vector<dim> d =
            network.nodes.col(network.j[s]) - network.nodes.col(network.i[s]);
          const Vector<2 *dim> b = length_gradient<dim>(d);
          add(discretization,
              network.stiffness[s] * b * b.transpose(),
              {network.i[s], network.j[s]},
              buffer,
              dofs,
              matrix);
        }
    matrix.compress(dealii::VectorOperation::add);
  }

  template void
  assemble_finite_elements<2>(const Discretization<2> &,
                              const Element<2> &,
                              const MaterialTable &,
                              Discretization<2>::Matrix &);
  template void
  assemble_finite_elements<3>(const Discretization<3> &,
                              const Element<3> &,
                              const MaterialTable &,
                              Discretization<3>::Matrix &);
  template void
  assemble_springs<2>(const Discretization<2> &,
                      const SpringNetwork &,
                      Discretization<2>::Matrix &);
  template void
  assemble_springs<3>(const Discretization<3> &,
                      const SpringNetwork &,
                      Discretization<3>::Matrix &);
} // namespace springfit
