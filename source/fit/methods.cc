#include <springfit/fit/cell/baudet.h>
#include <springfit/fit/cell/block.h>
#include <springfit/fit/cell/cell_compliance.h>
#include <springfit/fit/cell/consistent.h>
#include <springfit/fit/cell/delingette.h>
#include <springfit/fit/cell/frobenius.h>
#include <springfit/fit/cell/gelder.h>
#include <springfit/fit/cell/golec.h>
#include <springfit/fit/cell/lloyd.h>
#include <springfit/fit/cell/spectral_fit.h>
#include <springfit/fit/cell/stable_neo_hookean.h>
#include <springfit/fit/methods.h>
#include <springfit/fit/object/compliance.h>
#include <springfit/fit/object/object_fit.h>

#include <algorithm>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    // Fits of whole objects, with the same arguments for all of them.

    Eigen::VectorXd
    matrix_of_object(const ObjectProblem &problem,
                     const Eigen::MatrixXd &,
                     const Eigen::VectorXd &)
    {
      return fit_matrix(problem);
    }

    Eigen::VectorXd
    displacements_of_object(const ObjectProblem &problem,
                            const Eigen::MatrixXd &fields,
                            const Eigen::VectorXd &prior)
    {
      // With less, springs of tetrahedra vanish until single nodes bulge or are
      // loose; with 0.3 errors are up to a quarter larger.
      constexpr double prior_weight = 0.2;
      return fit_displacements(problem, fields, prior, prior_weight);
    }

    Eigen::VectorXd
    compliance_of_object(const ObjectProblem &problem,
                         const Eigen::MatrixXd &,
                         const Eigen::VectorXd &)
    {
      return fit_compliance(problem);
    }


    const auto triangle      = CellKind::triangle;
    const auto quadrilateral = CellKind::quadrilateral;
    const auto tetrahedron   = CellKind::tetrahedron;
    const auto hexahedron    = CellKind::hexahedron;

    const auto none          = Enrichment::none;
    const auto volume        = Enrichment::volume;
    const auto point_volumes = Enrichment::point_volumes;
    const auto angles        = Enrichment::angles;
    const auto coupling      = Enrichment::coupling;

    /** In the order in which they are offered. */
    const std::vector<Method> &
    methods()
    {
      const auto all      = {triangle, quadrilateral, tetrahedron, hexahedron};
      const auto every    = {none, volume, angles, coupling};
      const auto formulas = Feature::formulas;
      static const std::vector<Method> table = {
        {"block", all, every, {}, &fit_block},
        {"frobenius",
         all,
         every,
         {Feature::states},
         &fit_frobenius,
         &matrix_of_object},
        {"spectral", all, every, {}, &fit_spectral},
        {"consistent",
         all,
         every,
         {Feature::norm, Feature::fields},
         &fit_consistent,
         &displacements_of_object},
        {"compliance", all, every, {}, &fit_compliance, &compliance_of_object},
        {"stable neo-hookean",
         all,
         {volume, point_volumes},
         {formulas, Feature::finite_element},
         &fit_stable_neo_hookean},
        {"gelder", {triangle, tetrahedron}, {none}, {formulas}, &fit_gelder},
        {"lloyd",
         {triangle, quadrilateral, tetrahedron},
         {none},
         {formulas},
         &fit_lloyd,
         nullptr,
         &lloyd_assumptions},
        {"baudet",
         {quadrilateral, hexahedron},
         {none, coupling},
         {formulas},
         &fit_baudet,
         nullptr,
         &baudet_assumptions},
        {"delingette",
         {triangle},
         {none, coupling},
         {formulas},
         &fit_delingette},
        {"golec",
         {tetrahedron},
         {volume},
         {formulas},
         &fit_golec,
         nullptr,
         &golec_assumptions}};
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

    template <typename Value>
    bool
    contains(const std::vector<Value> &values, const Value value)
    {
      return std::find(values.begin(), values.end(), value) != values.end();
    }
  } // namespace


  const WordTable<const Method *> &
  method_words()
  {
    static const WordTable<const Method *> table = [] {
      WordTable<const Method *> words;
      for (const auto &method : methods())
        words.emplace_back(&method, method.word);
      return words;
    }();
    return table;
  }


  const Method &
  method_named(const std::string &word)
  {
    for (const auto &method : methods())
      if (method.word == word)
        return method;
    throw std::logic_error("there is no fit '" + word + "'");
  }


  bool
  has(const Method &method, const Feature feature)
  {
    return contains(method.features, feature);
  }


  bool
  suits(const Method &method, const CellKind kind)
  {
    return contains(method.cells, kind);
  }


  bool
  suits(const Method &method, const Enrichment enrichment)
  {
    return contains(method.enrichments, enrichment);
  }


  bool
  has_states(const Method &method,
             const Enrichment enrichment,
             const CellKind kind)
  {
    return has(method, Feature::states) &&
           (enrichment != Enrichment::coupling || is_simplex(kind));
  }


  std::vector<std::string>
  unmet_assumptions(const Method &method,
                    const Eigen::MatrixXd &points,
                    const CellKind kind,
                    const IsotropicMaterial &material)
  {
    if (!method.unmet_assumptions)
      return {};
    return method.unmet_assumptions(points, kind, material);
  }


  std::string
  name_of(const Method &method)
  {
    return underscored(method.word);
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
} // namespace springfit
