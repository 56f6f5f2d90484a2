#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/mesh/objects.h>
#include <springfit/studies/tradeoff_section.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace springfit
{
  namespace
  {
    enum class Models
    {
      all,
      chosen
    };

    const WordTable<Models> &
    model_words()
    {
      static const WordTable<Models> table = {{Models::all, "all"},
                                              {Models::chosen, "chosen"}};
      return table;
    }

    std::string
    full_name(const std::string &entry)
    {
      return "Tradeoff/" + entry;
    }

    std::string
    text_of(const double value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }

    std::vector<double>
    scaled(std::vector<double> values, const double factor)
    {
      for (double &value : values)
        value *= factor;
      return values;
    }

    void
    check_dimension(const CellKind kind,
                    const CellKind own,
                    const std::string &entry)
    {
      if (dimension(kind) != dimension(own))
        throw EntryError(full_name(entry),
                         word_of(cell_kind_words(), kind) +
                           " have another dimension than " +
                           word_of(cell_kind_words(), own) +
                           " of section Geometry.",
                         "Compare cells of one dimension.");
    }

    double
    smallest(const std::vector<double> &values)
    {
      return *std::min_element(values.begin(), values.end());
    }
  } // namespace

  template <int dim>
  TradeoffSection<dim>::TradeoffSection()
    : dealii::ParameterAcceptor("Tradeoff")
  {
    add_parameter("Models",
                  models_,
                  "Which springs and finite elements are measured: " +
                    join(words_of(model_words()), " or ") +
                    " (no unit). all: those that can be the right ones for "
                    "some scene, of all kinematics and of the linear law as "
                    "well, whatever the sections Fit and Response say; chosen: "
                    "those of 'Methods', 'Enrichment', 'Kinematics' and "
                    "'Material laws'.");
    add_parameter(
      "Cells",
      cells_,
      "Cells that the object is made of, one after the other, as in "
      "section Geometry (no unit). Empty: those of Geometry.");
    add_parameter(
      "Cell sizes",
      cell_sizes_,
      "Edge lengths of the cells, between commas, m. Empty: that of "
      "Geometry. A mesh file has its own.");
    add_parameter("Halvings",
                  n_halvings_,
                  "How often each cell size is followed by half of it (no "
                  "unit); at most 5.",
                  prm,
                  dealii::Patterns::Integer(0));
    add_parameter("Material laws",
                  laws_,
                  "Of the finite elements among the models: " +
                    join(words_of(material_law_words()), " or ") +
                    ", between commas (no unit). Empty: that of section "
                    "Response, which the reference has, too.");
    add_parameter("Reference cells",
                  reference_cells_,
                  "Cells of the reference (no unit). Empty: the first of "
                  "'Cells'.");
    add_parameter("Reference cell size",
                  reference_size_,
                  "Edge length of the reference's cells, m. 0: the smallest of "
                  "the models', of degree 1 half of that.");
    add_parameter("Reference degree",
                  reference_degree_,
                  "Degree of its shape functions, 1 or 2 (no unit). Those of "
                  "degree 2 bend, and do not lock where material is nearly "
                  "incompressible.",
                  prm,
                  dealii::Patterns::Integer(0));
    add_parameter("Accuracy",
                  accuracy_,
                  "Largest root mean square distance from the reference that "
                  "is good enough, in % of its largest displacement; "
                  "positive.");
    add_parameter("Time budget",
                  budget_,
                  "Longest time that a solution of statics or a time step may "
                  "take, s; 0: any.");
    add_parameter("Purpose",
                  purpose_,
                  "What the time is of: " +
                    join(words_of(purpose_words()), " or ") +
                    " (no unit). Explicit motion takes as many steps as it "
                    "needs for a 'Time step' of section Dynamics.");
    add_parameter("Quantity",
                  quantity_,
                  std::string("A number whose error is wanted, too: "
                              "\"displacement of BOUNDARY: x\" (its mean), "
                              "\"displacement at ") +
                    (dim == 2 ? "0.01, 0.02: y" : "0.01, 0.01, 0.02: z") +
                    "\" (a point in m), \"reaction of SUPPORT: x\" (no unit). "
                    "Empty: none.");
    add_parameter("Repetitions",
                  n_repetitions_,
                  "Times are medians of so many measurements, in which the "
                  "models take turns (no unit); 1 to 100.",
                  prm,
                  dealii::Patterns::Integer(0));
  }

  template <int dim>
  void
  TradeoffSection<dim>::choose_models()
  {
    if (value_of(model_words(), models_, full_name("Models")) == Models::chosen)
      return;
    const auto set = [this](const std::string &section,
                            const std::string &entry,
                            const std::string &value) {
      this->prm.enter_subsection(section);
      this->prm.set(entry, value);
      this->prm.leave_subsection();
    };
    this->prm.enter_subsection("Response");
    const std::string law = this->prm.get("Material law");
    this->prm.leave_subsection();
    const std::string linear =
      word_of(material_law_words(), MaterialLaw::linear);
    set("Fit", "Methods", "frobenius, consistent, stable neo-hookean");
    set("Fit", "Enrichment", "none, volume, point volumes");
    set("Fit", "Nonnegative", "true");
    set("Response",
        "Kinematics",
        law == linear ? "linear" : "linear, nonlinear");
    set("Tradeoff", "Material laws", law == linear ? law : linear + ", " + law);
  }

  template <int dim>
  void
  TradeoffSection<dim>::check(const Geometry<dim> &geometry) const
  {
    if (!(accuracy_ > 0. && std::isfinite(accuracy_)))
      throw EntryError(full_name("Accuracy"),
                       text_of(accuracy_) + " % is not positive and finite.",
                       "No model is exact: give a percentage, such as 5.");
    if (!(budget_ >= 0. && std::isfinite(budget_)))
      throw EntryError(full_name("Time budget"),
                       text_of(budget_) + " s is negative or not finite.",
                       "Give a time in s, or 0 for any.");
    if (n_halvings_ > 5)
      throw EntryError(full_name("Halvings"),
                       std::to_string(n_halvings_) + " are too many.",
                       "Give at most 5.");
    if (n_repetitions_ < 1 || n_repetitions_ > 100)
      throw EntryError(full_name("Repetitions"),
                       std::to_string(n_repetitions_) + " is out of range.",
                       "Give a number from 1 to 100.");
    if (reference_degree_ != 1 && reference_degree_ != 2)
      throw EntryError(full_name("Reference degree"),
                       std::to_string(reference_degree_) +
                         " is neither 1 nor 2.",
                       "Take 2.");
    for (const double size : cell_sizes_)
      if (!(size > 0. && std::isfinite(size)))
        throw EntryError(full_name("Cell sizes"),
                         text_of(size) + " m is no length.",
                         "Give positive numbers in m.");
    if (!(reference_size_ >= 0. && std::isfinite(reference_size_)))
      throw EntryError(full_name("Reference cell size"),
                       text_of(reference_size_) + " m is no length.",
                       "Give a positive number in m, or 0.");
    if (geometry.has_its_own_cells())
      {
        const std::string advice =
          "Leave it out; 'Halvings' divide the cells of the file.";
        if (!cells_.empty())
          throw EntryError(full_name("Cells"),
                           "a mesh file has its own cells.",
                           advice);
        if (!cell_sizes_.empty())
          throw EntryError(full_name("Cell sizes"),
                           "a mesh file has its own cells.",
                           advice);
        if (!reference_cells_.empty())
          throw EntryError(full_name("Reference cells"),
                           "a mesh file has its own cells.",
                           advice);
        if (reference_size_ > 0.)
          throw EntryError(full_name("Reference cell size"),
                           "a mesh file has its own cells.",
                           advice);
      }
    value_of(purpose_words(), purpose_, full_name("Purpose"));
    material_laws(MaterialLaw::linear);
    quantity();
    for (const auto &meshing : meshings(geometry))
      geometry.check(meshing);
    geometry.check(reference(geometry).fine);
  }

  template <int dim>
  std::vector<Meshing>
  TradeoffSection<dim>::meshings(const Geometry<dim> &geometry) const
  {
    const Meshing own = geometry.meshing();
    std::vector<Meshing> meshings;
    if (geometry.has_its_own_cells())
      {
        for (unsigned int i = 0; i <= n_halvings_; ++i)
          meshings.push_back({own.cells, {}, own.refinements + i});
        return meshings;
      }
    auto kinds = cells_.empty()
                   ? std::vector<CellKind>{own.cells}
                   : values_of(cell_kind_words(), cells_, full_name("Cells"));
    for (const CellKind kind : kinds)
      check_dimension(kind, own.cells, "Cells");
    std::vector<std::vector<double>> sizes;
    for (const double size : cell_sizes_)
      sizes.push_back({size});
    if (sizes.empty())
      sizes.push_back(own.cell_size);
    // As geometry files without one have it.
    if (sizes.front().empty())
      sizes.front() = {default_cell_size};
    for (const CellKind kind : kinds)
      {
        std::vector<Meshing> of_kind;
        for (const auto &size : sizes)
          for (unsigned int i = 0; i <= n_halvings_; ++i)
            {
              const auto halved = scaled(size, std::pow(0.5, i));
              const auto is_it  = [&](const Meshing &other) {
                return other.cell_size == halved;
              };
              if (std::none_of(of_kind.begin(), of_kind.end(), is_it))
                of_kind.push_back({kind, halved, own.refinements});
            }
        std::stable_sort(of_kind.begin(),
                         of_kind.end(),
                         [](const Meshing &a, const Meshing &b) {
                           return smallest(a.cell_size) > smallest(b.cell_size);
                         });
        meshings.insert(meshings.end(), of_kind.begin(), of_kind.end());
      }
    return meshings;
  }

  template <int dim>
  typename TradeoffSection<dim>::ReferenceMeshings
  TradeoffSection<dim>::reference(const Geometry<dim> &geometry) const
  {
    const auto all = meshings(geometry);
    if (geometry.has_its_own_cells())
      {
        Meshing fine     = all.back();
        fine.refinements = reference_degree_ == 1
                             ? fine.refinements + 1
                             : std::max(fine.refinements, 1u);
        Meshing coarse   = fine;
        --coarse.refinements;
        return {fine, coarse};
      }
    Meshing finest = all.front();
    for (const auto &meshing : all)
      if (smallest(meshing.cell_size) < smallest(finest.cell_size))
        finest = meshing;
    Meshing fine = finest;
    fine.cells   = reference_cells_.empty()
                     ? all.front().cells
                     : value_of(cell_kind_words(),
                              reference_cells_,
                              full_name("Reference cells"));
    check_dimension(fine.cells, finest.cells, "Reference cells");
    if (reference_degree_ == 1)
      fine.cell_size = scaled(fine.cell_size, 0.5);
    if (reference_size_ > 0.)
      {
        const double largest =
          smallest(finest.cell_size) * (reference_degree_ == 1 ? 0.75 : 1.);
        if (reference_size_ > largest * (1. + 1e-9))
          throw EntryError(full_name("Reference cell size"),
                           text_of(reference_size_) +
                             " m is no finer than cells of " +
                             text_of(smallest(finest.cell_size)) +
                             " m, which are to be measured.",
                           "Give at most " + text_of(largest) + ", or 0.");
        fine.cell_size = {reference_size_};
      }
    Meshing coarse   = fine;
    coarse.cell_size = scaled(fine.cell_size, 2.);
    return {fine, coarse};
  }

  template <int dim>
  unsigned int
  TradeoffSection<dim>::reference_degree() const
  {
    return reference_degree_;
  }

  template <int dim>
  std::vector<MaterialLaw>
  TradeoffSection<dim>::material_laws(const MaterialLaw otherwise) const
  {
    if (laws_.empty())
      return {otherwise};
    return values_of(material_law_words(), laws_, full_name("Material laws"));
  }

  template <int dim>
  Demand
  TradeoffSection<dim>::demand(const double time_step) const
  {
    return {accuracy_,
            budget_,
            value_of(purpose_words(), purpose_, full_name("Purpose")),
            time_step};
  }

  template <int dim>
  std::optional<QuantityStatement>
  TradeoffSection<dim>::quantity() const
  {
    if (quantity_.empty())
      return {};
    return parse_quantity(quantity_, dim, full_name("Quantity"));
  }

  template <int dim>
  unsigned int
  TradeoffSection<dim>::n_repetitions() const
  {
    return n_repetitions_;
  }

  template class TradeoffSection<2>;
  template class TradeoffSection<3>;
} // namespace springfit
