#ifndef springfit_studies_adapt_section_h
#define springfit_studies_adapt_section_h

#include <springfit/studies/quantity.h>

#include <deal.II/base/parameter_acceptor.h>

#include <optional>
#include <string>

namespace springfit
{
  /** How the models of single cells are chosen. */
  struct AdaptSettings
  {
    double accuracy; // of the whole, per cent of what the exact model has
    std::optional<QuantityStatement> quantity; // else e_rms
    unsigned int n_cycles;
    bool has_finite_elements; // as the last model
    bool knows_true_error;
  };


  /** The section "Adapt". */
  template <int dim>
  class AdaptSection : public dealii::ParameterAcceptor
  {
  public:
    AdaptSection();

    /** @throws EntryError when a value is wrong. */
    AdaptSettings
    settings() const;

  private:
    double accuracy_ = 1.;
    std::string quantity_;
    unsigned int n_cycles_    = 10;
    bool has_finite_elements_ = false;
    bool knows_true_error_    = false;
  };
} // namespace springfit

#endif
