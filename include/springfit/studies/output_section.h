#ifndef springfit_studies_output_section_h
#define springfit_studies_output_section_h

#include <springfit/exports/formats.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace springfit
{
  /** The section "Output": into which programs the networks go. */
  template <int dim>
  class OutputSection : public dealii::ParameterAcceptor
  {
  public:
    OutputSection();

    /**
     * None where the entry is empty.
     *
     * @throws EntryError when a word is not known or given twice.
     */
    std::vector<ExportFormat>
    formats() const;

    /** @throws EntryError */
    SofaVersion
    sofa_version() const;

  private:
    std::string formats_word_;
    std::string sofa_version_word_ = "24.12";
  };
} // namespace springfit

#endif
