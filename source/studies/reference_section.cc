#include <springfit/core/words.h>
#include <springfit/studies/reference_section.h>

namespace springfit
{
  namespace
  {
    const WordTable<unsigned int> &
    degree_words()
    {
      static const WordTable<unsigned int> table = {{1, "linear elements"},
                                                    {2, "quadratic elements"}};
      return table;
    }
  } // namespace

  template <int dim>
  ReferenceSection<dim>::ReferenceSection()
    : dealii::ParameterAcceptor("Response")
  {
    add_parameter(
      "Reference",
      word_,
      "From which finite elements a comparison measures distances: " +
        join(words_of(degree_words()), " or ") +
        " (no unit). The linear ones (P1, Q1) are what the springs "
        "are fitted to, and lock where they bend or hardly change "
        "their volume. Quadratic ones (P2, Q2) on the same mesh are "
        "a judge of both.");
  }

  template <int dim>
  unsigned int
  ReferenceSection<dim>::degree() const
  {
    return value_of(degree_words(), word_, "Response/Reference");
  }

  template class ReferenceSection<2>;
  template class ReferenceSection<3>;
} // namespace springfit
