#include <springfit/springs/tangent_matrix.h>

#include <algorithm>

namespace springfit
{
  NodePattern::NodePattern(const Eigen::Index n_nodes) : neighbours_(n_nodes)
  {}

  void
  NodePattern::add_clique(const unsigned int *nodes, const std::size_t n)
  {
    for (std::size_t a = 0; a < n; ++a)
      neighbours_[nodes[a]].insert(neighbours_[nodes[a]].end(),
                                   nodes,
                                   nodes + n);
  }

  std::vector<std::vector<unsigned int>>
  NodePattern::neighbours() const
  {
    std::vector<std::vector<unsigned int>> sorted = neighbours_;
    for (auto &row : sorted)
      {
        std::sort(row.begin(), row.end());
        row.erase(std::unique(row.begin(), row.end()), row.end());
      }
    return sorted;
  }


  TangentMatrix::TangentMatrix(const int dim, const NodePattern &pattern)
  {
    const auto neighbours      = pattern.neighbours();
    const Eigen::Index n_nodes = neighbours.size();
    matrix_.resize(dim * n_nodes, dim * n_nodes);
    Eigen::VectorXi sizes(dim * n_nodes);
    for (Eigen::Index v = 0; v < n_nodes; ++v)
      sizes.segment(dim * v, dim).setConstant(dim * neighbours[v].size());
    matrix_.reserve(sizes);
    for (Eigen::Index v = 0; v < n_nodes; ++v)
      for (int d = 0; d < dim; ++d)
        for (const unsigned int row : neighbours[v])
          for (int c = 0; c < dim; ++c)
            matrix_.insert(dim * row + c, dim * v + d) = 0.;
    matrix_.makeCompressed();
  }

  void
  TangentMatrix::set_zero()
  {
    entries().setZero();
  }

  const Eigen::SparseMatrix<double> &
  TangentMatrix::matrix() const
  {
    return matrix_;
  }

  Eigen::Map<Eigen::VectorXd>
  TangentMatrix::entries()
  {
    return {matrix_.valuePtr(), matrix_.nonZeros()};
  }

  Eigen::Map<const Eigen::VectorXd>
  TangentMatrix::entries() const
  {
    return {matrix_.valuePtr(), matrix_.nonZeros()};
  }
} // namespace springfit
