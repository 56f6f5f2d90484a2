#include <springfit/comparison/errors.h>
#include <springfit/core/error.h>
#include <springfit/response/distributed_body.h>
#include <springfit/studies/adaptation.h>
#include <springfit/studies/responses.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace springfit
{
  namespace
  {
    /** What is at the nodes of a cell to that at all of them. */
    void
    add(const Eigen::MatrixXd &of_cell,
        const std::vector<unsigned int> &nodes,
        Eigen::MatrixXd &sum)
    {
      for (std::size_t a = 0; a < nodes.size(); ++a)
        sum.col(nodes[a]) += of_cell.col(a);
    }
  } // namespace

  template <int dim, int spacedim>
  Adaptation<dim, spacedim>::Adaptation(
    const Scene<spacedim> &scene,
    const CalibratedScene<dim, spacedim> &calibrated,
    const Loading &loading,
    const AdaptSettings &settings,
    MPI_Comm communicator)
    : scene_(scene)
    , calibrated_(calibrated)
    , loading_(loading)
    , settings_(settings)
    , law_(scene.statics.material_law())
    , kinematics_(law_ == MaterialLaw::linear ? Kinematics::linear
                                              : Kinematics::nonlinear)
    , discretization_(*calibrated.mesh, loading.held, communicator)
    , mixed_(calibrated, law_, kinematics_)
    , exact_(mixed_.exact_body())
  {
    if (settings_.quantity)
      quantity_ = on_mesh(*settings_.quantity,
                          *calibrated.mesh,
                          calibrated.element,
                          loading,
                          "Adapt/Quantity");
  }

  template <int dim, int spacedim>
  const MixedBody<dim, spacedim> &
  Adaptation<dim, spacedim>::mixed() const
  {
    return mixed_;
  }

  template <int dim, int spacedim>
  Kinematics
  Adaptation<dim, spacedim>::kinematics() const
  {
    return kinematics_;
  }

  template <int dim, int spacedim>
  unsigned int
  Adaptation<dim, spacedim>::n_models() const
  {
    return mixed_.n_models() - (settings_.has_finite_elements ? 0 : 1);
  }

  template <int dim, int spacedim>
  std::vector<Equilibrium>
  Adaptation<dim, spacedim>::respond(
    std::unique_ptr<const BodyOfMembers> body) const
  {
    const auto model = scene_.statics.body(discretization_,
                                           *calibrated_.mesh,
                                           calibrated_.element,
                                           std::move(body),
                                           {"the mixed network",
                                            "Load less, or leave out the "
                                            "first of the fits."},
                                           kinematics_);
    std::vector<Equilibrium> found;
    for (const auto &load_case : loading_.cases)
      {
        found.push_back(model->respond(load_case.load));
        if (!is_complete(found.back()))
          throw RunError("Load case " + load_case.name + ": " +
                           found.back().failure,
                         "Load less, or leave out the first of the fits.");
        // It throws where nothing moves.
        scale_of(load_case, loading_, found.back().displacement);
      }
    return found;
  }

  template <int dim, int spacedim>
  double
  Adaptation<dim, spacedim>::largest_quantity(
    const std::vector<Equilibrium> &found) const
  {
    if (!quantity_)
      return 1.;
    double largest = 0., scale = 0.;
    for (const auto &of_case : found)
      {
        largest = std::max(largest, std::abs(value_of(*quantity_, of_case)));
        scale   = std::max(scale,
                         (quantity_->is_reaction ? of_case.reactions
                                                   : of_case.displacement)
                           .cwiseAbs()
                           .maxCoeff());
      }
    if (!(largest > 1e-9 * scale))
      throw EntryError("Adapt/Quantity",
                       "no load moves it.",
                       "Name another component, or a place that moves.");
    return largest;
  }

  template <int dim, int spacedim>
  double
  Adaptation<dim, spacedim>::error(const Equilibrium &exact,
                                   const Equilibrium &found,
                                   const double largest) const
  {
    if (quantity_)
      return 100. *
             (value_of(*quantity_, exact) - value_of(*quantity_, found)) /
             largest;
    return error_norms(exact.displacement, found.displacement).e_rms_percent;
  }

  template <int dim, int spacedim>
  JudgedCase
  Adaptation<dim, spacedim>::judge(const Equilibrium &found,
                                   const std::vector<unsigned int> &models,
                                   const double largest) const
  {
    const Eigen::MatrixXd &u   = found.displacement;
    const unsigned int n_cells = models.size();
    if (!std::isfinite(exact_->energy(u)))
      throw RunError("The finite elements have no energy in the state of "
                     "the mixed network.",
                     "Load less, or set 'Material law = stable neo-hookean' "
                     "in section Response.");
    std::vector<std::vector<Eigen::MatrixXd>> missing(n_cells);
    Eigen::MatrixXd sum = 0. * u;
    for (unsigned int c = 0; c < n_cells; ++c)
      {
        missing[c] = mixed_.missing_forces(c, u);
        add(missing[c][models[c]], calibrated_.mesh->nodes.of_cells[c], sum);
      }

    typename Discretization<spacedim>::Matrix tangent;
    discretization_.initialize(tangent);
    DistributedBody<spacedim> distributed(discretization_, *exact_);
    distributed.tangent(u, tangent);
    const auto solver = scene_.statics.linear_solvers(discretization_)(tangent);
    const auto solve  = [&](const Eigen::MatrixXd &forces) {
      return discretization_.to_nodal(
        solver->solve(discretization_.to_vector(forces)));
    };
    const Eigen::MatrixXd change = solve(sum);
    const Goal goal              = this->goal(found, change, largest);
    Eigen::MatrixXd adjoint      = goal.weights;
    if (quantity_ && quantity_->is_reaction)
      {
        adjoint.setZero();
        exact_->add_tangent_product(u, goal.weights, adjoint);
      }
    adjoint = solve(adjoint) - goal.of_forces;

    JudgedCase judged{found, Eigen::MatrixXd(n_cells, n_models()), 0.};
    for (const auto &cell :
         calibrated_.mesh->triangulation.active_cell_iterators())
      {
        const unsigned int c = cell->active_cell_index();
        const auto &nodes    = calibrated_.mesh->nodes.of(cell);
        for (unsigned int k = 0; k < n_models(); ++k)
          {
            double product = 0.;
            for (std::size_t a = 0; a < nodes.size(); ++a)
              product += adjoint.col(nodes[a]).dot(missing[c][k].col(a));
            judged.contributions(c, k) = product;
          }
        judged.estimate += judged.contributions(c, models[c]);
      }
    if (!std::isfinite(judged.estimate))
      throw RunError("The error of the mixed network could not be "
                     "estimated: it is not finite.",
                     "Load less, or leave out the first of the fits.");
    return judged;
  }

  template <int dim, int spacedim>
  typename Adaptation<dim, spacedim>::Goal
  Adaptation<dim, spacedim>::goal(const Equilibrium &found,
                                  const Eigen::MatrixXd &change,
                                  const double largest_of_quantity) const
  {
    const Eigen::MatrixXd &u = found.displacement;
    Goal goal{0. * u, 0. * u};
    if (quantity_)
      {
        goal.weights = 100. / largest_of_quantity * quantity_->weights;
        if (quantity_->is_reaction)
          goal.of_forces = goal.weights;
        return goal;
      }
    const double largest = largest_displacement(u + change);
    const double error = change.norm() / std::sqrt(double(u.cols())) / largest;
    if (error > 0.)
      goal.weights = 100. / (u.cols() * largest * largest * error) * change;
    return goal;
  }

  template class Adaptation<2, 2>;
  template class Adaptation<2, 3>;
  template class Adaptation<3, 3>;
} // namespace springfit
