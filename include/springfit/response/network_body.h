#ifndef springfit_response_network_body_h
#define springfit_response_network_body_h

#include <springfit/response/elastic_body.h>
#include <springfit/springs/network.h>

namespace springfit
{
  /** A network of springs as a body; see network_terms.h. */
  template <int dim>
  class NetworkBody : public ElasticBody
  {
  public:
    /** @p network must outlive the object. */
    explicit NetworkBody(const SpringNetwork &network);

    unsigned int
    n_terms() const override;

    unsigned int
    first_node(unsigned int term) const override;

    std::optional<EnergyTerm>
    evaluate(unsigned int term,
             const Eigen::MatrixXd &displacement) const override;

  private:
    const SpringNetwork &network_;
  };
} // namespace springfit

#endif
