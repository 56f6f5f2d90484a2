#include <springfit/response/finite_element_body.h>
#include <springfit/response/network_body.h>
#include <springfit/response/sum_of_bodies.h>
#include <springfit/springs/tangent_matrix.h>
#include <springfit/studies/mixed_body.h>

#include <algorithm>
#include <utility>

namespace springfit
{
  template <int dim, int spacedim>
  MixedBody<dim, spacedim>::MixedBody(
    const CalibratedScene<dim, spacedim> &calibrated,
    const MaterialLaw law,
    const Kinematics kinematics)
    : calibrated_(calibrated)
    , law_(law)
    , kinematics_(kinematics)
    , cells_(find_distinct_cells(*calibrated.mesh))
    , iterators_(cells_by_index(*calibrated.mesh))
    , energy_(calibrated.element)
  {
    for (const auto &network : calibrated.networks)
      {
        Assert(network.cells.size() == cells_.distinct.size(),
               dealii::ExcInternalError());
        models_.emplace_back();
        for (const auto &fit : network.cells)
          models_.back().push_back(fit.result);
      }
  }

  template <int dim, int spacedim>
  unsigned int
  MixedBody<dim, spacedim>::n_models() const
  {
    return models_.size() + 1;
  }

  template <int dim, int spacedim>
  std::string
  MixedBody<dim, spacedim>::name(const unsigned int model) const
  {
    return model < models_.size() ? calibrated_.networks[model].name : "fem";
  }

  template <int dim, int spacedim>
  SpringNetwork
  MixedBody<dim, spacedim>::network(
    const std::vector<unsigned int> &models) const
  {
    return assemble_network(
      *calibrated_.mesh,
      cells_,
      [&](const unsigned int c) {
        return models[c] < models_.size()
                 ? &models_[models[c]][cells_.copies[c].distinct]
                 : nullptr;
      },
      calibrated_.element,
      calibrated_.materials);
  }

  template <int dim, int spacedim>
  std::unique_ptr<const BodyOfMembers>
  MixedBody<dim, spacedim>::body(const std::vector<unsigned int> &models) const
  {
    std::vector<std::unique_ptr<const BodyOfMembers>> parts;
    parts.push_back(std::make_unique<NetworkBody>(network(models)));
    std::vector<CellIterator<dim, spacedim>> elements;
    for (unsigned int c = 0; c < models.size(); ++c)
      if (models[c] == models_.size())
        elements.push_back(iterators_[c]);
    if (!elements.empty())
      parts.push_back(std::make_unique<FiniteElementBody<dim, spacedim>>(
        *calibrated_.mesh,
        std::move(elements),
        calibrated_.element,
        calibrated_.materials,
        law_));
    if (parts.size() == 1)
      return std::move(parts.front());
    return std::make_unique<SumOfBodies>(std::move(parts));
  }

  template <int dim, int spacedim>
  std::unique_ptr<const BodyOfMembers>
  MixedBody<dim, spacedim>::exact_body() const
  {
    return std::make_unique<FiniteElementBody<dim, spacedim>>(
      *calibrated_.mesh, calibrated_.element, calibrated_.materials, law_);
  }

  template <int dim, int spacedim>
  std::vector<Eigen::MatrixXd>
  MixedBody<dim, spacedim>::missing_forces(
    const unsigned int cell,
    const Eigen::MatrixXd &displacement) const
  {
    const auto &iterator = iterators_[cell];
    const auto &nodes    = calibrated_.mesh->nodes.of(iterator);
    const Eigen::MatrixXd exact =
      -energy_
         .evaluate(law_,
                   iterator,
                   calibrated_.materials.at(iterator->material_id()),
                   displacement(Eigen::all, nodes))
         ->gradient.reshaped(spacedim, nodes.size());

    // The copy of a cell has its nodes in an order of its own.
    const auto &copy = cells_.copies[cell];
    Eigen::MatrixXd rest(spacedim, copy.nodes.size());
    std::vector<unsigned int> places;
    for (std::size_t a = 0; a < copy.nodes.size(); ++a)
      {
        for (int d = 0; d < spacedim; ++d)
          rest(d, a) = calibrated_.mesh->nodes.places[copy.nodes[a]][d];
        places.push_back(std::find(nodes.begin(), nodes.end(), copy.nodes[a]) -
                         nodes.begin());
      }
    const Eigen::MatrixXd u = displacement(Eigen::all, copy.nodes);

    std::vector<Eigen::MatrixXd> missing(n_models(), exact);
    missing.back().setZero();
    for (std::size_t k = 0; k < models_.size(); ++k)
      {
        const auto families =
          families_of_cell<dim, spacedim>(models_[k][copy.distinct],
                                          copy,
                                          rest);
        Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(u.rows(), u.cols());
        if (kinematics_ == Kinematics::nonlinear)
          add_forces(families, rest + u, forces);
        else
          add_tangent_product(families, rest, -u, forces);
        missing[k](Eigen::all, places) -= forces;
      }
    return missing;
  }

  template class MixedBody<2, 2>;
  template class MixedBody<2, 3>;
  template class MixedBody<3, 3>;
} // namespace springfit
