#ifndef springfit_tests_unit_fits_h
#define springfit_tests_unit_fits_h

// What the tests of the fits share.

#include <springfit/fit/cell/spectral.h>
#include <springfit/fit/fit.h>
#include <springfit/springs/network.h>

#include <string>
#include <utility>
#include <vector>

#include "cells.h"

namespace springfit::oracle
{
  inline const std::vector<Engine> all_engines = {Engine::ipopt,
                                                  Engine::barrier};

  inline FitOptions
  options_of(const Engine engine, const bool nonnegative)
  {
    FitOptions options;
    options.engine      = engine;
    options.nonnegative = nonnegative;
    return options;
  }

  /** Every method, both engines, free and k >= 0. */
  inline std::vector<std::pair<Method, FitOptions>>
  all_fits()
  {
    std::vector<std::pair<Method, FitOptions>> fits;
    for (const bool nonnegative : {false, true})
      {
        for (const Method &method :
             {method_named("block"), method_named("frobenius")})
          fits.emplace_back(method, options_of(Engine::ipopt, nonnegative));
        for (const Engine engine : all_engines)
          fits.emplace_back(method_named("spectral"),
                            options_of(engine, nonnegative));
      }
    return fits;
  }

  inline FitProblem
  regular_problem(const CellKind kind, const double nu)
  {
    return fit_problem(regular_cell(kind), kind, nu);
  }

  /** Slender cells: many of their free fits have negative springs. */
  inline FitProblem
  slender_problem(const CellKind kind, Random &random)
  {
    Eigen::MatrixXd x = random_cell(kind, random);
    x.row(0) *= 3.;
    return fit_problem(x, kind, random(0., 0.45));
  }

  /** The constants of the families of a word; none if a model lacks them. */
  inline Eigen::VectorXd
  constants_of(const CellModel &model, const std::string &word)
  {
    Families families;
    for (const auto &family : model.families)
      if (family.kind->word() == word)
        families.push_back(family);
    return springfit::constants_of(families);
  }

  /** What a model has between two vertices. */
  inline CellModel
  springs_of(const CellModel &model)
  {
    CellModel springs;
    for (const auto &family : model.families)
      if (family.kind->word() == "springs")
        springs.families.push_back(family);
    return springs;
  }

  /** The springs of a cell alone; @p n_nonnegative of them k >= 0. */
  inline SpectralProblem
  spectral_problem(const FitProblem &problem, const Eigen::Index n_nonnegative)
  {
    return make_spectral_problem(problem.points,
                                 problem.gradients,
                                 problem.stiffness,
                                 n_nonnegative);
  }
} // namespace springfit::oracle

#endif
