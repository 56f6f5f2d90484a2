#ifndef springfit_calibration_object_scope_h
#define springfit_calibration_object_scope_h

#include <springfit/core/words.h>
#include <springfit/fit/fit.h>
#include <springfit/fit/object/object_problem.h>
#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/springs/network.h>

#include <Eigen/SparseCore>

#include <vector>

namespace springfit
{
  /** What the unknowns of one fit are. */
  enum class Scope
  {
    cell,  // the springs of a cell; cells add up
    object // all springs of the mesh
  };

  const WordTable<Scope> &
  scope_words();

  /** Loads under which a fit of a whole object gets the displacements right. */
  enum class Field
  {
    affine,    // forces of the nodes, affine_fields()
    quadratic, // forces of the nodes, quadratic_fields()
    responses  // the loads of the scene
  };

  const WordTable<Field> &
  field_words();

  /**
   * The displacements under the loads named: those of the scene are given,
   * others act on the free object.
   *
   * @param responses displacements under the loads of the scene, n x n_cases
   * @return n x n_fields; lengths are arbitrary
   *
   * @throws RunError when the object is singular beyond its rigid motions.
   */
  Eigen::MatrixXd
  displacement_fields(const std::vector<Field> &fields,
                      const ObjectProblem &problem,
                      const Eigen::MatrixXd &responses);

  /**
   * The stiffness of the finite elements of a mesh in N/m, n x n, without
   * supports. Degree of freedom dim * v + d is component d of vertex v.
   */
  template <int dim>
  Eigen::SparseMatrix<double>
  object_stiffness(const Mesh<dim> &mesh,
                   const Element<dim> &element,
                   const MaterialTable &materials);

  /**
   * The fit of all constants of a network to @p stiffness.
   *
   * @param network its terms and their places; its constants are not used
   * @param nonnegative whether springs must be >= 0; all else is free
   *
   * @throws RunError when a term has no tangent at rest.
   */
  ObjectProblem
  make_object_problem(const SpringNetwork &network,
                      const Eigen::SparseMatrix<double> &stiffness,
                      bool nonnegative);

  /** A whole object fitted, and how near its stiffness K is to R. */
  struct ObjectFit
  {
    Eigen::VectorXd constants;

    /** ||R - K||_F / ||R||_F and ||R - K||_2 / ||R||_2 */
    double frobenius_residual;
    double spectral_residual;

    /** Of the object that nothing holds: deformations that release energy. */
    unsigned int n_unstable;
  };

  /** What an object with these constants is. */
  ObjectFit
  judge_object(const ObjectProblem &problem, const Eigen::VectorXd &constants);

  /**
   * @param method one with a Method::fit_object
   * @param fields, prior see fit_displacements(); of the consistent fit
   *
   * @throws RunError as the fit does, or when the constants are not
   * finite.
   */
  ObjectFit
  fit_object(const ObjectProblem &problem,
             const Method &method,
             const Eigen::MatrixXd &fields,
             const Eigen::VectorXd &prior);
} // namespace springfit

#endif
