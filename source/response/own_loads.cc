#include <springfit/core/error.h>
#include <springfit/reference/nodal_masses.h>
#include <springfit/response/own_loads.h>
#include <springfit/springs/spring_kinds.h>

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
      // Names of files begin with that of a case or with one of these.
      auto taken = words_of(load_words());
      taken.insert(taken.end(), {"fem", "none", "export"});
      for (const SpringKind *kind : spring_kinds())
        taken.push_back(kind->word());
      if (std::find(taken.begin(), taken.end(), name) != taken.end())
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

    template <int spacedim>
    bool
    moves(const SupportStatement<spacedim> &statement)
    {
      const dealii::Point<spacedim> origin;
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

  template <int spacedim>
  OwnLoads<spacedim>::OwnLoads(const OwnLoadTexts &texts)
    : supports_(parse_supports<spacedim>(texts.supports, supports_entry))
    , forces_(parse_forces<spacedim>(texts.forces, forces_entry))
    , tractions_(parse_forces<spacedim>(texts.tractions, tractions_entry))
    , gravity_(parse_field<spacedim>(texts.gravity, gravity_entry))
  {
    for (const auto &statement : supports_)
      check_name(statement.load_case, supports_entry);
    for (const auto &statement : forces_)
      check_name(statement.load_case, forces_entry);
    for (const auto &statement : tractions_)
      check_name(statement.load_case, tractions_entry);
  }

  template <int spacedim>
  std::vector<std::string>
  OwnLoads<spacedim>::cases() const
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
      std::any_of(supports_.begin(), supports_.end(), moves<spacedim>);
    if (names.empty() && is_loaded)
      names.push_back("own");
    return names;
  }

  template <int spacedim>
  template <int dim>
  std::vector<Support>
  OwnLoads<spacedim>::supports(const Mesh<dim, spacedim> &mesh) const
  {
    std::vector<Support> supports;
    for (const auto &statement : supports_)
      {
        const auto nodes = nodes_of(statement, mesh, supports_entry);
        std::vector<bool> held(spacedim * nodes.size());
        for (unsigned int v = 0; v < nodes.size(); ++v)
          for (int d = 0; d < spacedim; ++d)
            held[spacedim * v + d] = nodes[v] && statement.components[d];
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

  template <int spacedim>
  template <int dim>
  std::function<NodalLoad(double time)>
  OwnLoads<spacedim>::load(const std::string &load_case,
                           const Mesh<dim, spacedim> &mesh,
                           const Element<dim, spacedim> &element,
                           const MaterialTable &materials) const
  {
    std::vector<PlacedForce<spacedim>> forces;
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

    std::vector<PlacedSupport<spacedim>> supports;
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
  template std::vector<Support>
  OwnLoads<2>::supports(const Mesh<2> &) const;
  template std::function<NodalLoad(double time)>
  OwnLoads<2>::load(const std::string &,
                    const Mesh<2> &,
                    const Element<2> &,
                    const MaterialTable &) const;
  template std::vector<Support>
  OwnLoads<3>::supports(const Mesh<2, 3> &) const;
  template std::function<NodalLoad(double time)>
  OwnLoads<3>::load(const std::string &,
                    const Mesh<2, 3> &,
                    const Element<2, 3> &,
                    const MaterialTable &) const;
  template std::vector<Support>
  OwnLoads<3>::supports(const Mesh<3> &) const;
  template std::function<NodalLoad(double time)>
  OwnLoads<3>::load(const std::string &,
                    const Mesh<3> &,
                    const Element<3> &,
                    const MaterialTable &) const;
} // namespace springfit
