#include <springfit/fit/cell/baudet.h>
#include <springfit/fit/cell/golec.h>
#include <springfit/fit/cell/lloyd.h>
#include <springfit/fit/methods.h>

#include <algorithm>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    // Their assumptions, with the same arguments for all of them.

    using Assumptions = std::vector<std::string>;

    Assumptions
    none_unmet(const Eigen::MatrixXd &,
               const CellKind,
               const IsotropicMaterial &)
    {
      return {};
    }

    Assumptions
    golec_unmet(const Eigen::MatrixXd &,
                const CellKind,
                const IsotropicMaterial &material)
    {
      return golec_assumptions(material);
    }


    struct Description
    {
      Method method;
      std::string word;
      std::vector<CellKind> cells;
      std::vector<Enrichment> enrichments;

      bool has_formulas;

      Assumptions (*unmet)(const Eigen::MatrixXd &,
                           CellKind,
                           const IsotropicMaterial &);
    };

    /** In the order in which they are offered. */
    const std::vector<Description> &
    descriptions()
    {
      const auto triangle      = CellKind::triangle;
      const auto quadrilateral = CellKind::quadrilateral;
      const auto tetrahedron   = CellKind::tetrahedron;
      const auto hexahedron    = CellKind::hexahedron;
      const auto all      = {triangle, quadrilateral, tetrahedron, hexahedron};
      const auto none     = Enrichment::none;
      const auto volume   = Enrichment::volume;
      const auto angles   = Enrichment::angles;
      const auto coupling = Enrichment::coupling;
      const auto every    = {none, volume, angles, coupling};
      static const std::vector<Description> table = {
        {Method::block, "block", all, every, false, &none_unmet},
        {Method::frobenius, "frobenius", all, every, false, &none_unmet},
        {Method::spectral, "spectral", all, every, false, &none_unmet},
        {Method::consistent, "consistent", all, every, false, &none_unmet},
        {Method::compliance, "compliance", all, every, false, &none_unmet},
        {Method::stable_neo_hookean,
         "stable neo-hookean",
         all,
         {volume, Enrichment::point_volumes},
         true,
         &none_unmet},
        {Method::gelder,
         "gelder",
         {triangle, tetrahedron},
         {none},
         true,
         &none_unmet},
        {Method::lloyd,
         "lloyd",
         {triangle, quadrilateral, tetrahedron},
         {none},
         true,
         &lloyd_assumptions},
        {Method::baudet,
         "baudet",
         {quadrilateral, hexahedron},
         {none, coupling},
         true,
         &baudet_assumptions},
        {Method::delingette,
         "delingette",
         {triangle},
         {none, coupling},
         true,
         &none_unmet},
        {Method::golec, "golec", {tetrahedron}, {volume}, true, &golec_unmet}};
      return table;
    }

    std::string
    underscored(std::string words)
    {
      std::replace_if(
        words.begin(),
        words.end(),
        [](const char letter) { return letter == ' ' || letter == '-'; },
        '_');
      return words;
    }

    const Description &
    description(const Method method)
    {
      for (const auto &entry : descriptions())
        if (entry.method == method)
          return entry;
      throw std::logic_error("a fit has no description");
    }
  } // namespace


  const WordTable<Method> &
  method_words()
  {
    static const WordTable<Method> table = [] {
      WordTable<Method> words;
      for (const auto &entry : descriptions())
        words.emplace_back(entry.method, entry.word);
      return words;
    }();
    return table;
  }


  const std::vector<CellKind> &
  cells_of(const Method method)
  {
    return description(method).cells;
  }


  const std::vector<Enrichment> &
  enrichments_of(const Method method)
  {
    return description(method).enrichments;
  }


  bool
  has_states(const Method method,
             const Enrichment enrichment,
             const CellKind kind)
  {
    return method == Method::frobenius &&
           (enrichment != Enrichment::coupling || is_simplex(kind));
  }


  bool
  has_formulas(const Method method)
  {
    return description(method).has_formulas;
  }


  bool
  is_finite_element(const Method method)
  {
    return method == Method::stable_neo_hookean;
  }


  std::string
  name_of(const Method method)
  {
    return underscored(description(method).word);
  }


  std::string
  name_of(const Enrichment enrichment)
  {
    return underscored(word_of(enrichment_words(), enrichment));
  }


  std::string
  name_of(const std::string &fit, const std::string &enrichment)
  {
    return enrichment == name_of(Enrichment::none) ? fit
                                                   : fit + '_' + enrichment;
  }


  std::vector<std::string>
  unmet_assumptions(const Method method,
                    const Eigen::MatrixXd &points,
                    const CellKind kind,
                    const IsotropicMaterial &material)
  {
    return description(method).unmet(points, kind, material);
  }
} // namespace springfit
