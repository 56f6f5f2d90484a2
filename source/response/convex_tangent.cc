#include <springfit/response/convex_tangent.h>
#include <springfit/springs/assembled_operator.h>

namespace springfit
{
  std::unique_ptr<TangentOperator>
  convex_tangent_operator(const ElasticBody &body)
  {
    return std::make_unique<AssembledOperator>(
      [&body](NodePattern &pattern) { body.add_to_pattern(pattern); },
      [&body](const Eigen::MatrixXd &displacement, TangentMatrix &tangent) {
        body.add_convex_tangent(displacement, tangent);
      });
  }
} // namespace springfit
