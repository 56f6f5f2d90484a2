#ifndef springfit_studies_stability_judge_h
#define springfit_studies_stability_judge_h

#include <springfit/core/session.h>
#include <springfit/output/stability_table.h>
#include <springfit/response/statics.h>
#include <springfit/studies/judged_body.h>
#include <springfit/studies/scene.h>
#include <springfit/studies/stability_section.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** What a row of the study is of. */
  struct JudgedModel
  {
    /** Position in FitSection::rows(); nothing: the finite elements. */
    std::optional<std::size_t> fit;

    Kinematics kinematics;

    /** Of a motion with a given step. */
    std::optional<Integrator> integrator;
  };


  /**
   * The verdicts of a study of stability. What a point of the axes needs (mesh,
   * materials, loads, fits) is kept until another one is asked for.
   */
  template <int dim, int spacedim>
  class StabilityJudge
  {
  public:
    /** All must outlive the object. */
    StabilityJudge(const Scene<spacedim> &scene,
                   const StabilitySettings &settings,
                   Session &session);

    /** What there is to judge at a point: motions where it has a time step. */
    std::vector<JudgedModel>
    models(const Variation &variation) const;

    /** What a row says of itself before it is judged. */
    StabilityRow
    blank_row(const Variation &variation, const JudgedModel &model) const;

    /** What a model cannot do is in the row, and not thrown. */
    StabilityRow
    judge(const Variation &variation, const JudgedModel &model);

  private:
    /** A fit at a point: a network, or why there is none. */
    struct Attempt
    {
      std::optional<CalibratedNetwork> network;
      std::string failure;
    };

    /** Make the setting that of a point. */
    void
    set(const Variation &variation);

    const Scene<spacedim> &scene_;
    const StabilitySettings &settings_;
    Session &session_;
    const CellKind kind_;
    std::unique_ptr<const StabilitySetting<dim, spacedim>> setting_;
    std::map<std::size_t, Attempt> fits_; // of the setting
  };
} // namespace springfit

#endif
