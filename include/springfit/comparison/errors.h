#ifndef springfit_comparison_errors_h
#define springfit_comparison_errors_h

#include <Eigen/Core>

namespace springfit
{
  /**
   * How far two models are apart at some nodes of their mesh: with e_i the
   * distance between the two positions of node i and o_max the largest
   * displacement of the finite element model anywhere, the root mean square and
   * the largest of e_i over these nodes, in per cent of o_max.
   */
  struct ErrorNorms
  {
    double e_rms_percent;
    double e_max_percent;
  };

  /** e_i in m, one per node; both displacements dim x n_nodes in m. */
  Eigen::VectorXd
  nodal_errors(const Eigen::MatrixXd &reference, const Eigen::MatrixXd &model);

  /** The largest length of a column. */
  double
  largest_displacement(const Eigen::MatrixXd &displacement);

  /** Over all nodes (Natsupakpong and Cavusoglu 2010). */
  ErrorNorms
  error_norms(const Eigen::MatrixXd &reference, const Eigen::MatrixXd &model);

  /**
   * Over the nodes that @p forces (dim x n_nodes, N) load, of which there must
   * be some: where a load is local the mean over all nodes hides the error
   * there.
   */
  ErrorNorms
  error_norms_where_loaded(const Eigen::MatrixXd &reference,
                           const Eigen::MatrixXd &model,
                           const Eigen::MatrixXd &forces);
} // namespace springfit

#endif
