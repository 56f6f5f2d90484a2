#ifndef springfit_response_model_words_h
#define springfit_response_model_words_h

#include <springfit/reference/material_law.h>
#include <springfit/response/model.h>
#include <springfit/springs/network.h>

#include <string>

namespace springfit
{
  // How models are named in errors, and what helps when one of them fails.

  /** @p is_surface: of cells of a lower dimension in space. */
  ModelWords
  words_of_finite_elements(bool is_surface);

  ModelWords
  words_of_nonlinear_finite_elements(MaterialLaw law);

  /** @p fit is the name of the network's. */
  ModelWords
  words_of_springs(const std::string &fit, const SpringNetwork &network);

  ModelWords
  words_of_nonlinear_springs(const std::string &fit,
                             const SpringNetwork &network);
} // namespace springfit

#endif
