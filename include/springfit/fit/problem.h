#ifndef springfit_fit_problem_h
#define springfit_fit_problem_h

#include <springfit/fit/cell_material.h>
#include <springfit/fit/cell_model.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/spring_law.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /** A deformed cell. */
  struct DeformedState
  {
    /** dim x n_nodes, m */
    Eigen::MatrixXd displacement;

    /** The reference's tangent there, (dim * n_nodes)^2, N/m */
    Eigen::MatrixXd stiffness;
  };

  /**
   * What a fit is given: find k such that B diag(k) B^T resembles R. The
   * published formulas do not look at R but at the shape and the material.
   */
  struct FitProblem
  {
    /** The cell's vertices, dim x n_nodes, m */
    Eigen::MatrixXd points;

    std::vector<NodePair> springs;

    /** B, (dim * n_nodes) x n_springs: the gradients b_s, see gradients.h */
    Eigen::MatrixXd gradients;

    /** R, (dim * n_nodes) x (dim * n_nodes), N/m: the cell's stiffness */
    Eigen::MatrixXd stiffness;

    CellKind kind;

    IsotropicMaterial material;

    /** Those that a fit shall suit besides the state at rest. */
    std::vector<DeformedState> states = {};

    /** That of springs and couplings. */
    SpringLaw law = SpringLaw::quadratic;
  };

  /** The problem of a cell whose vertices are fully connected. */
  FitProblem
  make_fit_problem(const Eigen::MatrixXd &points,
                   CellKind kind,
                   const Eigen::MatrixXd &stiffness,
                   const IsotropicMaterial &material);

  /** E(k) = R - B diag(k) B^T, what the springs miss. */
  Eigen::MatrixXd
  residual(const FitProblem &problem, const Eigen::VectorXd &k);

  /**
   * What the lumped forces of a cell miss of R: R without their tangent at
   * rest, stress stiffness included.
   */
  Eigen::MatrixXd
  residual(const FitProblem &problem, const CellModel &model);
} // namespace springfit

#endif
