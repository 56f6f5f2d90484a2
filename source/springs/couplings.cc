#include <springfit/springs/cell_topology.h>
#include <springfit/springs/couplings.h>
#include <springfit/springs/elongation.h>
#include <springfit/springs/kernel_kind.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace springfit
{
  namespace
  {
    template <int dim_, SpringLaw law>
    class CouplingKernel
    {
    public:
      static constexpr int dim          = dim_;
      static constexpr int n_nodes      = 4;
      static constexpr bool has_hessian = false;
      using Places                      = Eigen::Matrix<double, dim, 4>;

      explicit CouplingKernel(const Members &members)
        : stiffness_(members.columns[0].data())
        , rest_length_a_(members.columns[1].data())
        , rest_length_b_(members.columns[2].data())
      {}

      bool
      is_smooth(const std::size_t m, const Places &x) const
      {
        return elongation<dim>(law, rest_length_a_[m], d_a(x)) &&
               elongation<dim>(law, rest_length_b_[m], d_b(x));
      }

      double
      energy(const std::size_t m, const Places &x) const
      {
        if (!is_smooth(m, x))
          return std::numeric_limits<double>::infinity();
        return stiffness_[m] * a(m, x).value() * b(m, x).value();
      }

      Places
      gradient(const std::size_t m, const Places &x) const
      {
        const Elongation<dim> q_a = a(m, x), q_b = b(m, x);
        return stiffness_[m] *
               both(q_b.value() * q_a.gradient(), q_a.value() * q_b.gradient());
      }

      Places
      product(const std::size_t m, const Places &x, const Places &u) const
      {
        const Elongation<dim> q_a = a(m, x), q_b = b(m, x);
        const Vector<2 *dim> u_a = u.template leftCols<2>().reshaped();
        const Vector<2 *dim> u_b = u.template rightCols<2>().reshaped();
        const Vector<2 *dim> g_a = q_a.gradient(), g_b = q_b.gradient();
        return stiffness_[m] *
               both(q_b.value() * (q_a.hessian() * u_a) + g_b.dot(u_b) * g_a,
                    q_a.value() * (q_b.hessian() * u_b) + g_a.dot(u_a) * g_b);
      }

    private:
      static Vector<dim>
      d_a(const Places &x)
      {
        return x.col(1) - x.col(0);
      }

      static Vector<dim>
      d_b(const Places &x)
      {
        return x.col(3) - x.col(2);
      }

      static Places
      both(const Vector<2 * dim> &of_a, const Vector<2 * dim> &of_b)
      {
        Places places;
        places << of_a.template head<dim>(), of_a.template tail<dim>(),
          of_b.template head<dim>(), of_b.template tail<dim>();
        return places;
      }

      Elongation<dim>
      a(const std::size_t m, const Places &x) const
      {
        return {law, rest_length_a_[m], d_a(x)};
      }

      Elongation<dim>
      b(const std::size_t m, const Places &x) const
      {
        return {law, rest_length_b_[m], d_b(x)};
      }

      const double *stiffness_;
      const double *rest_length_a_;
      const double *rest_length_b_;
    };


    /** The elongation q of a pair of nodes, and grad q = (-g, g). */
    template <int dim, SpringLaw law>
    struct DirectedElongation
    {
      DirectedElongation(const double L, const Vector<dim> &d)
      {
        const double s = d.squaredNorm();
        if (law == SpringLaw::biquadratic)
          {
            q = (s - L * L) / (2. * L);
            g = d / L;
          }
        else
          {
            const double l = std::sqrt(s);
            is_smooth      = s > 1e-24 * L * L;
            q              = l - L;
            g              = d / l;
          }
      }

      bool is_smooth = true;
      double q;
      Vector<dim> g;
    };


    template <int dim, SpringLaw law>
    class CouplingKind : public KernelKind<CouplingKernel<dim, law>>
    {
    public:
      CouplingKind()
        : KernelKind<CouplingKernel<dim, law>>(
            "couplings",
            word_of(spring_law_words(), law),
            {"i_a", "j_a", "i_b", "j_b"},
            {{"stiffness", "N/m", Column::Role::stiffness, dim - 2},
             {"rest_length_a", "m", Column::Role::rest_value, 1},
             {"rest_length_b", "m", Column::Role::rest_value, 1}})
      {}

      bool
      is_shared() const override
      {
        return true;
      }

      void
      canonicalise(std::vector<unsigned int> &nodes,
                   std::vector<std::vector<double>> &numbers,
                   const Eigen::MatrixXd &) const override
      {
        if (nodes[0] > nodes[1])
          std::swap(nodes[0], nodes[1]);
        if (nodes[2] > nodes[3])
          std::swap(nodes[2], nodes[3]);
        if (std::tie(nodes[0], nodes[1]) > std::tie(nodes[2], nodes[3]))
          {
            std::swap(nodes[0], nodes[2]);
            std::swap(nodes[1], nodes[3]);
            std::swap(numbers[1], numbers[2]);
          }
      }

      /** Members are sorted: the first pair is the same in many of them. */
      void
      add_forces(const Members &members,
                 const Eigen::MatrixXd &x,
                 Eigen::MatrixXd &forces) const override
      {
        using Pair                = DirectedElongation<dim, law>;
        const auto &columns       = members.columns;
        const unsigned int *nodes = members.nodes.data();
        const std::size_t size    = members.nodes.size() / 4;
        const auto distance       = [&x](const NodePair &pair) -> Vector<dim> {
          return Eigen::Map<const Vector<dim>>(x.data() + dim * pair[1]) -
                 Eigen::Map<const Vector<dim>>(x.data() + dim * pair[0]);
        };
        const auto add = [&](const NodePair &pair, const Vector<dim> &f) {
          Eigen::Map<Vector<dim>>(forces.data() + dim * pair[0]) += f;
          Eigen::Map<Vector<dim>>(forces.data() + dim * pair[1]) -= f;
        };

        for (std::size_t m = 0; m < size;)
          {
            const NodePair of_a = {{nodes[4 * m], nodes[4 * m + 1]}};
            const double L_a    = columns[1][m];
            const Pair a(L_a, distance(of_a));
            double tension_a = 0.;
            for (; m < size && nodes[4 * m] == of_a[0] &&
                   nodes[4 * m + 1] == of_a[1] && columns[1][m] == L_a;
                 ++m)
              {
                const NodePair of_b = {{nodes[4 * m + 2], nodes[4 * m + 3]}};
                const Pair b(columns[2][m], distance(of_b));
                if (!a.is_smooth || !b.is_smooth)
                  continue;
                tension_a += columns[0][m] * b.q;
                add(of_b, columns[0][m] * a.q * b.g);
              }
            if (a.is_smooth)
              add(of_a, tension_a * a.g);
          }
      }
    };

    template <int dim>
    const SpringKind &
    couplings(const SpringLaw law)
    {
      static const CouplingKind<dim, SpringLaw::quadratic> quadratic;
      static const CouplingKind<dim, SpringLaw::biquadratic> biquadratic;
      if (law == SpringLaw::biquadratic)
        return biquadratic;
      return quadratic;
    }
  } // namespace

  const SpringKind &
  couplings(const int dim, const SpringLaw law)
  {
    return dim == 2 ? couplings<2>(law) : couplings<3>(law);
  }
} // namespace springfit
