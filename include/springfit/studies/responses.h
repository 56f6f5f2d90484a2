#ifndef springfit_studies_responses_h
#define springfit_studies_responses_h

#include <springfit/core/session.h>
#include <springfit/response/load_case.h>
#include <springfit/response/model.h>
#include <springfit/response/statics.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/scene.h>

#include <cstddef>
#include <vector>

namespace springfit
{
  /** How a network of springs answers a load case. */
  struct NetworkResponse
  {
    std::size_t network; // position in the scene's networks
    Kinematics kinematics;
    Equilibrium equilibrium;
  };

  /**
   * A load case, scaled, with the response of every model to it. Without a
   * response of the finite elements to the whole load there is none of the
   * springs.
   */
  struct CaseResult
  {
    LoadCase load_case;

    /** Of the linear finite elements, spacedim x n_nodes, m. */
    Eigen::MatrixXd linear_displacement;

    Equilibrium reference;
    std::vector<NetworkResponse> networks;
  };

  inline bool
  is_complete(const Equilibrium &equilibrium)
  {
    return equilibrium.failure.empty();
  }

  /**
   * Scale every canned load case to the deformation that the user asks of the
   * linear finite elements, and find the equilibrium of the finite elements
   * under it. The networks of @p calibrated are not used. What does not reach
   * the whole load is warned of.
   */
  template <int dim, int spacedim>
  std::vector<CaseResult>
  find_references(const Scene<spacedim> &scene,
                  const CalibratedScene<dim, spacedim> &calibrated,
                  const Loading &loading,
                  Session &session);

  /**
   * The factor of a canned load such that the linear finite elements deform
   * as asked; 1 of another one.
   *
   * @param displacement theirs under the load as it is, m
   * @throws EntryError when it moves nothing.
   */
  double
  scale_of(const LoadCase &load_case,
           const Loading &loading,
           const Eigen::MatrixXd &displacement);

  /**
   * The scaling alone, of the cases of @p loading. Collective.
   *
   * @throws EntryError when a load moves nothing.
   */
  template <int dim, int spacedim>
  void
  scale_canned_cases(const Scene<spacedim> &scene,
                     const CalibratedScene<dim, spacedim> &calibrated,
                     Session &session,
                     Loading &loading);

  /** Then that of all networks. */
  template <int dim, int spacedim>
  void
  find_responses(const Scene<spacedim> &scene,
                 const CalibratedScene<dim, spacedim> &calibrated,
                 const Loading &loading,
                 std::vector<CaseResult> &results,
                 Session &session);
} // namespace springfit

#endif
