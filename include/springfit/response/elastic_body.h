#ifndef springfit_response_elastic_body_h
#define springfit_response_elastic_body_h

#include <springfit/core/energy_term.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  /**
   * What both models are to statics: an elastic energy that is a sum of terms,
   * each of which depends on the displacements of a few nodes.
   */
  class ElasticBody
  {
  public:
    virtual ~ElasticBody() = default;

    virtual unsigned int
    n_terms() const = 0;

    /** A node of a term, always the same one: it says which rank has it. */
    virtual unsigned int
    first_node(unsigned int term) const = 0;

    /**
     * A term at @p displacement (m, dim x n_nodes of the body), or nothing
     * where it has no finite energy or derivative.
     */
    virtual std::optional<EnergyTerm>
    evaluate(unsigned int term, const Eigen::MatrixXd &displacement) const = 0;
  };
} // namespace springfit

#endif
