#ifndef springfit_studies_stability_judge_h
#define springfit_studies_stability_judge_h

#include <springfit/core/session.h>
#include <springfit/output/stability_table.h>
#include <springfit/response/statics.h>
#include <springfit/studies/scene.h>
#include <springfit/studies/stability_section.h>

#include <cstddef>
#include <memory>
#include <optional>
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

    ~StabilityJudge();

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
    struct Setting;

    void
    judge_at_rest(const JudgedModel &model, StabilityRow &row);

    void
    judge_stretched(double stretch,
                    const JudgedModel &model,
                    StabilityRow &row);

    void
    judge_inverted(double edges, const JudgedModel &model, StabilityRow &row);

    void
    judge_motion(double step, const JudgedModel &model, StabilityRow &row);

    /** Make the setting that of a point. */
    void
    set(const Variation &variation);

    const Scene<spacedim> &scene_;
    const StabilitySettings &settings_;
    Session &session_;
    const CellKind kind_;
    std::unique_ptr<Setting> setting_;
  };
} // namespace springfit

#endif
