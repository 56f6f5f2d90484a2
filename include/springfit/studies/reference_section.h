#ifndef springfit_studies_reference_section_h
#define springfit_studies_reference_section_h

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace springfit
{
  /**
   * What the entry 'Reference' of section Response says: from which finite
   * elements distances are measured.
   */
  template <int dim>
  class ReferenceSection : public dealii::ParameterAcceptor
  {
  public:
    ReferenceSection();

    /**
     * 1: those whose stiffness is fitted, or 2.
     *
     * @throws EntryError
     */
    unsigned int
    degree() const;

  private:
    std::string word_ = "linear elements";
  };
} // namespace springfit

#endif
