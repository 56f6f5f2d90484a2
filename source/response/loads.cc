#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/response/boundary_parts.h>
#include <springfit/response/canned_loads.h>
#include <springfit/response/loaded_surface.h>
#include <springfit/response/loads.h>
#include <springfit/response/supports.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace springfit
{
  namespace
  {
    template <int spacedim>
    Eigen::VectorXd
    to_eigen(const dealii::Tensor<1, spacedim> &tensor)
    {
      Eigen::VectorXd vector(spacedim);
      for (int d = 0; d < spacedim; ++d)
        vector[d] = tensor[d];
      return vector;
    }

    /** How far a mesh reaches along a direction of length 1, m. */
    template <int dim, int spacedim>
    double
    extent_along(const dealii::Tensor<1, spacedim> &axis,
                 const Mesh<dim, spacedim> &mesh)
    {
      const auto &vertices = mesh.triangulation.get_vertices();
      double lowest = axis * vertices[0], highest = lowest;
      for (const auto &vertex : vertices)
        {
          lowest  = std::min(lowest, axis * vertex);
          highest = std::max(highest, axis * vertex);
        }
      return highest - lowest;
    }

    template <int spacedim>
    std::vector<std::string>
    canned_words()
    {
      auto words = words_of(load_words());
      if (spacedim == 2)
        words.pop_back(); // torsion
      return words;
    }

    const std::string no_boundary = "none", no_load = "none";

    bool
    is_canned(const std::string &name)
    {
      const auto words = words_of(load_words());
      return std::find(words.begin(), words.end(), name) != words.end();
    }
  } // namespace

  template <int spacedim>
  Loads<spacedim>::Loads() : dealii::ParameterAcceptor("Loads")
  {
    add_parameter(
      "Cases",
      cases_word_,
      "Load cases, each a row of the tables: " +
        join(canned_words<spacedim>()) +
        ", or those that 'Forces', 'Tractions' and 'Supports' name (no unit). "
        "Empty: the latter if there are any, else all of the former. \"none\" "
        "is one without any load, for a motion under contact alone. Tension "
        "pulls the loaded boundaries along their mean outward normal, "
        "compression against it, shear along the coordinate direction most "
        "perpendicular to it; torsion turns them about it." +
        (spacedim == 2 ? " Torsion needs three dimensions." : ""));
    add_parameter(
      "Training cases",
      training_word_,
      "Those of the cases whose responses a fit of the whole object is made "
      "with, where it is made with 'Fields = responses'; empty: all of them "
      "(no unit). The others are loads that it has not seen.");
    add_parameter(
      "Fixed boundaries",
      fixed_boundaries_,
      "Boundary ids or names whose nodes are held in all directions; "
      "a name that holds a comma, or is a number, stands in double "
      "quotes, and \"id 2\" is the number 2. If empty and there is "
      "no 'Fixed region' and no 'Supports', 0; \"none\" leaves a body free, "
      "which moves but has no equilibrium (no unit).");
    add_parameter(
      "Loaded boundaries",
      loaded_boundaries_,
      "Boundary ids or names on which the traction of tension, compression, "
      "shear and torsion acts, written as those that are fixed. If empty and "
      "there is no 'Loaded region', 1 (no unit).");
    add_parameter("Fixed region",
                  fixed_region_,
                  "Instead of 'Fixed boundaries': a condition on x, y, z in m "
                  "that the held nodes meet, such as \"x < 1e-6\".");
    add_parameter("Loaded region",
                  loaded_region_,
                  "Instead of 'Loaded boundaries': a condition on x, y, z in m "
                  "that all vertices of a loaded boundary face meet.");
    add_parameter("Deformation",
                  deformation_,
                  "The force of tension, compression, shear and torsion is "
                  "scaled so that the linear finite element model's largest "
                  "displacement is this times the object's extent along the "
                  "pull (no unit, 0.1 is 10 %), positive.");

    const std::string direction = spacedim == 2 ? "0, -2" : "0, 0, -2";
    const std::string last      = spacedim == 2 ? "y" : "z";
    add_parameter(
      "Supports",
      own_.supports,
      "Components that are held, or moved to a displacement in m, between "
      "semicolons: \"base; floor: " +
        last + "; where x < 1e-6: x, y = 0.001 * t; press on lid: " + last +
        " = -0.002\" holds the boundary base, lets floor slide, and moves lid "
        "in the case press. Without \"CASE on\" it is so in all cases of the "
        "user's own; what others hold is held, too, and stays where it is. "
        "Displacements are expressions of x, y, " +
        (spacedim == 2 ? "" : "z, ") + "t (m, s).");
    add_parameter(
      "Forces",
      own_.forces,
      "Forces in N, spread evenly over the boundaries that they act on: "
      "\"press on top, side: " +
        direction +
        "; pull on where x > 0.01: " + (spacedim == 2 ? "1, 0" : "1, 0, 0") +
        "\" are the load cases press and pull. Components are expressions "
        "of x, y, " +
        (spacedim == 2 ? "" : "z, ") + "t (m, s).");
    add_parameter("Tractions",
                  own_.tractions,
                  "The same in Pa, forces per area at rest: \"press on top: " +
                    direction + "00\".");
    add_parameter("Gravity",
                  own_.gravity,
                  std::string("Acceleration in m/s^2 of all nodes in all cases "
                              "of the user's own: \"") +
                    (spacedim == 2 ? "0, -9.81" : "0, 0, -9.81") + "\".");
    add_parameter("Time",
                  time_,
                  "The time in s at which statics take expressions of t.");
    this->parse_parameters_call_back.connect([this]() { complete(); });
  }

  template <int spacedim>
  void
  Loads<spacedim>::complete(const std::string &which,
                            const std::string &boundaries,
                            const std::string &region,
                            const std::string &otherwise)
  {
    if (!boundaries.empty() && !region.empty())
      throw EntryError("Loads/" + which + " region",
                       "'" + which + " boundaries = " + boundaries +
                         "' is given beside it.",
                       "Give one of the two and leave the other empty.");
    // Through the entry, so that it is among the values in force.
    if (boundaries.empty() && region.empty() && !otherwise.empty())
      this->prm.set(which + " boundaries", otherwise);
  }

  template <int spacedim>
  void
  Loads<spacedim>::complete()
  {
    if (split_at_commas(cases_word_).empty())
      {
        const auto own = own_loads().cases();
        this->prm.set("Cases",
                      join(own.empty() ? canned_words<spacedim>() : own));
      }
    complete("Fixed",
             fixed_boundaries_,
             fixed_region_,
             own_.supports.empty() ? "0" : "");
    complete("Loaded",
             loaded_boundaries_,
             loaded_region_,
             has_canned_cases() ? "1" : "");
  }

  template <int spacedim>
  OwnLoads<spacedim>
  Loads<spacedim>::own_loads() const
  {
    return OwnLoads<spacedim>(own_);
  }

  template <int spacedim>
  std::vector<std::string>
  Loads<spacedim>::cases_of(const std::string &words,
                            const std::string &entry) const
  {
    WordTable<std::string> known;
    for (const auto &word : words_of(load_words()))
      known.emplace_back(word, word);
    for (const auto &name : own_loads().cases())
      known.emplace_back(name, name);
    known.emplace_back(no_load, no_load);
    return values_of(known, words, entry);
  }

  template <int spacedim>
  std::vector<std::string>
  Loads<spacedim>::training_cases() const
  {
    const std::string entry = "Loads/Training cases";
    const auto all          = cases_of(cases_word_, "Loads/Cases");
    if (split_at_commas(training_word_).empty())
      return all;
    const auto training = cases_of(training_word_, entry);
    for (const auto &name : training)
      if (std::find(all.begin(), all.end(), name) == all.end())
        throw EntryError(entry,
                         "'" + name + "' is not among the cases.",
                         "Add it to 'Cases', which has " + cases_word_ + '.');
    return training;
  }

  template <int spacedim>
  bool
  Loads<spacedim>::has_canned_cases() const
  {
    const auto cases = split_at_commas(cases_word_);
    return std::any_of(cases.begin(), cases.end(), is_canned);
  }

  template <int spacedim>
  void
  Loads<spacedim>::check() const
  {
    training_cases();
    for (const auto &name : cases_of(cases_word_, "Loads/Cases"))
      if (spacedim == 2 && name == word_of(load_words(), Load::torsion))
        throw EntryError("Loads/Cases",
                         "torsion needs three dimensions.",
                         "Remove it, or set Dimension = 3.");
    if (!(deformation_ > 0. && std::isfinite(deformation_)))
      {
        std::ostringstream value;
        value << deformation_;
        throw EntryError("Loads/Deformation",
                         value.str() + " is not positive and finite.",
                         "Give a fraction of the object's extent, such as "
                         "0.1.");
      }
  }

  template <int spacedim>
  template <int dim>
  std::vector<bool>
  Loads<spacedim>::fixed_nodes(const Mesh<dim, spacedim> &mesh) const
  {
    if (fixed_region_.empty())
      return nodes_of_faces(mesh,
                            faces_of_boundaries(mesh,
                                                fixed_boundaries_,
                                                "Loads/Fixed boundaries"));
    const auto nodes = nodes_where(mesh, fixed_region_, "Loads/Fixed region");
    if (std::find(nodes.begin(), nodes.end(), true) == nodes.end())
      throw EntryError("Loads/Fixed region",
                       "no node meets '" + fixed_region_ + "'.",
                       "Lengths are in m; widen the condition.");
    return nodes;
  }

  template <int spacedim>
  std::string
  Loads<spacedim>::entry_of_supports() const
  {
    if (!fixed_region_.empty())
      return "Loads/Fixed region";
    return own_.supports.empty() ? "Loads/Fixed boundaries" : "Loads/Supports";
  }

  template <int spacedim>
  template <int dim>
  void
  Loads<spacedim>::add_canned(const Mesh<dim, spacedim> &mesh,
                              const Element<dim, spacedim> &element,
                              const double thickness,
                              Loading &loading) const
  {
    const bool by_region = !loaded_region_.empty();
    const std::string entry =
      by_region ? "Loads/Loaded region" : "Loads/Loaded boundaries";
    auto faces = by_region
                   ? faces_where(mesh, loaded_region_, entry)
                   : faces_of_boundaries(mesh, loaded_boundaries_, entry);
    if (faces.empty())
      throw EntryError(entry,
                       "no boundary face is loaded.",
                       "Name a boundary of the mesh, or widen the condition "
                       "(lengths are in m, and all vertices of a face must "
                       "meet it).");
    const auto loaded = nodes_of_faces(mesh, faces);
    bool felt         = false;
    for (unsigned int v = 0; v < loaded.size(); ++v)
      for (int d = 0; d < spacedim; ++d)
        felt = felt || (loaded[v] && !loading.held[spacedim * v + d]);
    if (!felt)
      throw EntryError(entry,
                       "every loaded node is fixed, so that no load is left.",
                       "Load another boundary than the fixed one.");

    const LoadedSurface<dim, spacedim> surface(mesh, std::move(faces), element);
    if (surface.mean_normal().norm() < 1e-6)
      throw EntryError(entry,
                       "the loaded surface is closed or symmetric: its mean "
                       "normal, the axis of the pull, vanishes.",
                       "Load a part of the boundary that faces one way.");
    const dealii::Tensor<1, spacedim> axis =
      surface.mean_normal() / surface.mean_normal().norm();
    loading.pull = {to_eigen(axis), extent_along(axis, mesh), deformation_};

    for (auto &load_case : loading.cases)
      if (load_case.canned)
        load_case.load = load_of_forces(
          thickness *
          surface.forces(unit_traction(*load_case.canned, axis, surface)));
  }

  template <int spacedim>
  template <int dim>
  void
  Loads<spacedim>::check_supports(const Mesh<dim, spacedim> &mesh,
                                  const Loading &loading) const
  {
    springfit::check_supports(mesh, loading.held, entry_of_supports());
  }

  template <int spacedim>
  template <int dim>
  Loading
  Loads<spacedim>::resolve(const Mesh<dim, spacedim> &mesh,
                           const Element<dim, spacedim> &element,
                           const MaterialTable &materials) const
  {
    const auto own = own_loads();
    Loading loading;
    loading.training = training_cases();
    loading.supports = own.supports(mesh);
    if (!fixed_region_.empty() ||
        !(fixed_boundaries_.empty() || fixed_boundaries_ == no_boundary))
      {
        const auto fixed = fixed_nodes(mesh);
        std::vector<bool> held;
        for (const bool is_fixed : fixed)
          held.insert(held.end(), spacedim, is_fixed);
        loading.supports.insert(loading.supports.begin(), {"fixed", held});
      }
    loading.held.assign(spacedim * mesh.nodes.size(), false);
    for (const auto &support : loading.supports)
      for (std::size_t i = 0; i < loading.held.size(); ++i)
        loading.held[i] = loading.held[i] || support.held[i];
    for (const auto &name : cases_of(cases_word_, "Loads/Cases"))
      {
        LoadCase load_case{name, {}, {}, {}};
        if (is_canned(name))
          load_case.canned = value_of(load_words(), name, "Loads/Cases");
        else
          {
            load_case.at   = own.load(name, mesh, element, materials);
            load_case.load = load_case.at(time_);
          }
        loading.cases.push_back(load_case);
      }
    if (has_canned_cases())
      add_canned(mesh, element, materials.begin()->second.thickness, loading);
    return loading;
  }

  template class Loads<2>;
  template class Loads<3>;
  template Loading
  Loads<2>::resolve(const Mesh<2> &,
                    const Element<2> &,
                    const MaterialTable &) const;
  template void
  Loads<2>::check_supports(const Mesh<2> &, const Loading &) const;
  template Loading
  Loads<3>::resolve(const Mesh<2, 3> &,
                    const Element<2, 3> &,
                    const MaterialTable &) const;
  template void
  Loads<3>::check_supports(const Mesh<2, 3> &, const Loading &) const;
  template Loading
  Loads<3>::resolve(const Mesh<3> &,
                    const Element<3> &,
                    const MaterialTable &) const;
  template void
  Loads<3>::check_supports(const Mesh<3> &, const Loading &) const;
} // namespace springfit
