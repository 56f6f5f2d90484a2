#include <springfit/response/model_words.h>

namespace springfit
{
  namespace
  {
    /** What bears cells turned inside out, where the law in force does not. */
    std::string
    words_of_inversion(const MaterialLaw law)
    {
      if (law == MaterialLaw::stable_neo_hookean)
        return ", or another 'Material law' in section Response.";
      return ". The 'Material law' in section Response is " +
             word_of(material_law_words(), law) +
             ", which cannot go on where cells turn inside out; " +
             word_of(material_law_words(), MaterialLaw::stable_neo_hookean) +
             " does.";
    }
  } // namespace

  ModelWords
  words_of_finite_elements(const bool is_surface)
  {
    return {"the finite element model",
            std::string("A part of the object can move without resistance: "
                        "check the mesh and the supports.") +
              (is_surface ? " A flat surface at rest has no resistance "
                            "across itself; it moves under 'Study = "
                            "dynamics'. Cells that are divided or of degree 2 "
                            "are such surfaces: 'Refinements = 0', in section "
                            "Tradeoff 'Halvings = 0' and 'Reference degree = "
                            "1'."
                          : "")};
  }

  ModelWords
  words_of_nonlinear_finite_elements(const MaterialLaw law)
  {
    return {"the nonlinear finite element model",
            "Set a smaller 'Deformation' in section Loads, or smaller loads of "
            "your own" +
              words_of_inversion(law)};
  }

  ModelWords
  words_of_springs(const std::string &fit, const SpringNetwork &network)
  {
    return {"the springs of the fit '" + fit + "'",
            n_negative(network.families) > 0
              ? "Springs of negative stiffness may cancel the others: set "
                "'Nonnegative = true' in section Fit, or 'Solver = direct' in "
                "section Response, or ask for another fit."
              : "The fit may have made a mechanism, in which nodes move "
                "without resistance: set another 'Enrichment' or another fit "
                "in section Fit, or make the mesh finer; or set 'Solver = "
                "direct' in section Response."};
  }

  ModelWords
  words_of_nonlinear_springs(const std::string &fit,
                             const SpringNetwork &network)
  {
    if (are_under_tension(network.families))
      return {"the springs of the fit '" + fit + "' with nonlinear kinematics",
              std::string(
                "Set a smaller 'Deformation' in section Loads, or smaller "
                "loads of your own") +
                (bear_inversion(network.families)
                   ? "."
                   : ". The 'Volume law' in section Fit is logarithmic, "
                     "which cannot go on where cells turn inside out; "
                     "quadratic does, with the 'Material law' stable "
                     "neo-hookean in section Response.")};

    const unsigned int n = n_negative(network.families);
    return {"the springs of the fit '" + fit + "' with nonlinear kinematics",
            "Set a smaller 'Deformation' in section Loads, or smaller loads of "
            "your own" +
              (n > 0 ? ", or 'Nonnegative = true' in section Fit: " +
                         std::to_string(n) + " springs are negative."
                     : ".")};
  }
} // namespace springfit
