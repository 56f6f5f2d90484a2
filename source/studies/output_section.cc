#include <springfit/studies/output_section.h>

namespace springfit
{
  template <int dim>
  OutputSection<dim>::OutputSection() : dealii::ParameterAcceptor("Output")
  {
    add_parameter("Export",
                  formats_word_,
                  "Programs for which scenes with the networks are written "
                  "besides, a list of " +
                    join(words_of(export_format_words())) +
                    " (no unit); empty: none. Each scene has the nodes, their "
                    "masses, the springs with their rest lengths, what is held "
                    "and the forces of a load case, and runs as it is. What a "
                    "program cannot hold is refused by name; numpy holds all.");
    add_parameter("SOFA version",
                  sofa_version_word_,
                  "The oldest SOFA that its scenes are for, " +
                    join(words_of(sofa_version_words()), " or ") +
                    " (no unit): components have other names from one to the "
                    "next, and volumes of tetrahedra came with 24.12.");
  }

  template <int dim>
  std::vector<ExportFormat>
  OutputSection<dim>::formats() const
  {
    if (formats_word_.empty())
      return {};
    return values_of(export_format_words(), formats_word_, "Output/Export");
  }

  template <int dim>
  SofaVersion
  OutputSection<dim>::sofa_version() const
  {
    return value_of(sofa_version_words(),
                    sofa_version_word_,
                    "Output/SOFA version");
  }

  template class OutputSection<2>;
  template class OutputSection<3>;
} // namespace springfit
