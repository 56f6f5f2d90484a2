#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/mesh/materials.h>
#include <springfit/mesh/name_lookup.h>
#include <springfit/reference/material.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace springfit
{
  namespace
  {
    const WordTable<PlaneState> &
    plane_state_words()
    {
      static const WordTable<PlaneState> table = {
        {PlaneState::stress, "stress"}, {PlaneState::strain, "strain"}};
      return table;
    }

    std::string
    text_of(const double value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }

    double
    parse_number(const std::string &entry, const std::string &text)
    {
      std::size_t n_read = 0;
      double value       = std::numeric_limits<double>::quiet_NaN();
      try
        {
          value = std::stod(text, &n_read);
        }
      catch (const std::exception &)
        {
          n_read = 0;
        }
      if (n_read != text.size() || !std::isfinite(value))
        throw EntryError(entry,
                         "'" + text + "' is not a finite number.",
                         "Give one number, or \"material id: value, ...\".");
      return value;
    }

    void
    check_is_positive(const double value, const std::string &entry)
    {
      if (!(value > 0.))
        throw EntryError(entry,
                         text_of(value) + " is not positive.",
                         "Give a positive number.");
    }

    std::string
    blanks_removed(const std::string &text)
    {
      const auto pieces = split_at_commas(text);
      return pieces.empty() ? "" : pieces.front();
    }
  } // namespace

  LameConstants
  lame_constants(const ElasticConstants &material)
  {
    const double E  = material.youngs_modulus;
    const double nu = material.poissons_ratio;
    return {E * nu / ((1. + nu) * (1. - 2. * nu)), E / (2. * (1. + nu))};
  }

  LameConstants
  lame_constants_plane_stress(const ElasticConstants &material)
  {
    const double E  = material.youngs_modulus;
    const double nu = material.poissons_ratio;
    return {E * nu / (1. - nu * nu), E / (2. * (1. + nu))};
  }

  template <int spacedim>
  Material<spacedim>::Material() : dealii::ParameterAcceptor("Material")
  {
    const std::string several =
      " One number, or \"material id: value, ...\" with ids or physical names "
      "of the mesh.";
    add_parameter("Young's modulus",
                  youngs_modulus_text_,
                  "Young's modulus E in Pa, positive." + several);
    add_parameter(
      "Poisson's ratio",
      poissons_ratio_text_,
      "Poisson's ratio nu (no unit), between -1 and 0.5; 0.5 itself "
      "is allowed in plane stress only." +
        several);
    add_parameter("Density",
                  density_text_,
                  "Density rho in kg/m^3, positive." + several);
    add_parameter("Plane state",
                  plane_state_word_,
                  "2-d only: " + join(words_of(plane_state_words()), " or ") +
                    " (no unit). Surfaces in space are in plane stress.");
    add_parameter("Thickness",
                  thickness_,
                  "2-d and surfaces in space only: thickness h in m, "
                  "positive.");
    parse_parameters_call_back.connect([this]() { check(); });
  }

  template <int spacedim>
  typename Material<spacedim>::Constant
  Material<spacedim>::parse(const std::string &entry, const std::string &text)
  {
    Constant constant{entry, {}};
    const auto pieces = split_at_commas(text);
    for (const auto &piece : pieces)
      {
        const auto colon       = piece.rfind(':');
        const std::string name = colon == std::string::npos
                                   ? ""
                                   : blanks_removed(piece.substr(0, colon));
        if (name.empty() && (colon != std::string::npos || pieces.size() > 1))
          throw EntryError(entry,
                           "'" + piece + "' names no material.",
                           "Give one number, or \"material id: value, ...\".");
        const std::string value = colon == std::string::npos
                                    ? piece
                                    : blanks_removed(piece.substr(colon + 1));
        if (!constant.by_name.emplace(name, parse_number(entry, value)).second)
          throw EntryError(entry,
                           "the material '" + name + "' is given twice.",
                           "Give it once.");
      }
    if (pieces.empty())
      throw EntryError(entry, "no value is given.", "Give a number.");
    return constant;
  }

  template <int spacedim>
  void
  Material<spacedim>::check()
  {
    youngs_modulus_ = parse("Material/Young's modulus", youngs_modulus_text_);
    poissons_ratio_ = parse("Material/Poisson's ratio", poissons_ratio_text_);
    density_        = parse("Material/Density", density_text_);

    for (const auto &[name, value] : density_.by_name)
      check_is_positive(value, density_.entry);
    for (const auto &[name, value] : youngs_modulus_.by_name)
      check_youngs_modulus(value, youngs_modulus_.entry);
    for (const auto &[name, value] : poissons_ratio_.by_name)
      check_poissons_ratio(value, poissons_ratio_.entry);

    if (!(thickness_ > 0. && std::isfinite(thickness_)))
      throw EntryError("Material/Thickness",
                       text_of(thickness_) + " is not positive and finite.",
                       "Give a thickness in m.");
  }

  template <int spacedim>
  void
  Material<spacedim>::check_youngs_modulus(const double modulus,
                                           const std::string &entry) const
  {
    check_is_positive(modulus, entry);
    // Wider than any material, and far from where squares leave the numbers.
    constexpr double smallest = 1e-30, largest = 1e30;
    if (modulus < smallest || modulus > largest)
      throw EntryError(entry,
                       text_of(modulus) + " is out of range.",
                       "Give a number between " + text_of(smallest) + " and " +
                         text_of(largest) + " (in Pa).");
  }

  template <int spacedim>
  void
  Material<spacedim>::check_poissons_ratio(const double ratio,
                                           const std::string &entry) const
  {
    // The word is checked in 3-d as well.
    const bool plane_stress = plane_state() == PlaneState::stress;
    const bool half_allowed = spacedim == 2 && plane_stress;
    if (!(ratio > -1. && (ratio < 0.5 || (half_allowed && ratio == 0.5))))
      throw EntryError(entry,
                       text_of(ratio) + " is out of range.",
                       std::string("Give a number above -1 and ") +
                         (half_allowed ? "at most 0.5."
                                       : "below 0.5 (0.5 itself is allowed "
                                         "in plane stress only)."));
  }

  template <int spacedim>
  PlaneState
  Material<spacedim>::plane_state() const
  {
    return value_of(plane_state_words(),
                    plane_state_word_,
                    "Material/Plane state");
  }

  template <int spacedim>
  template <int dim>
  double
  Material<spacedim>::value(const Constant &constant,
                            const Mesh<dim, spacedim> &mesh,
                            const dealii::types::material_id id)
  {
    const double *found = nullptr;
    for (const auto &[name, value] : constant.by_name)
      {
        if (!name.empty() &&
            find_materials(mesh, name, constant.entry).count(id) == 0)
          continue;
        if (found != nullptr && *found != value)
          throw EntryError(constant.entry,
                           "the material " + std::to_string(id) + " (" +
                             joined_names(mesh.material_names, id) +
                             ") has two values, by several of its names.",
                           "Give it one.");
        found = &value;
      }
    if (found != nullptr)
      return *found;
    const std::string name = joined_names(mesh.material_names, id);
    throw EntryError(constant.entry,
                     "the material " + std::to_string(id) +
                       (name.empty() ? "" : " (" + name + ")") +
                       " of the mesh has no value.",
                     "Add \"" + std::to_string(id) + ": value\".");
  }

  template <int spacedim>
  template <int dim>
  MaterialTable
  Material<spacedim>::resolve(const Mesh<dim, spacedim> &mesh) const
  {
    if (dim < spacedim && plane_state() != PlaneState::stress)
      throw EntryError("Material/Plane state",
                       "a surface in space is in plane stress.",
                       "Set it to stress.");

    // Every name must be there, even one that no cell happens to ask for.
    for (const Constant *constant :
         {&youngs_modulus_, &poissons_ratio_, &density_})
      for (const auto &[name, value] : constant->by_name)
        if (!name.empty())
          find_materials(mesh, name, constant->entry);

    MaterialTable table;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        const auto id = cell->material_id();
        if (table.count(id) > 0)
          continue;
        table[id] = with_constants<dim>({value(youngs_modulus_, mesh, id),
                                         value(poissons_ratio_, mesh, id),
                                         value(density_, mesh, id)});
      }
    return table;
  }

  template <int spacedim>
  template <int dim>
  CellMaterial
  Material<spacedim>::with_constants(const ElasticConstants &constants) const
  {
    const bool plane_stress = dim == 2 && plane_state() == PlaneState::stress;
    return {constants,
            plane_stress ? lame_constants_plane_stress(constants)
                         : lame_constants(constants),
            dim == 2 ? thickness_ : 1.,
            plane_state()};
  }

  template class Material<2>;
  template class Material<3>;
  template MaterialTable
  Material<2>::resolve(const Mesh<2> &) const;
  template MaterialTable
  Material<3>::resolve(const Mesh<2, 3> &) const;
  template MaterialTable
  Material<3>::resolve(const Mesh<3> &) const;
  template CellMaterial
  Material<2>::with_constants<2>(const ElasticConstants &) const;
  template CellMaterial
  Material<3>::with_constants<2>(const ElasticConstants &) const;
  template CellMaterial
  Material<3>::with_constants<3>(const ElasticConstants &) const;
} // namespace springfit
