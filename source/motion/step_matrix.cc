#include <springfit/motion/step_matrix.h>
#include <springfit/springs/tangent_matrix.h>

#include <algorithm>
#include <vector>

namespace springfit
{
  namespace
  {
    using Sparse = Eigen::SparseMatrix<double>;

    TangentMatrix
    tangent_at(const int dim,
               const MovingBody &body,
               const Eigen::MatrixXd &displacement)
    {
      TangentMatrix tangent = empty_step_matrix(dim, body);
      body.elastic->add_tangent(displacement, tangent);
      return tangent;
    }

    /** By node, whether all its components are held. */
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
  } // namespace


  TangentMatrix
  empty_step_matrix(const int dim, const MovingBody &body)
  {
    NodePattern pattern(body.mass.size());
    body.elastic->add_to_pattern(pattern);
    for (unsigned int v = 0; v < body.mass.size(); ++v)
      pattern.add_clique(&v, 1);
    return TangentMatrix(dim, pattern);
  }


  void
  put_ones_where_held(const MovingBody &body, Sparse &matrix)
  {
    for (int column = 0; column < matrix.outerSize(); ++column)
      for (Sparse::InnerIterator entry(matrix, column); entry; ++entry)
        if (body.held[entry.row()] || body.held[entry.col()])
          entry.valueRef() = entry.row() == entry.col() ? 1. : 0.;
  }


  Sparse
  step_matrix(const MovingBody &body,
              const TangentMatrix &tangent,
              const double mass_factor,
              const double stiffness_factor)
  {
    Sparse matrix          = stiffness_factor * tangent.matrix();
    const Eigen::Index dim = matrix.rows() / body.mass.size();
    for (int column = 0; column < matrix.outerSize(); ++column)
      matrix.coeffRef(column, column) += mass_factor * body.mass[column / dim];
    put_ones_where_held(body, matrix);
    return matrix;
  }


  Sparse
  step_matrix(const int dim,
              const MovingBody &body,
              const Eigen::MatrixXd &displacement,
              const double mass_factor,
              const double stiffness_factor)
  {
    return step_matrix(body,
                       tangent_at(dim, body, displacement),
                       mass_factor,
                       stiffness_factor);
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
    for (const auto &coupling :
         mean_couplings(dim, tangent_at(dim, body, displacement).matrix()))
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
