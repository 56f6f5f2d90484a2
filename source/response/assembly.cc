#include <springfit/response/assembly.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace springfit
{
  namespace
  {
    /** A dense term on the unknowns, in deal.II's own containers. */
    template <int dim>
    class LocalContribution
    {
    public:
      explicit LocalContribution(const Discretization<dim> &discretization)
        : discretization_(discretization)
      {}

      void
      set_nodes(const std::vector<unsigned int> &nodes)
      {
        dofs_.resize(dim * nodes.size());
        for (unsigned int a = 0; a < dofs_.size(); ++a)
          dofs_[a] = discretization_.dof(nodes[a / dim], a % dim);
      }

      void
      add(const Eigen::MatrixXd &dense,
          typename Discretization<dim>::Matrix &matrix)
      {
        const unsigned int n = dense.rows();
        matrix_.reinit(n, n);
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            matrix_(a, b) = dense(a, b);
        discretization_.constraints().distribute_local_to_global(matrix_,
                                                                 dofs_,
                                                                 matrix);
      }

      void
      add(const Eigen::VectorXd &dense,
          typename Discretization<dim>::Vector &vector)
      {
        vector_.reinit(dense.size());
        for (unsigned int a = 0; a < dense.size(); ++a)
          vector_(a) = dense[a];
        discretization_.constraints().distribute_local_to_global(vector_,
                                                                 dofs_,
                                                                 vector);
      }

    private:
      const Discretization<dim> &discretization_;
      std::vector<dealii::types::global_dof_index> dofs_;
      dealii::FullMatrix<double> matrix_;
      dealii::Vector<double> vector_;
    };

    template <int dim>
    bool
    is_mine(const Discretization<dim> &discretization,
            const ElasticBody &body,
            const unsigned int term)
    {
      return discretization.locally_owned().is_element(
        discretization.dof(body.first_node(term), 0));
    }

    /** m: how far the last digit of the nodes' places reaches. */
    template <int dim>
    double
    rounding_of_places(const Discretization<dim> &discretization,
                       const Eigen::MatrixXd &displacement)
    {
      double farthest = displacement.cwiseAbs().maxCoeff();
      for (const auto &vertex :
           discretization.mesh().triangulation.get_vertices())
        for (int d = 0; d < dim; ++d)
          farthest = std::max(farthest, std::abs(vertex[d]));
      return std::numeric_limits<double>::epsilon() * farthest;
    }

    Eigen::MatrixXd
    positive_part(const Eigen::MatrixXd &symmetric)
    {
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
      return solver.eigenvectors() *
             solver.eigenvalues().cwiseMax(0.).asDiagonal() *
             solver.eigenvectors().transpose();
    }
  } // namespace

  template <int dim>
  std::optional<AssembledState<dim>>
  assemble(const Discretization<dim> &discretization,
           const ElasticBody &body,
           const Eigen::MatrixXd &displacement,
           typename Discretization<dim>::Matrix &tangent)
  {
    AssembledState<dim> state;
    state.energy = 0.;
    state.forces.reinit(discretization.locally_owned(),
                        discretization.communicator());
    tangent               = 0.;
    bool finite           = true;
    double square_hessian = 0.; // of all terms
    LocalContribution<dim> contribution(discretization);
    for (unsigned int t = 0; t < body.n_terms() && finite; ++t)
      if (is_mine(discretization, body, t))
        {
          const auto term = body.evaluate(t, displacement);
          finite          = term && std::isfinite(term->energy) &&
                   term->gradient.allFinite() && term->hessian.allFinite();
          if (!finite)
            break;
          state.energy += term->energy;
          square_hessian += term->hessian.squaredNorm();
          contribution.set_nodes(term->nodes);
          contribution.add(term->gradient, state.forces);
          contribution.add(term->hessian, tangent);
        }
    tangent.compress(dealii::VectorOperation::add);
    state.forces.compress(dealii::VectorOperation::add);
    state.energy =
      dealii::Utilities::MPI::sum(state.energy, discretization.communicator());
    state.rounding =
      rounding_of_places(discretization, displacement) *
      std::sqrt(dealii::Utilities::MPI::sum(square_hessian,
                                            discretization.communicator()));
    const int all_finite =
      dealii::Utilities::MPI::min(finite ? 1 : 0,
                                  discretization.communicator());
    if (all_finite == 0)
      return {};
    return state;
  }

  template <int dim>
  void
  assemble_convex_tangent(const Discretization<dim> &discretization,
                          const ElasticBody &body,
                          const Eigen::MatrixXd &displacement,
                          typename Discretization<dim>::Matrix &tangent)
  {
    tangent = 0.;
    LocalContribution<dim> contribution(discretization);
    for (unsigned int t = 0; t < body.n_terms(); ++t)
      if (is_mine(discretization, body, t))
        {
          const auto term = body.evaluate(t, displacement);
          Assert(term, dealii::ExcMessage("The state has no finite energy."));
          contribution.set_nodes(term->nodes);
          contribution.add(positive_part(term->hessian), tangent);
        }
    tangent.compress(dealii::VectorOperation::add);
  }

  template struct AssembledState<2>;
  template struct AssembledState<3>;
  template std::optional<AssembledState<2>>
  assemble<2>(const Discretization<2> &,
              const ElasticBody &,
              const Eigen::MatrixXd &,
              Discretization<2>::Matrix &);
  template std::optional<AssembledState<3>>
  assemble<3>(const Discretization<3> &,
              const ElasticBody &,
              const Eigen::MatrixXd &,
              Discretization<3>::Matrix &);
  template void
  assemble_convex_tangent<2>(const Discretization<2> &,
                             const ElasticBody &,
                             const Eigen::MatrixXd &,
                             Discretization<2>::Matrix &);
  template void
  assemble_convex_tangent<3>(const Discretization<3> &,
                             const ElasticBody &,
                             const Eigen::MatrixXd &,
                             Discretization<3>::Matrix &);
} // namespace springfit
