#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/response/boundary_parts.h>
#include <springfit/response/loaded_surface.h>
#include <springfit/response/statements.h>
#include <springfit/studies/place_in_mesh.h>
#include <springfit/studies/quantity.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace springfit
{
  namespace
  {
    const std::string of_boundary = "displacement of ",
                      at_point    = "displacement at ",
                      of_support  = "reaction of ";

    bool
    begins(const std::string &text, const std::string &beginning)
    {
      return text.compare(0, beginning.size(), beginning) == 0;
    }

    std::vector<double>
    numbers(const std::string &text, const EntryError &error)
    {
      std::vector<double> values;
      for (const auto &word : split_at_commas(text))
        {
          char *end = nullptr;
          values.push_back(std::strtod(word.c_str(), &end));
          if (end == word.c_str() || *end != '\0' ||
              !std::isfinite(values.back()))
            throw error;
        }
      return values;
    }
  } // namespace

  QuantityStatement
  parse_quantity(const std::string &text,
                 const int spacedim,
                 const std::string &entry)
  {
    const std::string components = spacedim == 2 ? "xy" : "xyz";
    const EntryError error(
      entry,
      "'" + text + "' is no quantity.",
      std::string("Write \"displacement of BOUNDARY: x\", \"displacement at ") +
        (spacedim == 2 ? "0.01, 0.02: y" : "0.01, 0.01, 0.02: z") +
        "\" or \"reaction of SUPPORT: x\".");
    const auto statements = parse_statements(text, entry);
    if (statements.size() != 1 || !statements[0].load_case.empty() ||
        statements[0].values.size() != 1 || statements[0].values[0].size() != 1)
      throw error;
    QuantityStatement quantity{};
    quantity.text           = text;
    const std::string place = statements[0].place;
    const auto component    = components.find(statements[0].values[0]);
    if (component == std::string::npos)
      throw error;
    quantity.component = component;
    if (begins(place, of_boundary))
      {
        quantity.kind  = QuantityStatement::Kind::mean_displacement;
        quantity.place = place.substr(of_boundary.size());
      }
    else if (begins(place, of_support))
      {
        quantity.kind  = QuantityStatement::Kind::reaction;
        quantity.place = place.substr(of_support.size());
      }
    else if (begins(place, at_point))
      {
        quantity.kind  = QuantityStatement::Kind::displacement;
        quantity.point = numbers(place.substr(at_point.size()), error);
        if (quantity.point.size() != std::size_t(spacedim))
          throw error;
      }
    else
      throw error;
    return quantity;
  }

  double
  value_of(const Quantity &quantity, const Equilibrium &equilibrium)
  {
    return (quantity.is_reaction ? equilibrium.reactions
                                 : equilibrium.displacement)
      .cwiseProduct(quantity.weights)
      .sum();
  }

  template <int dim, int spacedim>
  Quantity
  on_mesh(const QuantityStatement &statement,
          const Mesh<dim, spacedim> &mesh,
          const Element<dim, spacedim> &element,
          const Loading &loading,
          const std::string &entry)
  {
    Quantity quantity{statement.kind == QuantityStatement::Kind::reaction,
                      Eigen::MatrixXd::Zero(spacedim, mesh.nodes.size())};
    auto row = quantity.weights.row(statement.component);
    switch (statement.kind)
      {
          case QuantityStatement::Kind::mean_displacement: {
            auto faces = faces_of_boundaries(mesh, statement.place, entry);
            if (faces.empty())
              throw EntryError(entry,
                               "the boundary '" + statement.place +
                                 "' has no faces.",
                               "Name another one.");
            const LoadedSurface<dim, spacedim> surface(mesh,
                                                       std::move(faces),
                                                       element);
            row = (surface.shares() / surface.area()).transpose();
            break;
          }
          case QuantityStatement::Kind::displacement: {
            dealii::Point<spacedim> point;
            for (int d = 0; d < spacedim; ++d)
              point[d] = statement.point[d];
            row = place_in_mesh(point, mesh, element, entry).transpose();
            break;
          }
          case QuantityStatement::Kind::reaction: {
            std::vector<std::string> known;
            for (const auto &support : loading.supports)
              {
                known.push_back(support.name);
                if (support.name == statement.place)
                  for (unsigned int v = 0; v < mesh.nodes.size(); ++v)
                    if (support.held[spacedim * v + statement.component])
                      row[v] = 1.;
              }
            if (std::find(known.begin(), known.end(), statement.place) ==
                known.end())
              throw EntryError(entry,
                               "there is no support '" + statement.place +
                                 "'." + did_you_mean(statement.place, known),
                               "The supports are " + join(known) + '.');
            break;
          }
      }
    return quantity;
  }

  template Quantity
  on_mesh(const QuantityStatement &,
          const Mesh<2> &,
          const Element<2> &,
          const Loading &,
          const std::string &);
  template Quantity
  on_mesh(const QuantityStatement &,
          const Mesh<2, 3> &,
          const Element<2, 3> &,
          const Loading &,
          const std::string &);
  template Quantity
  on_mesh(const QuantityStatement &,
          const Mesh<3> &,
          const Element<3> &,
          const Loading &,
          const std::string &);
} // namespace springfit
