#ifndef springfit_motion_block_factors_h
#define springfit_motion_block_factors_h

#include <springfit/springs/tangent_matrix.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace springfit
{
  /**
   * L D L^T factors of symmetric matrices on the displacements of nodes, whose
   * sparsity is analysed once: with a block of dim x dim for two nodes they
   * take a quarter of the time of factors by single entries. Nothing is
   * pivoted, so that factors of a matrix that is not definite are exact only as
   * far as none of its leading parts is nearly singular.
   */
  class BlockFactors
  {
  public:
    virtual ~BlockFactors() = default;

    /**
     * Factorise a matrix of the pattern's sparsity, as a TangentMatrix has it,
     * of which the part below the diagonal counts.
     */
    virtual void
    factorise(const Eigen::SparseMatrix<double> &matrix) = 0;

    /** Whether the last matrix had factors, all finite. */
    virtual bool
    exist() const = 0;

    /** Whether they exist and the matrix is positive definite. */
    virtual bool
    are_positive() const = 0;

    /** Sets @p x to the inverse times @p x; dim x n_nodes. */
    virtual void
    solve(Eigen::MatrixXd &x) const = 0;
  };

  /**
   * In numbers of type @p Number, double or float.
   *
   * @param dim components of a node, 2 or 3
   * @param pattern of the matrices
   * @param alone by node, whether it has entries with itself only, whatever
   *   the pattern says
   */
  template <typename Number>
  std::unique_ptr<BlockFactors>
  make_block_factors(int dim,
                     const NodePattern &pattern,
                     const std::vector<bool> &alone);
} // namespace springfit

#endif
