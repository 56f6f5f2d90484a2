#ifndef springfit_studies_judged_body_h
#define springfit_studies_judged_body_h

#include <springfit/output/stability_table.h>
#include <springfit/response/discretization.h>
#include <springfit/response/elastic_body.h>
#include <springfit/response/load_case.h>
#include <springfit/response/model.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/moving_models.h>
#include <springfit/studies/stability_section.h>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace springfit
{
  /** What all models have in common at a point of a study of stability. */
  template <int dim, int spacedim>
  struct StabilitySetting
  {
    Variation body; // without axes of states and motions
    CalibratedScene<dim, spacedim> varied;
    Eigen::MatrixXd nodes; // at rest, spacedim x n_nodes, m
    Loading loading;       // canned cases scaled by linear finite elements
    std::unique_ptr<const Discretization<spacedim>> discretization;

    /** Of the finite elements of the scene's law under each load case. */
    std::vector<Equilibrium> reference;

    /** Why there are none, or not under the whole load. */
    std::string failure_of_reference;

    /** Whether canned cases have their loads. */
    bool is_scaled;
  };

  /**
   * @param body a point without axes of states and motions
   * @throws InputError as varied_scene() and Loads::resolve() do.
   */
  template <int dim, int spacedim>
  std::unique_ptr<StabilitySetting<dim, spacedim>>
  make_stability_setting(const Scene<spacedim> &scene,
                         const Variation &body,
                         Session &session);

  /** A model there. */
  template <int dim, int spacedim>
  struct JudgedBody
  {
    const Scene<spacedim> &scene;
    const StabilitySetting<dim, spacedim> &setting;
    const CalibratedNetwork *network; // none: the finite elements
    Kinematics kinematics;
  };

  template <int dim, int spacedim>
  std::unique_ptr<BodyOfMembers>
  members_of(const JudgedBody<dim, spacedim> &body);

  /** Its statics on unknowns of any supports, which must outlive the model. */
  template <int dim, int spacedim>
  std::unique_ptr<Model>
  statics_of(const JudgedBody<dim, spacedim> &body,
             const Discretization<spacedim> &discretization);

  /** Held as in the scene, with one load at all times. */
  template <int dim, int spacedim>
  Excitation
  steady(const JudgedBody<dim, spacedim> &body, const NodalLoad &load);

  /** Moves from rest under @p excitation, which must outlive it. */
  template <int dim, int spacedim>
  std::unique_ptr<MovingModel>
  moving(const JudgedBody<dim, spacedim> &body,
         const DynamicsSettings<spacedim> &settings,
         Excitation &excitation);

  /** There is no verdict: say why. */
  void
  refuse(const std::string &why, StabilityRow &row);
} // namespace springfit

#endif
