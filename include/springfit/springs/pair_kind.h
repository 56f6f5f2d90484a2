#ifndef springfit_springs_pair_kind_h
#define springfit_springs_pair_kind_h

#include <springfit/springs/kernel_kind.h>
#include <springfit/springs/pair_operator.h>
#include <springfit/springs/tangent_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  /**
   * A spring between two nodes at the distance d = x_j - x_i, of an energy U
   * that depends on s = |d|^2 alone. With its derivatives f = 2 U'(s) (the
   * force on node i is f d) and c = 4 U''(s), the Hessian's block of i with
   * itself is f I + c d d^T. A Law has, of a stiffness k and a rest length L,
   *
   *     static double energy(double k, double L, double s);
   *     static double force(double k, double L, double s);     // f
   *     static double curvature(double k, double L, double s); // c
   *     static bool is_smooth(double L, double s);
   *
   * and says whether it is Hooke's, U = k (l - L)^2 / 2, and whether L is 0:
   *
   *     static constexpr bool is_hookean;
   *     static constexpr bool has_no_length;
   */
  template <int dim_, typename Law>
  class PairKernel
  {
  public:
    static constexpr int dim          = dim_;
    static constexpr int n_nodes      = 2;
    static constexpr bool has_hessian = false;
    using Places                      = Eigen::Matrix<double, dim, 2>;
    using Vector                      = Eigen::Matrix<double, dim, 1>;

    explicit PairKernel(const Members &members)
      : stiffness_(members.columns[0].data())
      , rest_length_(members.columns[1].data())
    {}

    bool
    is_smooth(const std::size_t m, const Places &x) const
    {
      return Law::is_smooth(rest_length_[m], square(x));
    }

    double
    energy(const std::size_t m, const Places &x) const
    {
      if (!is_smooth(m, x))
        return std::numeric_limits<double>::infinity();
      return Law::energy(stiffness_[m], rest_length_[m], square(x));
    }

    Places
    gradient(const std::size_t m, const Places &x) const
    {
      const Vector f = force(m, x.col(1) - x.col(0));
      Places gradient;
      gradient << -f, f;
      return gradient;
    }

    Places
    product(const std::size_t m, const Places &x, const Places &u) const
    {
      const Vector f = change(m, x.col(1) - x.col(0), u.col(1) - u.col(0));
      Places product;
      product << -f, f;
      return product;
    }

    /** On node i, in N. */
    Vector
    force(const std::size_t m, const Vector &d) const
    {
      return Law::force(stiffness_[m], rest_length_[m], d.squaredNorm()) * d;
    }

    /** The change of force() with that of the distance. */
    Vector
    change(const std::size_t m,
           const Vector &d,
           const Vector &change_of_d) const
    {
      const double s = d.squaredNorm();
      const double f = Law::force(stiffness_[m], rest_length_[m], s);
      const double c = Law::curvature(stiffness_[m], rest_length_[m], s);
      return f * change_of_d + (c * d.dot(change_of_d)) * d;
    }

    /** f, N/m */
    double
    slope(const std::size_t m, const Vector &d) const
    {
      return Law::force(stiffness_[m], rest_length_[m], d.squaredNorm());
    }

    /** c, N/m^3 */
    double
    curvature(const std::size_t m, const Vector &d) const
    {
      return Law::curvature(stiffness_[m], rest_length_[m], d.squaredNorm());
    }

    bool
    is_smooth_at(const std::size_t m, const Vector &d) const
    {
      return Law::is_smooth(rest_length_[m], d.squaredNorm());
    }

  private:
    static double
    square(const Places &x)
    {
      return (x.col(1) - x.col(0)).squaredNorm();
    }

    const double *stiffness_;
    const double *rest_length_;
  };


  /**
   * Springs between two nodes i < j, sorted by them: what a node's row of
   * springs does to the node is summed up before it is stored.
   */
  template <int dim, typename Law>
  class PairKind : public KernelKind<PairKernel<dim, Law>>
  {
  public:
    using Vector = Eigen::Matrix<double, dim, 1>;
    using Block  = Eigen::Matrix<double, dim, dim>;

    /** Stiffness is as the size to the power dim - 2. */
    PairKind()
      : KernelKind<PairKernel<dim, Law>>(
          "springs",
          Law::word(),
          {"i", "j"},
          {{"k", "N/m", Column::Role::stiffness, dim - 2},
           {"rest_length", "m", Column::Role::rest_value, 1}})
    {}

    bool
    is_shared() const override
    {
      return true;
    }

    bool
    rest_values_average() const override
    {
      return Law::is_hookean;
    }

    bool
    bears_inversion() const override
    {
      return Law::has_no_length;
    }

    void
    canonicalise(std::vector<unsigned int> &nodes,
                 std::vector<std::vector<double>> &,
                 const Eigen::MatrixXd &) const override
    {
      if (nodes[0] > nodes[1])
        std::swap(nodes[0], nodes[1]);
    }

    void
    add_forces(const Members &members,
               const Eigen::MatrixXd &x,
               Eigen::MatrixXd &forces) const override
    {
      const PairKernel<dim, Law> kernel(members);
      add_row_by_row(
        members,
        x,
        [&](const std::size_t m, unsigned int, unsigned int, const Vector &d) {
          return kernel.is_smooth_at(m, d) ? kernel.force(m, d)
                                           : Vector(Vector::Zero());
        },
        forces);
    }

    void
    add_tangent_product(const Members &members,
                        const Eigen::MatrixXd &x,
                        const Eigen::MatrixXd &u,
                        Eigen::MatrixXd &product) const override
    {
      const PairKernel<dim, Law> kernel(members);
      add_row_by_row(
        members,
        x,
        [&](const std::size_t m,
            const unsigned int i,
            const unsigned int j,
            const Vector &d) -> Vector {
          if (!kernel.is_smooth_at(m, d))
            return Vector::Zero();
          return kernel.change(m, d, at(u, i) - at(u, j));
        },
        product);
    }

    void
    add_tangent(const Members &members,
                const Eigen::MatrixXd &x,
                TangentMatrix &tangent) const override
    {
      add_pair_by_pair(
        members,
        x,
        [](const double slope, const double curvature, const Vector &d) {
          return Block(slope * Block::Identity() +
                       curvature * d * d.transpose());
        },
        tangent);
    }

    /**
     * The Hessian has the slope across the spring and slope + curvature l^2
     * along it as eigenvalues: a spring that is pressed resists along itself
     * alone (Choi and Ko 2002).
     */
    void
    add_convex_tangent(const Members &members,
                       const Eigen::MatrixXd &x,
                       TangentMatrix &tangent) const override
    {
      add_pair_by_pair(
        members,
        x,
        [](const double slope, const double curvature, const Vector &d) {
          const double s      = d.squaredNorm();
          const double across = std::max(slope, 0.);
          const double along  = std::max(slope + curvature * s, 0.);
          Block block         = across * Block::Identity();
          if (s > 0.)
            block += (along - across) / s * d * d.transpose();
          return block;
        },
        tangent);
    }

    std::unique_ptr<TangentOperator>
    tangent_operator(const Members &members) const override
    {
      using Kernel = PairKernel<dim, Law>;
      if constexpr (Law::has_no_length)
        return std::make_unique<LinearPairOperator<Kernel>>(members);
      else
        return std::make_unique<PairOperator<Kernel>>(members);
    }

  private:
    static Eigen::Map<const Vector>
    at(const Eigen::MatrixXd &x, const unsigned int node)
    {
      return Eigen::Map<const Vector>(x.data() + dim * node);
    }

    /** Adds the Hessian of each, of which @p block_of is a node with itself. */
    template <typename F>
    static void
    add_pair_by_pair(const Members &members,
                     const Eigen::MatrixXd &x,
                     const F &block_of,
                     TangentMatrix &tangent)
    {
      const PairKernel<dim, Law> kernel(members);
      for (std::size_t m = 0; m < members.nodes.size() / 2; ++m)
        {
          const unsigned int i = members.nodes[2 * m];
          const unsigned int j = members.nodes[2 * m + 1];
          const Vector d       = at(x, j) - at(x, i);
          if (!kernel.is_smooth_at(m, d))
            continue;
          Block block = block_of(kernel.slope(m, d), kernel.curvature(m, d), d);
          tangent.add(i, i, block);
          tangent.add(j, j, block);
          block = -block;
          tangent.add(i, j, block);
          tangent.add(j, i, block);
        }
    }

    /** Adds what @p on_node_i gives to node i, and the opposite to node j. */
    template <typename F>
    static void
    add_row_by_row(const Members &members,
                   const Eigen::MatrixXd &x,
                   const F &on_node_i,
                   Eigen::MatrixXd &result)
    {
      const unsigned int *nodes = members.nodes.data();
      const std::size_t size    = members.nodes.size() / 2;
      for (std::size_t m = 0; m < size;)
        {
          const unsigned int i = nodes[2 * m];
          const Vector x_i     = at(x, i);
          Vector sum           = Vector::Zero();
          do
            {
              const unsigned int j = nodes[2 * m + 1];
              const Vector f       = on_node_i(m, i, j, at(x, j) - x_i);
              sum += f;
              Eigen::Map<Vector>(result.data() + dim * j) -= f;
              ++m;
          } while (m < size && nodes[2 * m] == i);
          Eigen::Map<Vector>(result.data() + dim * i) += sum;
        }
    }
  };
} // namespace springfit

#endif
