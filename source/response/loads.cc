#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/mesh/boundaries.h>
#include <springfit/response/loaded_surface.h>
#include <springfit/response/loads.h>
#include <springfit/response/region.h>
#include <springfit/response/supports.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace springfit
{
  namespace
  {
    template <int dim>
    Eigen::VectorXd
    to_eigen(const dealii::Tensor<1, dim> &tensor)
    {
      Eigen::VectorXd vector(dim);
      for (int d = 0; d < dim; ++d)
        vector[d] = tensor[d];
      return vector;
    }

    /** Whether a face of the boundary belongs to a part that a user names. */
    template <int dim>
    using FaceCondition = std::function<bool(
      const typename dealii::Triangulation<dim>::active_face_iterator &)>;

    /**
     * A part of the boundary: the faces in the region, if one is given, or
     * else those with one of the boundary ids.
     */
    template <int dim>
    FaceCondition<dim>
    face_condition(const Mesh<dim> &mesh,
                   const std::string &boundaries,
                   const std::string &region,
                   const std::string &which)
    {
      if (!region.empty())
        {
          const auto shape =
            std::make_shared<Region<dim>>(region, "Loads/" + which + " region");
          return [shape](const auto &face) {
            for (const unsigned int v : face->vertex_indices())
              if (!shape->contains(face->vertex(v)))
                return false;
            return true;
          };
        }
      const auto ids = find_boundaries(mesh,
                                       split_at_commas(boundaries),
                                       "Loads/" + which + " boundaries");
      return
        [ids](const auto &face) { return ids.count(face->boundary_id()) > 0; };
    }

    template <int dim>
    std::vector<typename LoadedSurface<dim>::Face>
    faces_where(const Mesh<dim> &mesh, const FaceCondition<dim> &condition)
    {
      std::vector<typename LoadedSurface<dim>::Face> faces;
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && condition(cell->face(f)))
            faces.push_back({cell, f});
      return faces;
    }

    /** The coordinate direction most perpendicular to @p axis, made so. */
    template <int dim>
    dealii::Tensor<1, dim>
    shear_direction(const dealii::Tensor<1, dim> &axis)
    {
      // The tolerance keeps the choice from hanging on rounding errors; among
      // equals the first direction after the axis' own is taken.
      int own = 0;
      for (int d = 1; d < dim; ++d)
        if (std::abs(axis[d]) > std::abs(axis[own]) + 1e-6)
          own = d;
      int best = (own + 1) % dim;
      for (int d = 0; d < dim; ++d)
        if (std::abs(axis[d]) < std::abs(axis[best]) - 1e-6)
          best = d;
      dealii::Tensor<1, dim> direction;
      direction[best] = 1.;
      direction -= (direction * axis) * axis;
      return direction / direction.norm();
    }

    template <int dim>
    typename LoadedSurface<dim>::Traction
    unit_traction(const Load load,
                  const dealii::Tensor<1, dim> &axis,
                  const LoadedSurface<dim> &surface)
    {
      switch (load)
        {
          case Load::tension:
            return [axis](const auto &) { return axis; };
          case Load::compression:
            return [axis](const auto &) { return -axis; };
          case Load::shear:
            return [direction = shear_direction(axis)](const auto &) {
              return direction;
            };
          default:
            return [axis,
                    centroid = surface.centroid(),
                    radius   = surface.radius()](const auto &point) {
              dealii::Tensor<1, dim> traction;
              if constexpr (dim == 3)
                traction =
                  dealii::cross_product_3d(axis, point - centroid) / radius;
              return traction;
            };
        }
    }
  } // namespace

  template <int dim>
  Loads<dim>::Loads() : dealii::ParameterAcceptor("Loads")
  {
    auto words = words_of(load_words());
    if (dim == 2)
      words.pop_back(); // torsion
    cases_word_ = join(words);

    add_parameter(
      "Cases",
      cases_word_,
      "Load cases, each a row of the tables: " + join(words) +
        " (no unit). Tension pulls the loaded boundaries along their "
        "mean outward normal, compression against it, shear along "
        "the coordinate direction most perpendicular to it; "
        "torsion turns them about it." +
        (dim == 2 ? " Torsion needs three dimensions." : ""));
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
      "no 'Fixed region', 0 (no unit).");
    add_parameter(
      "Loaded boundaries",
      loaded_boundaries_,
      "Boundary ids or names on which the traction acts, written as "
      "those that are fixed. If empty and there is no 'Loaded "
      "region', 1 (no unit).");
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
                  "The force is scaled so that the linear finite element "
                  "model's largest displacement is this times the object's "
                  "extent along the pull (no unit, 0.1 is 10 %), positive.");
    this->parse_parameters_call_back.connect([this]() {
      complete("Fixed", fixed_boundaries_, fixed_region_, "0");
      complete("Loaded", loaded_boundaries_, loaded_region_, "1");
    });
  }

  template <int dim>
  void
  Loads<dim>::complete(const std::string &which,
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
    if (boundaries.empty() && region.empty())
      this->prm.set(which + " boundaries", otherwise);
  }

  template <int dim>
  std::vector<Load>
  Loads<dim>::cases() const
  {
    return values_of(load_words(), cases_word_, "Loads/Cases");
  }

  template <int dim>
  std::vector<Load>
  Loads<dim>::training_cases() const
  {
    const std::string entry = "Loads/Training cases";
    const auto all          = cases();
    if (split_at_commas(training_word_).empty())
      return all;
    const auto training = values_of(load_words(), training_word_, entry);
    for (const Load load : training)
      if (std::find(all.begin(), all.end(), load) == all.end())
        throw EntryError(entry,
                         "'" + word_of(load_words(), load) +
                           "' is not among the cases.",
                         "Add it to 'Cases', which has " + cases_word_ + '.');
    return training;
  }

  template <int dim>
  void
  Loads<dim>::check() const
  {
    training_cases();
    for (const Load load : cases())
      if (dim == 2 && load == Load::torsion)
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

  template <int dim>
  std::vector<bool>
  Loads<dim>::fixed_nodes(const Mesh<dim> &mesh) const
  {
    const auto &vertices = mesh.triangulation.get_vertices();
    std::vector<bool> fixed(vertices.size(), false);
    if (!fixed_region_.empty())
      {
        const Region<dim> region(fixed_region_, "Loads/Fixed region");
        for (unsigned int v = 0; v < vertices.size(); ++v)
          fixed[v] = region.contains(vertices[v]);
        if (std::count(fixed.begin(), fixed.end(), true) == 0)
          throw EntryError("Loads/Fixed region",
                           "no node meets '" + fixed_region_ + "'.",
                           "Lengths are in m; widen the condition.");
      }
    else
      for (const auto &[cell, number] :
           faces_where(mesh,
                       face_condition(mesh, fixed_boundaries_, "", "Fixed")))
        for (const unsigned int v : cell->face(number)->vertex_indices())
          fixed[cell->face(number)->vertex_index(v)] = true;
    return fixed;
  }

  template <int dim>
  Loading
  Loads<dim>::resolve(const Mesh<dim> &mesh,
                      const Element<dim> &element,
                      const double thickness) const
  {
    const auto &vertices       = mesh.triangulation.get_vertices();
    const unsigned int n_nodes = vertices.size();

    Loading loading;
    loading.fixed       = fixed_nodes(mesh);
    loading.deformation = deformation_;
    check_supports(mesh,
                   loading.fixed,
                   fixed_region_.empty() ? "Loads/Fixed boundaries"
                                         : "Loads/Fixed region");

    const std::string loaded_entry = loaded_region_.empty()
                                       ? "Loads/Loaded boundaries"
                                       : "Loads/Loaded region";
    auto faces                     = faces_where(
      mesh, face_condition(mesh, loaded_boundaries_, loaded_region_, "Loaded"));
    if (faces.empty())
      throw EntryError(loaded_entry,
                       "no boundary face is loaded.",
                       "Name a boundary of the mesh, or widen the condition "
                       "(lengths are in m, and all vertices of a face must "
                       "meet it).");
    const LoadedSurface<dim> surface(std::move(faces), element);

    const auto loaded = surface.nodes(n_nodes);
    bool felt         = false;
    for (unsigned int v = 0; v < n_nodes; ++v)
      felt = felt || (loaded[v] && !loading.fixed[v]);
    if (!felt)
      throw EntryError(loaded_entry,
                       "every loaded node is fixed, so that no load is left.",
                       "Load another boundary than the fixed one.");

    if (surface.mean_normal().norm() < 1e-6)
      throw EntryError(loaded_entry,
                       "the loaded surface is closed or symmetric: its mean "
                       "normal, the axis of the pull, vanishes.",
                       "Load a part of the boundary that faces one way.");
    const dealii::Tensor<1, dim> axis =
      surface.mean_normal() / surface.mean_normal().norm();
    loading.axis = to_eigen(axis);

    double lowest = axis * vertices[0], highest = lowest;
    for (const auto &vertex : vertices)
      {
        lowest  = std::min(lowest, axis * vertex);
        highest = std::max(highest, axis * vertex);
      }
    loading.extent = highest - lowest;

    for (const Load load : cases())
      loading.cases.push_back(
        {load,
         thickness *
           surface.forces(unit_traction(load, axis, surface), n_nodes)});
    loading.training = training_cases();
    return loading;
  }

  template class Loads<2>;
  template class Loads<3>;
} // namespace springfit
