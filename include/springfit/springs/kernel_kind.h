#ifndef springfit_springs_kernel_kind_h
#define springfit_springs_kernel_kind_h

#include <springfit/springs/family.h>
#include <springfit/springs/positive_part.h>
#include <springfit/springs/tangent_matrix.h>

#include <Eigen/Core>

#include <cstddef>

namespace springfit
{
  /**
   * A kind of spring from a kernel: what one member is at the places of its
   * nodes. All sizes are fixed, so that nothing is allocated for a member. A
   * kernel is a view of the columns and has
   *
   *     static constexpr int dim, n_nodes;
   *     static constexpr bool has_hessian;
   *     using Places = Eigen::Matrix<double, dim, n_nodes>;
   *     explicit Kernel(const Members &);
   *     double energy(std::size_t m, const Places &x) const;  // or infinity
   *     Places gradient(std::size_t m, const Places &x) const;
   *     Places product(std::size_t m, const Places &x, const Places &u) const;
   *
   * where product is the Hessian of the energy times u, and gradient and
   * product are asked for at places of finite energy only:
   *
   *     bool is_smooth(std::size_t m, const Places &x) const;
   *
   * With has_hessian it has that, too, else it is taken from products, column
   * by column:
   *
   *     Eigen::Matrix<double, dim * n_nodes, dim * n_nodes>
   *     hessian(std::size_t m, const Places &x) const;
   */
  template <typename Kernel>
  class KernelKind : public SpringKind
  {
  public:
    static constexpr int dim = Kernel::dim;
    static constexpr int n   = Kernel::n_nodes;
    using Places             = Eigen::Matrix<double, dim, n>;
    using Hessian            = Eigen::Matrix<double, dim * n, dim * n>;

    using SpringKind::SpringKind;

    double
    energy(const Members &members, const Eigen::MatrixXd &x) const override
    {
      const Kernel kernel(members);
      double sum = 0.;
      for_each(members, [&](const std::size_t m, const unsigned int *nodes) {
        sum += kernel.energy(m, gather(nodes, x));
      });
      return sum;
    }

    void
    add_forces(const Members &members,
               const Eigen::MatrixXd &x,
               Eigen::MatrixXd &forces) const override
    {
      const Kernel kernel(members);
      for_each(members, [&](const std::size_t m, const unsigned int *nodes) {
        const Places places = gather(nodes, x);
        if (kernel.is_smooth(m, places))
          scatter(nodes, -kernel.gradient(m, places), forces);
      });
    }

    void
    add_tangent_product(const Members &members,
                        const Eigen::MatrixXd &x,
                        const Eigen::MatrixXd &u,
                        Eigen::MatrixXd &product) const override
    {
      const Kernel kernel(members);
      for_each(members, [&](const std::size_t m, const unsigned int *nodes) {
        const Places places = gather(nodes, x);
        if (kernel.is_smooth(m, places))
          scatter(nodes, kernel.product(m, places, gather(nodes, u)), product);
      });
    }

    void
    add_tangent(const Members &members,
                const Eigen::MatrixXd &x,
                TangentMatrix &tangent) const override
    {
      for_each_hessian(members,
                       x,
                       [&](const unsigned int *nodes, const Hessian &H) {
                         add_blocks(nodes, H, tangent);
                       });
    }

    void
    add_convex_tangent(const Members &members,
                       const Eigen::MatrixXd &x,
                       TangentMatrix &tangent) const override
    {
      for_each_hessian(members,
                       x,
                       [&](const unsigned int *nodes, const Hessian &H) {
                         add_blocks(nodes, positive_part(H), tangent);
                       });
    }

    void
    add_diagonal_blocks(const Members &members,
                        const Eigen::MatrixXd &x,
                        Eigen::MatrixXd &blocks) const override
    {
      for_each_hessian(
        members, x, [&](const unsigned int *nodes, const Hessian &H) {
          for (int a = 0; a < n; ++a)
            for (int b = 0; b < n; ++b)
              if (nodes[a] == nodes[b])
                blocks.template middleCols<dim>(dim * nodes[a]) +=
                  H.template block<dim, dim>(dim * a, dim * b);
        });
    }

    Eigen::MatrixXd
    hessian(const Members &members,
            const std::size_t member,
            const Eigen::MatrixXd &x) const override
    {
      const Kernel kernel(members);
      const Places places = gather(members.nodes.data() + n * member, x);
      if (!kernel.is_smooth(member, places))
        return Eigen::MatrixXd::Zero(dim * n, dim * n);
      return hessian_of(kernel, member, places);
    }

  private:
    template <typename F>
    static void
    for_each(const Members &members, const F &f)
    {
      const std::size_t n_members = members.nodes.size() / n;
      const unsigned int *nodes   = members.nodes.data();
      for (std::size_t m = 0; m < n_members; ++m, nodes += n)
        f(m, nodes);
    }

    template <typename F>
    static void
    for_each_hessian(const Members &members,
                     const Eigen::MatrixXd &x,
                     const F &f)
    {
      const Kernel kernel(members);
      for_each(members, [&](const std::size_t m, const unsigned int *nodes) {
        const Places places = gather(nodes, x);
        if (kernel.is_smooth(m, places))
          f(nodes, hessian_of(kernel, m, places));
      });
    }

    static Places
    gather(const unsigned int *nodes, const Eigen::MatrixXd &x)
    {
      Places places;
      for (int a = 0; a < n; ++a)
        for (int d = 0; d < dim; ++d)
          places(d, a) = x.data()[dim * nodes[a] + d];
      return places;
    }

    static void
    scatter(const unsigned int *nodes,
            const Places &of_member,
            Eigen::MatrixXd &f)
    {
      for (int a = 0; a < n; ++a)
        for (int d = 0; d < dim; ++d)
          f.data()[dim * nodes[a] + d] += of_member(d, a);
    }

    /** By products, the rounding errors of the halves are evened out. */
    static Hessian
    hessian_of(const Kernel &kernel, const std::size_t m, const Places &x)
    {
      if constexpr (Kernel::has_hessian)
        return kernel.hessian(m, x);
      Hessian H;
      for (int column = 0; column < dim * n; ++column)
        {
          Places u                      = Places::Zero();
          u(column % dim, column / dim) = 1.;
          const Places of_column        = kernel.product(m, x, u);
          H.col(column)                 = of_column.reshaped();
        }
      return 0.5 * (H + H.transpose());
    }

    static void
    add_blocks(const unsigned int *nodes,
               const Hessian &H,
               TangentMatrix &tangent)
    {
      for (int b = 0; b < n; ++b)
        for (int a = 0; a < n; ++a)
          tangent.add(nodes[a],
                      nodes[b],
                      H.template block<dim, dim>(dim * a, dim * b).eval());
    }
  };
} // namespace springfit

#endif
