#include <springfit/response/distributed_body.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace springfit
{
  namespace
  {
    NodePattern
    pattern_of(const BodyOfMembers &body, const unsigned int n_nodes)
    {
      NodePattern pattern(n_nodes);
      body.add_to_pattern(pattern);
      return pattern;
    }

    /** m: how far the last digit of the nodes' places reaches. */
    template <int dim>
    double
    rounding_of_places(const Discretization<dim> &discretization,
                       const Eigen::MatrixXd &displacement)
    {
      double farthest = displacement.cwiseAbs().maxCoeff();
      for (const auto &node : discretization.nodes())
        for (int d = 0; d < dim; ++d)
          farthest = std::max(farthest, std::abs(node[d]));
      return std::numeric_limits<double>::epsilon() * farthest;
    }
  } // namespace

  template <int dim>
  DistributedBody<dim>::DistributedBody(
    const Discretization<dim> &discretization,
    const BodyOfMembers &body)
    : discretization_(discretization)
    , share_(body.share(discretization.owned_nodes()))
    , of_share_(dim, pattern_of(*share_, discretization.n_nodes()))
  {}

  template <int dim>
  double
  DistributedBody<dim>::energy(const Eigen::MatrixXd &displacement) const
  {
    return dealii::Utilities::MPI::sum(share_->energy(displacement),
                                       discretization_.communicator());
  }

  template <int dim>
  typename DistributedBody<dim>::Vector
  DistributedBody<dim>::forces(const Eigen::MatrixXd &displacement) const
  {
    Eigen::MatrixXd nodal =
      Eigen::MatrixXd::Zero(displacement.rows(), displacement.cols());
    share_->add_forces(displacement, nodal);
    const dealii::ArrayView<double> entries(nodal.data(), nodal.size());
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(entries),
                                discretization_.communicator(),
                                entries);
    return discretization_.to_vector(nodal);
  }

  template <int dim>
  void
  DistributedBody<dim>::tangent(const Eigen::MatrixXd &displacement,
                                Matrix &tangent)
  {
    of_share_.set_zero();
    share_->add_tangent(displacement, of_share_);
    distribute(tangent);
  }

  template <int dim>
  void
  DistributedBody<dim>::convex_tangent(const Eigen::MatrixXd &displacement,
                                       Matrix &tangent)
  {
    of_share_.set_zero();
    share_->add_convex_tangent(displacement, of_share_);
    distribute(tangent);
  }

  template <int dim>
  void
  DistributedBody<dim>::distribute(Matrix &matrix) const
  {
    matrix            = 0.;
    const auto &local = of_share_.matrix();
    const auto &held  = discretization_.held();
    const auto dof    = [&](const Eigen::Index row) {
      return discretization_.dof(row / dim, row % dim);
    };
    std::vector<dealii::types::global_dof_index> columns;
    std::vector<double> values;
    // The matrix is symmetric: its columns are its rows.
    for (Eigen::Index row = 0; row < local.cols(); ++row)
      {
        columns.clear();
        values.clear();
        for (Eigen::SparseMatrix<double>::InnerIterator it(local, row); it;
             ++it)
          if (held[row])
            {
              if (it.row() == row)
                {
                  columns.push_back(dof(row));
                  values.push_back(std::abs(it.value()));
                }
            }
          else if (!held[it.row()])
            {
              columns.push_back(dof(it.row()));
              values.push_back(it.value());
            }
        if (!columns.empty())
          matrix.add(dof(row), columns.size(), columns.data(), values.data());
      }
    matrix.compress(dealii::VectorOperation::add);

    // A flat membrane has nothing across itself, where it may be held.
    const double scale = matrix.linfty_norm();
    for (Eigen::Index row = 0; row < local.cols(); ++row)
      if (held[row] && discretization_.locally_owned().is_element(dof(row)) &&
          matrix.diag_element(dof(row)) == 0.)
        matrix.set(dof(row), dof(row), scale);
    matrix.compress(dealii::VectorOperation::insert);
  }

  template <int dim>
  double
  DistributedBody<dim>::rounding(const Eigen::MatrixXd &displacement,
                                 const Matrix &tangent) const
  {
    return rounding_of_places(discretization_, displacement) *
           tangent.frobenius_norm();
  }

  template class DistributedBody<2>;
  template class DistributedBody<3>;
} // namespace springfit
