#ifndef springfit_springs_volume_operator_h
#define springfit_springs_volume_operator_h

#include <springfit/springs/family.h>
#include <springfit/springs/lanes.h>
#include <springfit/springs/tangent_operator.h>
#include <springfit/springs/volume_kernel.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace springfit
{
  /**
   * The Hessian of volumes under a law that is smooth everywhere: of each, or
   * of several in lanes, the differences of places, the gradient and the law's
   * derivatives are kept. States are parameters so that the operator is as
   * local to a file as its coordinates are.
   */
  template <template <typename> class Coordinates,
            typename Law,
            typename WideState =
              typename VolumeKernel<Coordinates, Law, Lanes>::State,
            typename NarrowState =
              typename VolumeKernel<Coordinates, Law, double>::State>
  class VolumeOperator : public TangentOperator
  {
  public:
    static constexpr int n_nodes = Coordinates<double>::n_nodes;

    /** @p members must outlive the object. */
    explicit VolumeOperator(const Members &members)
      : members_(members), n_wide_(members.nodes.size() / n_nodes / n_lanes)
    {}

    /** @param state the places of the nodes */
    void
    linearise(const Eigen::MatrixXd &state) override
    {
      const Wide wide(members_);
      const Narrow narrow(members_);
      wide_.clear();
      narrow_.clear();
      std::size_t m = 0;
      for (; m < n_lanes * n_wide_; m += n_lanes)
        wide_.push_back(wide.state(m, WideLanes::gather(nodes(m), state)));
      for (; m < members_.nodes.size() / n_nodes; ++m)
        narrow_.push_back(
          narrow.state(m, NarrowLanes::gather(nodes(m), state)));
    }

    void
    add_product(const Eigen::MatrixXd &u,
                Eigen::MatrixXd &product) const override
    {
      std::size_t m = 0;
      for (const auto &state : wide_)
        {
          WideLanes::scatter(nodes(m),
                             Wide::product(state,
                                           WideLanes::gather(nodes(m), u)),
                             product);
          m += n_lanes;
        }
      for (const auto &state : narrow_)
        {
          NarrowLanes::scatter(
            nodes(m),
            Narrow::product(state, NarrowLanes::gather(nodes(m), u)),
            product);
          ++m;
        }
    }

  private:
    using Wide        = VolumeKernel<Coordinates, Law, Lanes>;
    using Narrow      = VolumeKernel<Coordinates, Law, double>;
    using WideLanes   = VolumeLanes<Coordinates, Lanes>;
    using NarrowLanes = VolumeLanes<Coordinates, double>;

    const unsigned int *
    nodes(const std::size_t m) const
    {
      return members_.nodes.data() + n_nodes * m;
    }

    const Members &members_;
    const std::size_t n_wide_;
    std::vector<WideState> wide_;
    std::vector<NarrowState> narrow_;
  };
} // namespace springfit

#endif
