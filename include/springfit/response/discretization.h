#ifndef springfit_response_discretization_h
#define springfit_response_discretization_h

#include <springfit/mesh/mesh.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/point.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Eigen/Core>

#include <mpi.h>

#include <vector>

namespace springfit
{
  /**
   * The unknowns that both models share: dim displacements at every node of
   * a mesh in space of dimension dim, held where there are supports, divided
   * among the ranks.
   */
  template <int dim>
  class Discretization
  {
  public:
    using Vector = dealii::TrilinosWrappers::MPI::Vector;
    using Matrix = dealii::TrilinosWrappers::SparseMatrix;

    /**
     * @p held has a flag per unknown, dim * v + d for component d of node v.
     */
    template <int dim_of_cells>
    Discretization(const Mesh<dim_of_cells, dim> &mesh,
                   const std::vector<bool> &held,
                   MPI_Comm communicator);

    /** The places of the nodes at rest. */
    const std::vector<dealii::Point<dim>> &
    nodes() const;

    /** The degree of freedom of component @p d of node @p v. */
    dealii::types::global_dof_index
    dof(unsigned int v, unsigned int d) const;

    unsigned int
    n_nodes() const;

    /** A flag per unknown, dim * v + d. */
    const std::vector<bool> &
    held() const;

    const dealii::AffineConstraints<double> &
    constraints() const;

    const dealii::IndexSet &
    locally_owned() const;

    /** A flag per node: those whose unknowns are this rank's. */
    std::vector<bool>
    owned_nodes() const;

    MPI_Comm
    communicator() const;

    /** A matrix that couples the nodes of each cell, zero. */
    void
    initialize(Matrix &matrix) const;

    /** dim x n_nodes on every rank to a vector; 0 where it is held. */
    Vector
    to_vector(const Eigen::MatrixXd &nodal) const;

    /** And back, on every rank. */
    Eigen::MatrixXd
    to_nodal(const Vector &vector) const;

  private:
    const std::vector<dealii::Point<dim>> nodes_;
    const std::vector<bool> held_;
    const MPI_Comm communicator_;
    std::vector<dealii::types::global_dof_index> dofs_; // dim * v + d
    dealii::IndexSet locally_owned_;
    dealii::AffineConstraints<double> constraints_;
    dealii::DynamicSparsityPattern pattern_;
  };
} // namespace springfit

#endif
