#include <springfit/motion/step_matrix.h>
#include <springfit/springs/tangent_matrix.h>

#include <algorithm>
#include <vector>

namespace springfit
{
  namespace
  {
    using Sparse = Eigen::SparseMatrix<double>;

    /** The mean of the diagonals of the blocks of nodes, but below it. */
    std::vector<Eigen::Triplet<double>>
    mean_couplings(const int dim, const Sparse &K)
    {
      std::vector<Eigen::Triplet<double>> couplings;
      for (int v = 0; v < K.cols() / dim; ++v)
        {
          // The columns of a node have the same rows, those of a node in a row.
          const int *column = K.outerIndexPtr() + dim * v;
          for (int e = 0; e < column[1] - column[0]; e += dim)
            {
              const int w = K.innerIndexPtr()[column[0] + e] / dim;
              double sum  = 0.;
              for (int d = 0; d < dim; ++d)
                sum += K.valuePtr()[column[d] + e + d];
              if (w > v)
                couplings.emplace_back(w, v, sum / dim);
            }
        }
      return couplings;
    }

    template <int dim>
    void
    add_node_blocks(const double factor,
                    const Eigen::MatrixXd &blocks,
                    TangentMatrix &matrix)
    {
      for (Eigen::Index v = 0; v < blocks.cols() / dim; ++v)
        if (const auto block = blocks.block<dim, dim>(0, dim * v);
            !block.isZero(0.))
          matrix.add(v, v, (factor * block).eval());
    }

    void
    add_node_blocks(const int dim,
                    const double factor,
                    const Eigen::MatrixXd &blocks,
                    TangentMatrix &matrix)
    {
      if (dim == 2)
        add_node_blocks<2>(factor, blocks, matrix);
      else
        add_node_blocks<3>(factor, blocks, matrix);
    }

    void
    add_multiple_of_unit(const int dim,
                         const unsigned int v,
                         const unsigned int w,
                         const double factor,
                         TangentMatrix &matrix)
    {
      if (dim == 2)
        matrix.add(v, w, (factor * Eigen::Matrix2d::Identity()).eval());
      else
        matrix.add(v, w, (factor * Eigen::Matrix3d::Identity()).eval());
    }
  } // namespace


  NodePattern
  step_pattern(const MovingBody &body)
  {
    NodePattern pattern(body.mass.size());
    body.elastic->add_to_pattern(pattern);
    add_to_pattern(body.dampers, pattern);
    for (unsigned int v = 0; v < body.mass.size(); ++v)
      pattern.add_clique(&v, 1);
    for (int c = 0; c < body.consistent_mass.outerSize(); ++c)
      for (Sparse::InnerIterator entry(body.consistent_mass, c); entry; ++entry)
        {
          const unsigned int pair[] = {static_cast<unsigned int>(entry.row()),
                                       static_cast<unsigned int>(c)};
          pattern.add_clique(pair, 2);
        }
    return pattern;
  }


  std::vector<bool>
  held_nodes(const int dim, const MovingBody &body)
  {
    std::vector<bool> held(body.mass.size());
    for (std::size_t v = 0; v < held.size(); ++v)
      held[v] = std::all_of(body.held.begin() + dim * v,
                            body.held.begin() + dim * (v + 1),
                            [](const bool is_held) { return is_held; });
    return held;
  }


  StepMatrix::StepMatrix(const int dim, const MovingBody &body)
    : dim_(dim)
    , body_(body)
    , stiffness_(dim, step_pattern(body))
    , sum_(stiffness_)
  {
    if (are_there(body.dampers))
      dampers_.push_back(stiffness_);
    const Sparse &matrix  = sum_.matrix();
    Eigen::Index position = 0;
    for (int column = 0; column < matrix.outerSize(); ++column)
      for (Sparse::InnerIterator entry(matrix, column); entry;
           ++entry, ++position)
        {
          if (entry.row() == column)
            diagonal_.push_back(position);
          if (body.held[entry.row()] || body.held[column])
            held_.push_back(position);
        }
  }


  void
  StepMatrix::linearise(const MotionState &state, const Tangent tangent)
  {
    stiffness_.set_zero();
    if (tangent == Tangent::exact)
      body_.elastic->add_tangent(state.displacement, stiffness_);
    else
      body_.elastic->add_convex_tangent(state.displacement, stiffness_);
    for (TangentMatrix &matrix : dampers_)
      {
        matrix.set_zero();
        add_damper_matrix(body_.dampers, state.displacement, matrix);
      }
    linearise_loads(state);
  }


  void
  StepMatrix::linearise_loads(const MotionState &state)
  {
    if (!body_.load_stiffness)
      return;
    load_blocks_.setZero(dim_, dim_ * body_.mass.size());
    body_.load_stiffness(state, load_blocks_);
  }


  Eigen::MatrixXd
  StepMatrix::stiffness_product(const Eigen::MatrixXd &u) const
  {
    const Eigen::VectorXd product = stiffness_.matrix() * u.reshaped();
    return product.reshaped(u.rows(), u.cols());
  }


  void
  StepMatrix::add_mass(const double factor)
  {
    if (body_.consistent_mass.nonZeros() == 0)
      for (std::size_t i = 0; i < diagonal_.size(); ++i)
        sum_.entries()[diagonal_[i]] += factor * body_.mass[i / dim_];
    for (int c = 0; c < body_.consistent_mass.outerSize(); ++c)
      for (Sparse::InnerIterator entry(body_.consistent_mass, c); entry;
           ++entry)
        add_multiple_of_unit(
          dim_, entry.row(), c, factor * entry.value(), sum_);
  }


  const Sparse &
  StepMatrix::sum(const StepFactors &factors)
  {
    auto entries = sum_.entries();
    entries      = factors.stiffness * stiffness_.entries();
    add_mass(factors.mass);
    if (body_.load_stiffness)
      add_node_blocks(dim_, factors.load_stiffness, load_blocks_, sum_);
    for (const TangentMatrix &matrix : dampers_)
      entries += factors.dampers * matrix.entries();
    for (const Eigen::Index position : held_)
      entries[position] = 0.;
    for (std::size_t i = 0; i < diagonal_.size(); ++i)
      if (body_.held[i])
        entries[diagonal_[i]] = 1.;
    return sum_.matrix();
  }


  Sparse
  scalar_step_matrix(const int dim,
                     const MovingBody &body,
                     const Eigen::MatrixXd &displacement,
                     const double mass_factor,
                     const double stiffness_factor)
  {
    const std::vector<bool> held = held_nodes(dim, body);
    Eigen::VectorXd diagonal     = mass_factor * body.mass;
    std::vector<Eigen::Triplet<double>> entries;
    TangentMatrix tangent(dim, step_pattern(body));
    body.elastic->add_tangent(displacement, tangent);
    for (const auto &coupling : mean_couplings(dim, tangent.matrix()))
      {
        const double value = stiffness_factor * std::min(coupling.value(), 0.);
        diagonal[coupling.row()] -= value;
        diagonal[coupling.col()] -= value;
        if (value == 0. || held[coupling.row()] || held[coupling.col()])
          continue;
        entries.emplace_back(coupling.row(), coupling.col(), value);
        entries.emplace_back(coupling.col(), coupling.row(), value);
      }
    for (int v = 0; v < diagonal.size(); ++v)
      entries.emplace_back(v, v, held[v] ? 1. : diagonal[v]);
    Sparse matrix(diagonal.size(), diagonal.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }
} // namespace springfit
