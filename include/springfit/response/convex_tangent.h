#ifndef springfit_response_convex_tangent_h
#define springfit_response_convex_tangent_h

#include <springfit/response/elastic_body.h>
#include <springfit/springs/tangent_operator.h>

#include <memory>

namespace springfit
{
  /**
   * The convex tangent of a body (see ElasticBody::add_convex_tangent) as an
   * operator whose states are displacements. The body must outlive it.
   */
  std::unique_ptr<TangentOperator>
  convex_tangent_operator(const ElasticBody &body);
} // namespace springfit

#endif
