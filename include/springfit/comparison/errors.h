#ifndef springfit_comparison_errors_h
#define springfit_comparison_errors_h

#include <Eigen/Core>

namespace springfit
{
  /**
   * How far two models of one mesh are apart (Natsupakpong and Cavusoglu
   * 2010): with e_i the distance between the two positions of node i and o_max
   * the largest displacement of the finite element model, the root mean square
   * and the largest of e_i over all nodes, in per cent of o_max.
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

  ErrorNorms
  error_norms(const Eigen::MatrixXd &reference, const Eigen::MatrixXd &model);
} // namespace springfit

#endif
