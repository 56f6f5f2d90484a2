#include <springfit/motion/dampers.h>

namespace springfit
{
  namespace
  {
    /** From one node of a pair to the other; zero where they coincide. */
    Eigen::VectorXd
    direction(const Dampers &dampers,
              const std::array<unsigned int, 2> &pair,
              const Eigen::MatrixXd &displacement)
    {
      const auto [i, j] = pair;
      return (dampers.nodes.col(j) + displacement.col(j) -
              dampers.nodes.col(i) - displacement.col(i))
        .stableNormalized();
    }

    template <int dim>
    void
    add_blocks(const Dampers &dampers,
               const Eigen::MatrixXd &displacement,
               TangentMatrix &matrix)
    {
      for (const auto &pair : dampers.pairs)
        {
          const Eigen::Matrix<double, dim, 1> n =
            direction(dampers, pair, displacement);
          const Eigen::Matrix<double, dim, dim> block =
            dampers.coefficient * n * n.transpose();
          const auto [i, j] = pair;
          matrix.add(i, i, block);
          matrix.add(j, j, block);
          matrix.add(i, j, (-block).eval());
          matrix.add(j, i, (-block).eval());
        }
    }
  } // namespace

  bool
  are_there(const Dampers &dampers)
  {
    return dampers.coefficient != 0. && !dampers.pairs.empty();
  }

  Eigen::MatrixXd
  damper_product(const Dampers &dampers,
                 const Eigen::MatrixXd &displacement,
                 const Eigen::MatrixXd &velocity)
  {
    Eigen::MatrixXd product =
      Eigen::MatrixXd::Zero(velocity.rows(), velocity.cols());
    if (!are_there(dampers))
      return product;
    for (const auto &pair : dampers.pairs)
      {
        const auto [i, j]       = pair;
        const Eigen::VectorXd n = direction(dampers, pair, displacement);
        const Eigen::VectorXd force =
          dampers.coefficient * n.dot(velocity.col(i) - velocity.col(j)) * n;
        product.col(i) += force;
        product.col(j) -= force;
      }
    return product;
  }

  void
  add_damper_matrix(const Dampers &dampers,
                    const Eigen::MatrixXd &displacement,
                    TangentMatrix &matrix)
  {
    if (displacement.rows() == 2)
      add_blocks<2>(dampers, displacement, matrix);
    else
      add_blocks<3>(dampers, displacement, matrix);
  }

  void
  add_to_pattern(const Dampers &dampers, NodePattern &pattern)
  {
    for (const auto &pair : dampers.pairs)
      pattern.add_clique(pair.data(), pair.size());
  }
} // namespace springfit
