#ifndef springfit_studies_scene_h
#define springfit_studies_scene_h

#include <springfit/calibration/fit_section.h>
#include <springfit/mesh/geometry.h>
#include <springfit/motion/contact_section.h>
#include <springfit/motion/dynamics.h>
#include <springfit/reference/material.h>
#include <springfit/response/loads.h>
#include <springfit/response/statics.h>
#include <springfit/studies/adapt_section.h>
#include <springfit/studies/output_section.h>
#include <springfit/studies/reference_section.h>
#include <springfit/studies/stability_section.h>
#include <springfit/studies/sweep_range.h>
#include <springfit/studies/tradeoff_section.h>

#include <filesystem>

namespace springfit
{
  /**
   * Everything that a parameter file describes: the steps of a study in the
   * order of the data flow, each owning a section of the file.
   */
  template <int dim>
  struct Scene
  {
    /** The parameter file's folder: where relative mesh names start. */
    std::filesystem::path folder;

    Geometry<dim> geometry;
    Material<dim> material;
    FitSection<dim> fit;
    Loads<dim> loads;
    Statics<dim> statics;
    ReferenceSection<dim> reference;
    Dynamics<dim> dynamics;
    Contact<dim> contact;
    SweepRange<dim> sweep_range;
    TradeoffSection<dim> tradeoff;
    AdaptSection<dim> adapt;
    StabilitySection<dim> stability;
    OutputSection<dim> output;
  };
} // namespace springfit

#endif
