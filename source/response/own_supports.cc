#include <springfit/core/error.h>
#include <springfit/response/boundary_parts.h>
#include <springfit/response/own_supports.h>
#include <springfit/response/statements.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace springfit
{
  namespace
  {
    constexpr const char *components_of_space = "xyz";

    template <int spacedim>
    std::string
    names()
    {
      return spacedim == 2 ? "x or y" : "x, y or z";
    }

    /** "z" or "z = -0.01 * t" */
    template <int spacedim>
    void
    hold(const std::string &value,
         const std::string &entry,
         SupportStatement<spacedim> &statement)
    {
      const std::string advice =
        "Write " + names<spacedim>() +
        ", which holds the component, or with a displacement in m: \"" +
        components_of_space[spacedim - 1] + " = -0.01 * t\".";
      const auto equals        = value.find('=');
      const std::string before = value.substr(0, equals);
      const std::string name =
        before.substr(0, before.find_last_not_of(" \t") + 1);
      const std::string known(components_of_space, spacedim);
      const auto component =
        name.size() == 1 ? known.find(name) : std::string::npos;
      if (component == std::string::npos)
        throw EntryError(entry, "'" + value + "' names no component.", advice);
      if (statement.components[component])
        throw EntryError(entry,
                         "'" + name + "' is held twice at '" + statement.place +
                           "'.",
                         "Give each component once.");
      const std::string displacement =
        equals == std::string::npos ? "0" : value.substr(equals + 1);
      statement.components[component].emplace(
        Expression<spacedim>::of_place_and_time(displacement, entry, advice));
    }
  } // namespace

  template <int spacedim>
  std::vector<SupportStatement<spacedim>>
  parse_supports(const std::string &text, const std::string &entry)
  {
    std::vector<SupportStatement<spacedim>> supports;
    for (const auto &statement : parse_statements(text, entry))
      {
        SupportStatement<spacedim> support{statement.load_case,
                                           statement.place,
                                           {}};
        for (const auto &value : statement.values)
          hold(value, entry, support);
        if (statement.values.empty())
          for (int d = 0; d < spacedim; ++d)
            hold(std::string(1, components_of_space[d]), entry, support);
        supports.push_back(support);
      }
    return supports;
  }

  template <int dim, int spacedim>
  std::vector<bool>
  nodes_of(const SupportStatement<spacedim> &statement,
           const Mesh<dim, spacedim> &mesh,
           const std::string &entry)
  {
    const std::string condition = condition_of(statement.place);
    const auto nodes =
      condition.empty()
        ? nodes_of_faces(mesh,
                         faces_of_boundaries(mesh, statement.place, entry))
        : nodes_where(mesh, condition, entry);
    if (std::find(nodes.begin(), nodes.end(), true) == nodes.end())
      throw EntryError(entry,
                       "there is no node at '" + statement.place + "'.",
                       "Lengths are in m; widen the condition.");
    return nodes;
  }

  template <int dim, int spacedim>
  Eigen::MatrixXd
  displacement_at(const std::vector<PlacedSupport<spacedim>> &supports,
                  const Mesh<dim, spacedim> &mesh,
                  const double time,
                  const std::string &entry)
  {
    const auto &places      = mesh.nodes.places;
    constexpr double unsaid = std::numeric_limits<double>::max();
    Eigen::MatrixXd displacement =
      Eigen::MatrixXd::Constant(spacedim, places.size(), unsaid);
    for (const auto &[nodes, statement] : supports)
      for (int d = 0; d < spacedim; ++d)
        if (const auto &expression = statement.components[d])
          {
            double value = expression->value(places[0], time);
            for (unsigned int v = 0; v < places.size(); ++v)
              if (nodes[v])
                {
                  if (expression->depends_on_place())
                    value = expression->value(places[v], time);
                  double &entry_of_node = displacement(d, v);
                  if (entry_of_node != unsaid &&
                      std::abs(entry_of_node - value) > 1e-12 * std::abs(value))
                    {
                      std::ostringstream what;
                      what << components_of_space[d] << " of the node at ("
                           << places[v] << ") m is moved to " << entry_of_node
                           << " m and to " << value << " m at the time " << time
                           << " s.";
                      throw EntryError(entry,
                                       what.str(),
                                       "Let places that share nodes move "
                                       "together, or leave the component out "
                                       "at one of them.");
                    }
                  entry_of_node = value;
                }
          }
    return (displacement.array() == unsaid).select(0., displacement);
  }

  template std::vector<SupportStatement<2>>
  parse_supports(const std::string &, const std::string &);
  template std::vector<SupportStatement<3>>
  parse_supports(const std::string &, const std::string &);
  template std::vector<bool>
  nodes_of(const SupportStatement<2> &, const Mesh<2> &, const std::string &);
  template std::vector<bool>
  nodes_of(const SupportStatement<3> &,
           const Mesh<2, 3> &,
           const std::string &);
  template std::vector<bool>
  nodes_of(const SupportStatement<3> &, const Mesh<3> &, const std::string &);
  template Eigen::MatrixXd
  displacement_at(const std::vector<PlacedSupport<2>> &,
                  const Mesh<2> &,
                  double,
                  const std::string &);
  template Eigen::MatrixXd
  displacement_at(const std::vector<PlacedSupport<3>> &,
                  const Mesh<2, 3> &,
                  double,
                  const std::string &);
  template Eigen::MatrixXd
  displacement_at(const std::vector<PlacedSupport<3>> &,
                  const Mesh<3> &,
                  double,
                  const std::string &);
} // namespace springfit
