#include <springfit/springs/angle.h>
#include <springfit/springs/angles.h>
#include <springfit/springs/kernel_kind.h>

#include <limits>
#include <utility>

namespace springfit
{
  namespace
  {
    template <int dim_>
    class AngleKernel
    {
    public:
      static constexpr int dim          = dim_;
      static constexpr int n_nodes      = 3;
      static constexpr bool has_hessian = false;
      using Places                      = Eigen::Matrix<double, dim, 3>;

      explicit AngleKernel(const Members &members)
        : stiffness_(members.columns[0].data())
        , rest_angle_(members.columns[1].data())
      {}

      bool
      is_smooth(std::size_t, const Places &x) const
      {
        return !is_degenerate_angle<dim>(u_of(x), v_of(x));
      }

      double
      energy(const std::size_t m, const Places &x) const
      {
        if (!is_smooth(m, x))
          return std::numeric_limits<double>::infinity();
        const double q = elongation(m, x);
        return 0.5 * stiffness_[m] * q * q;
      }

      Places
      gradient(const std::size_t m, const Places &x) const
      {
        const Vector<3 *dim> g = angle_gradient<dim>(u_of(x), v_of(x));
        return stiffness_[m] * elongation(m, x) * as_places(g);
      }

      Places
      product(const std::size_t m, const Places &x, const Places &u) const
      {
        const Vector<3 *dim> g      = angle_gradient<dim>(u_of(x), v_of(x));
        const Vector<3 *dim> w      = u.reshaped();
        const Vector<3 *dim> curved = angle_hessian<dim>(u_of(x), v_of(x)) * w;
        return stiffness_[m] *
               as_places(g.dot(w) * g + elongation(m, x) * curved);
      }

    private:
      static Vector<dim>
      u_of(const Places &x)
      {
        return x.col(0) - x.col(1);
      }

      static Vector<dim>
      v_of(const Places &x)
      {
        return x.col(2) - x.col(1);
      }

      static Places
      as_places(const Vector<3 * dim> &flat)
      {
        return Eigen::Map<const Places>(flat.data());
      }

      double
      elongation(const std::size_t m, const Places &x) const
      {
        return angle<dim>(u_of(x), v_of(x)) - rest_angle_[m];
      }

      const double *stiffness_;
      const double *rest_angle_;
    };


    template <int dim>
    class AngleKind : public KernelKind<AngleKernel<dim>>
    {
    public:
      /** The gradient of an angle is as the size to the power -1. */
      AngleKind()
        : KernelKind<AngleKernel<dim>>(
            "angles",
            "quadratic",
            {"a", "middle", "c"},
            {{"k", "N m/rad^2", Column::Role::stiffness, dim},
             {"rest_angle", "rad", Column::Role::rest_value, 0}})
      {}

      bool
      is_shared() const override
      {
        return true;
      }

      void
      canonicalise(std::vector<unsigned int> &nodes,
                   std::vector<std::vector<double>> &,
                   const Eigen::MatrixXd &) const override
      {
        if (nodes[0] > nodes[2])
          std::swap(nodes[0], nodes[2]);
      }
    };
  } // namespace

  const SpringKind &
  angles(const int dim)
  {
    static const AngleKind<2> plane;
    static const AngleKind<3> space;
    if (dim == 2)
      return plane;
    return space;
  }
} // namespace springfit
