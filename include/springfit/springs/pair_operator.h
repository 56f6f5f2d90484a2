#ifndef springfit_springs_pair_operator_h
#define springfit_springs_pair_operator_h

#include <springfit/springs/family.h>
#include <springfit/springs/tangent_operator.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace springfit
{
  /**
   * The Hessian of springs between two nodes, see PairKernel: of each spring
   * the block f I + c d d^T of its first node, kept as d, f and c. Roots and
   * quotients are taken once, not in each product.
   */
  template <typename Kernel>
  class PairOperator : public TangentOperator
  {
  public:
    static constexpr int dim = Kernel::dim;
    using Vector             = typename Kernel::Vector;

    /** @p members, sorted by their first nodes, must outlive the object. */
    explicit PairOperator(const Members &members)
      : members_(members), blocks_(members.nodes.size() / 2)
    {}

    /** @param state the places of the nodes */
    void
    linearise(const Eigen::MatrixXd &state) override
    {
      const Kernel kernel(members_);
      const unsigned int *nodes = members_.nodes.data();
      for (std::size_t m = 0; m < blocks_.size(); ++m)
        {
          const Vector d =
            at(state, nodes[2 * m + 1]) - at(state, nodes[2 * m]);
          blocks_[m] = kernel.is_smooth_at(m, d)
                         ? Block{d, kernel.slope(m, d), kernel.curvature(m, d)}
                         : Block{Vector::Zero(), 0., 0.};
        }
    }

    void
    add_product(const Eigen::MatrixXd &u,
                Eigen::MatrixXd &product) const override
    {
      const unsigned int *nodes = members_.nodes.data();
      for (std::size_t m = 0; m < blocks_.size();)
        {
          const unsigned int i = nodes[2 * m];
          const Vector u_i     = at(u, i);
          Vector sum           = Vector::Zero();
          do
            {
              const unsigned int j = nodes[2 * m + 1];
              const Block &block   = blocks_[m];
              const Vector e       = u_i - at(u, j);
              const double along   = block.c * block.d.dot(e);
              const Vector f       = block.f * e + along * block.d;
              sum += f;
              Eigen::Map<Vector>(product.data() + dim * j) -= f;
              ++m;
          } while (m < blocks_.size() && nodes[2 * m] == i);
          Eigen::Map<Vector>(product.data() + dim * i) += sum;
        }
    }

  private:
    struct Block
    {
      Vector d;    // x_j - x_i, m
      double f, c; // N/m, N/m^3
    };

    static Eigen::Map<const Vector>
    at(const Eigen::MatrixXd &x, const unsigned int node)
    {
      return Eigen::Map<const Vector>(x.data() + dim * node);
    }

    const Members &members_;
    std::vector<Block> blocks_;
  };


  /** The same where c = 0 and f = k wherever the nodes are: k I. */
  template <typename Kernel>
  class LinearPairOperator : public TangentOperator
  {
  public:
    static constexpr int dim = Kernel::dim;
    using Vector             = typename Kernel::Vector;

    /** @p members, sorted by their first nodes, must outlive the object. */
    explicit LinearPairOperator(const Members &members) : members_(members)
    {}

    void
    linearise(const Eigen::MatrixXd &) override
    {}

    void
    add_product(const Eigen::MatrixXd &u,
                Eigen::MatrixXd &product) const override
    {
      const unsigned int *nodes = members_.nodes.data();
      const double *k           = members_.columns[0].data();
      const std::size_t size    = members_.columns[0].size();
      for (std::size_t m = 0; m < size;)
        {
          const unsigned int i = nodes[2 * m];
          const Vector u_i     = at(u, i);
          Vector sum           = Vector::Zero();
          do
            {
              const unsigned int j = nodes[2 * m + 1];
              const Vector f       = k[m] * (u_i - at(u, j));
              sum += f;
              Eigen::Map<Vector>(product.data() + dim * j) -= f;
              ++m;
          } while (m < size && nodes[2 * m] == i);
          Eigen::Map<Vector>(product.data() + dim * i) += sum;
        }
    }

  private:
    static Eigen::Map<const Vector>
    at(const Eigen::MatrixXd &x, const unsigned int node)
    {
      return Eigen::Map<const Vector>(x.data() + dim * node);
    }

    const Members &members_;
  };
} // namespace springfit

#endif
