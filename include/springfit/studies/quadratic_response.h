#ifndef springfit_studies_quadratic_response_h
#define springfit_studies_quadratic_response_h

#include <springfit/core/session.h>
#include <springfit/response/load_case.h>
#include <springfit/studies/responses.h>
#include <springfit/studies/scene.h>

#include <vector>

namespace springfit
{
  /**
   * The equilibria of finite elements of degree 2 on the scene's mesh under the
   * loads of @p results, at the vertices alone: displacements are spacedim x
   * n_vertices, and there are no reactions.
   *
   * @param loading as Loads::resolve() made it, whose canned cases are not
   * scaled
   */
  template <int dim, int spacedim>
  std::vector<Equilibrium>
  quadratic_responses(const Scene<spacedim> &scene,
                      const Loading &loading,
                      const std::vector<CaseResult> &results,
                      Session &session);
} // namespace springfit

#endif
