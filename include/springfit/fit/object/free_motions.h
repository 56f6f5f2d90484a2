#ifndef springfit_fit_object_free_motions_h
#define springfit_fit_object_free_motions_h

#include <Eigen/SparseCore>

#include <vector>

namespace springfit
{
  /**
   * The nodes that their springs do not hold even if all other nodes are: some
   * motion of the node alone costs no energy, as of one on two springs in
   * space. In ascending order.
   *
   * @param stiffness n x n, N/m, symmetric, dim rows a node
   */
  std::vector<unsigned int>
  loose_nodes(const Eigen::SparseMatrix<double> &stiffness, int dim);

  /** The independent motions of a free body that cost no energy. */
  struct FreeMotions
  {
    unsigned int n; // all of them

    /** Those of more than a single node. */
    unsigned int n_of_parts;

    /** One that moves furthest in such a motion, where there are any. */
    unsigned int moved_node;
  };

  /**
   * Beyond rigid motions, by two factorisations.
   *
   * @param stiffness as above
   * @param nodes dim x n_nodes, m
   */
  FreeMotions
  find_free_motions(const Eigen::SparseMatrix<double> &stiffness,
                    const Eigen::MatrixXd &nodes);
} // namespace springfit

#endif
