#include <springfit/core/error.h>
#include <springfit/reference/nodal_masses.h>
#include <springfit/response/own_loads.h>

#include <algorithm>

namespace springfit
{
  namespace
  {
    const std::string supports_entry  = "Loads/Supports";
    const std::string forces_entry    = "Loads/Forces";
    const std::string tractions_entry = "Loads/Tractions";
    const std::string gravity_entry   = "Loads/Gravity";

    void
    check_name(const std::string &name, const std::string &entry)
    {
      const auto canned = words_of(load_words());
      if (name == "fem" || name == "none" ||
          std::find(canned.begin(), canned.end(), name) != canned.end())
        throw EntryError(entry,
                         "a load case cannot be called '" + name + "'.",
                         "Call it otherwise: the name is taken.");
    }

    /** Whether a statement has a part in a load case. */
    template <typename Statement>
    bool
    belongs(const Statement &statement, const std::string &load_case)
    {
      return statement.load_case.empty() || statement.load_case == load_case;
    }

    template <int dim>
    bool
    moves(const SupportStatement<dim> &statement)
    {
      const dealii::Point<dim> origin;
      return std::any_of(statement.components.begin(),
                         statement.components.end(),
                         [&](const auto &component) {
                           return component &&
                                  (component->depends_on_time() ||
                                   component->depends_on_place() ||
                                   component->value(origin, 0.) != 0.);
                         });
    }
  } // namespace

  template <int dim>
  OwnLoads<dim>::OwnLoads(const OwnLoadTexts &texts)
    : supports_(parse_supports<dim>(texts.supports, supports_entry))
    , forces_(parse_forces<dim>(texts.forces, forces_entry))
    , tractions_(parse_forces<dim>(texts.tractions, tractions_entry))
    , gravity_(parse_field<dim>(texts.gravity, gravity_entry))
  {
    for (const auto &statement : supports_)
      check_name(statement.load_case, supports_entry);
    for (const auto &statement : forces_)
      check_name(statement.load_case, forces_entry);
    for (const auto &statement : tractions_)
      check_name(statement.load_case, tractions_entry);
  }

  template <int dim>
  std::vector<std::string>
  OwnLoads<dim>::cases() const
  {
    std::vector<std::string> names;
    const auto mention = [&](const auto &statements) {
      for (const auto &statement : statements)
        if (!statement.load_case.empty() &&
            std::find(names.begin(), names.end(), statement.load_case) ==
              names.end())
          names.push_back(statement.load_case);
    };
    mention(forces_);
    mention(tractions_);
    mention(supports_);
    const bool is_loaded =
      !forces_.empty() || !tractions_.empty() || !gravity_.empty() ||
      std::any_of(supports_.begin(), supports_.end(), moves<dim>);
    if (names.empty() && is_loaded)
      names.push_back("own");
    return names;
  }

  template <int dim>
  std::vector<Support>
  OwnLoads<dim>::supports(const Mesh<dim> &mesh) const
  {
    std::vector<Support> supports;
    for (const auto &statement : supports_)
      {
        const auto nodes = nodes_of(statement, mesh, supports_entry);
        std::vector<bool> held(dim * nodes.size());
        for (unsigned int v = 0; v < nodes.size(); ++v)
          for (int d = 0; d < dim; ++d)
            held[dim * v + d] = nodes[v] && statement.components[d];
        const auto known = std::find_if(supports.begin(),
                                        supports.end(),
                                        [&](const auto &other) {
                                          return other.name == statement.place;
                                        });
        if (known == supports.end())
          supports.push_back({statement.place, held});
        else
          std::transform(held.begin(),
                         held.end(),
                         known->held.begin(),
                         known->held.begin(),
                         std::logical_or<>());
      }
    return supports;
  }

  template <int dim>
  std::function<NodalLoad(double time)>
  OwnLoads<dim>::load(const std::string &load_case,
                      const Mesh<dim> &mesh,
                      const Element<dim> &element,
                      const MaterialTable &materials) const
  {
    std::vector<PlacedForce<dim>> forces;
    for (const auto &statement : forces_)
      if (belongs(statement, load_case))
        forces.push_back(placed_force(statement, mesh, element, forces_entry));
    for (const auto &statement : tractions_)
      if (belongs(statement, load_case))
        forces.push_back(placed_traction(statement,
                                         mesh,
                                         element,
                                         materials.begin()->second.thickness,
                                         tractions_entry));
    for (const auto &statement : gravity_)
      forces.push_back(
        placed_acceleration(statement, nodal_masses(mesh, element, materials)));

    std::vector<PlacedSupport<dim>> supports;
    for (const auto &statement : supports_)
      if (belongs(statement, load_case))
        supports.push_back(
          {nodes_of(statement, mesh, supports_entry), statement});

    return [forces, supports, &mesh](const double time) {
      return NodalLoad{forces_at(forces, mesh, time),
                       displacement_at(supports, mesh, time, supports_entry)};
    };
  }

  template class OwnLoads<2>;
  template class OwnLoads<3>;
} // namespace springfit
