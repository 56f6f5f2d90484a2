#include <springfit/response/convex_tangent.h>
#include <springfit/springs/tangent_matrix.h>

#include <optional>

namespace springfit
{
  namespace
  {
    class ConvexOperator : public TangentOperator
    {
    public:
      explicit ConvexOperator(const ElasticBody &body) : body_(body)
      {}

      void
      linearise(const Eigen::MatrixXd &state) override
      {
        if (!tangent_)
          {
            NodePattern pattern(state.cols());
            body_.add_to_pattern(pattern);
            tangent_.emplace(state.rows(), pattern);
          }
        tangent_->set_zero();
        body_.add_convex_tangent(state, *tangent_);
      }

      void
      add_product(const Eigen::MatrixXd &u,
                  Eigen::MatrixXd &product) const override
      {
        product.reshaped() += tangent_->matrix() * u.reshaped();
      }

    private:
      const ElasticBody &body_;
      std::optional<TangentMatrix> tangent_; // none before the first state
    };
  } // namespace

  std::unique_ptr<TangentOperator>
  convex_tangent_operator(const ElasticBody &body)
  {
    return std::make_unique<ConvexOperator>(body);
  }
} // namespace springfit
