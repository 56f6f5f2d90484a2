#include <springfit/core/error.h>
#include <springfit/response/boundary_parts.h>
#include <springfit/response/loaded_surface.h>
#include <springfit/response/own_forces.h>
#include <springfit/response/statements.h>

namespace springfit
{
  namespace
  {
    template <int spacedim>
    std::vector<Expression<spacedim>>
    vector_of(const std::vector<std::string> &values, const std::string &entry)
    {
      const std::string advice =
        "Give " + std::to_string(spacedim) + " expressions of x, y, " +
        (spacedim == 2 ? "t" : "z, t") + " between commas, such as " +
        (spacedim == 2 ? "0, -2 * t." : "0, 0, -2 * t.");
      if (values.size() != spacedim)
        throw EntryError(entry,
                         "there are " + std::to_string(values.size()) +
                           " components of a vector in " +
                           std::to_string(spacedim) + " dimensions.",
                         advice);
      std::vector<Expression<spacedim>> components;
      for (const auto &value : values)
        components.push_back(
          Expression<spacedim>::of_place_and_time(value, entry, advice));
      return components;
    }

    template <int dim, int spacedim>
    LoadedSurface<dim, spacedim>
    surface_at(const std::string &place,
               const Mesh<dim, spacedim> &mesh,
               const Element<dim, spacedim> &element,
               const std::string &entry)
    {
      const std::string condition = condition_of(place);
      auto faces = condition.empty() ? faces_of_boundaries(mesh, place, entry)
                                     : faces_where(mesh, condition, entry);
      if (faces.empty())
        throw EntryError(entry,
                         "there is no boundary face at '" + place + "'.",
                         "Lengths are in m, and all vertices of a face must "
                         "meet a condition; widen it.");
      return LoadedSurface<dim, spacedim>(mesh, std::move(faces), element);
    }
  } // namespace

  template <int spacedim>
  std::vector<ForceStatement<spacedim>>
  parse_forces(const std::string &text, const std::string &entry)
  {
    std::vector<ForceStatement<spacedim>> forces;
    for (const auto &statement : parse_statements(text, entry))
      forces.push_back({statement.load_case,
                        statement.place,
                        vector_of<spacedim>(statement.values, entry)});
    return forces;
  }

  template <int spacedim>
  std::vector<ForceStatement<spacedim>>
  parse_field(const std::string &text, const std::string &entry)
  {
    const auto values = split_outside(text, ',');
    if (values.empty())
      return {};
    return {{"", "", vector_of<spacedim>(values, entry)}};
  }

  template <int dim, int spacedim>
  PlacedForce<spacedim>
  placed_force(const ForceStatement<spacedim> &statement,
               const Mesh<dim, spacedim> &mesh,
               const Element<dim, spacedim> &element,
               const std::string &entry)
  {
    const auto surface = surface_at(statement.place, mesh, element, entry);
    return {surface.shares() / surface.area(), statement.components};
  }

  template <int dim, int spacedim>
  PlacedForce<spacedim>
  placed_traction(const ForceStatement<spacedim> &statement,
                  const Mesh<dim, spacedim> &mesh,
                  const Element<dim, spacedim> &element,
                  const double thickness,
                  const std::string &entry)
  {
    const auto surface = surface_at(statement.place, mesh, element, entry);
    return {thickness * surface.shares(), statement.components};
  }

  template <int spacedim>
  PlacedForce<spacedim>
  placed_acceleration(const ForceStatement<spacedim> &statement,
                      const Eigen::VectorXd &masses)
  {
    return {masses, statement.components};
  }

  template <int dim, int spacedim>
  Eigen::MatrixXd
  forces_at(const std::vector<PlacedForce<spacedim>> &forces,
            const Mesh<dim, spacedim> &mesh,
            const double time)
  {
    const auto &places     = mesh.nodes.places;
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(spacedim, places.size());
    for (const auto &[weights, components] : forces)
      for (int d = 0; d < spacedim; ++d)
        if (components[d].depends_on_place())
          {
            for (unsigned int v = 0; v < places.size(); ++v)
              if (weights[v] != 0.)
                result(d, v) +=
                  weights[v] * components[d].value(places[v], time);
          }
        else
          result.row(d) +=
            components[d].value(places[0], time) * weights.transpose();
    return result;
  }

  template std::vector<ForceStatement<2>>
  parse_forces(const std::string &, const std::string &);
  template std::vector<ForceStatement<3>>
  parse_forces(const std::string &, const std::string &);
  template std::vector<ForceStatement<2>>
  parse_field(const std::string &, const std::string &);
  template std::vector<ForceStatement<3>>
  parse_field(const std::string &, const std::string &);
  template PlacedForce<2>
  placed_force(const ForceStatement<2> &,
               const Mesh<2> &,
               const Element<2> &,
               const std::string &);
  template PlacedForce<3>
  placed_force(const ForceStatement<3> &,
               const Mesh<2, 3> &,
               const Element<2, 3> &,
               const std::string &);
  template PlacedForce<3>
  placed_force(const ForceStatement<3> &,
               const Mesh<3> &,
               const Element<3> &,
               const std::string &);
  template PlacedForce<2>
  placed_traction(const ForceStatement<2> &,
                  const Mesh<2> &,
                  const Element<2> &,
                  double,
                  const std::string &);
  template PlacedForce<3>
  placed_traction(const ForceStatement<3> &,
                  const Mesh<2, 3> &,
                  const Element<2, 3> &,
                  double,
                  const std::string &);
  template PlacedForce<3>
  placed_traction(const ForceStatement<3> &,
                  const Mesh<3> &,
                  const Element<3> &,
                  double,
                  const std::string &);
  template PlacedForce<2>
  placed_acceleration(const ForceStatement<2> &, const Eigen::VectorXd &);
  template PlacedForce<3>
  placed_acceleration(const ForceStatement<3> &, const Eigen::VectorXd &);
  template Eigen::MatrixXd
  forces_at(const std::vector<PlacedForce<2>> &, const Mesh<2> &, double);
  template Eigen::MatrixXd
  forces_at(const std::vector<PlacedForce<3>> &, const Mesh<2, 3> &, double);
  template Eigen::MatrixXd
  forces_at(const std::vector<PlacedForce<3>> &, const Mesh<3> &, double);
} // namespace springfit
