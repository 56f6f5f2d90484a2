#ifndef springfit_calibration_cell_fits_h
#define springfit_calibration_cell_fits_h

#include <springfit/calibration/distinct_cells.h>
#include <springfit/core/session.h>
#include <springfit/fit/fit.h>
#include <springfit/mesh/mesh.h>
#include <springfit/reference/cell_matrices.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/reference/material_law.h>
#include <springfit/springs/spring_law.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  template <int dim, int spacedim = dim>
  using CellIterator =
    typename dealii::Triangulation<dim, spacedim>::active_cell_iterator;

  /** The cells of a mesh; the position is the active cell index. */
  template <int dim, int spacedim>
  std::vector<CellIterator<dim, spacedim>>
  cells_by_index(const Mesh<dim, spacedim> &mesh);


  /** The material as the fits know it, in cells of dimension @p dim. */
  template <int dim>
  IsotropicMaterial
  material_of(const CellMaterial &material);

  /** What the fits of one cell are given, in its own coordinates. */
  template <int dim, int spacedim = dim>
  FitProblem
  cell_problem(
    const typename dealii::Triangulation<dim, spacedim>::active_cell_iterator
      &cell,
    CellKind kind,
    CellMatrices<dim, spacedim> &cell_matrices,
    const CellMaterial &material);


  /** The deformed states that fits shall suit. */
  struct ReferenceStates
  {
    /** F of homogeneous deformations, dim x dim; of bodies only. */
    std::vector<Eigen::MatrixXd> deformation_gradients;

    /** Of the finite elements. */
    MaterialLaw material_law;

    /** Of the springs. */
    SpringLaw spring_law;
  };


  struct TimedFit
  {
    FitResult result;
    double seconds;
  };

  std::vector<CellModel>
  models_of(const std::vector<TimedFit> &fits);

  /**
   * Fit every distinct cell of a mesh; the ranks share the work evenly.
   * Collective.
   *
   * @param name of the fit, for messages
   * @return by position in cells.distinct, on all ranks
   *
   * @throws RunError when a fit fails or its certified gap exceeds the
   * tolerance, with the cell, its place and its shape quality.
   */
  template <int dim, int spacedim>
  std::vector<TimedFit>
  fit_distinct_cells(const DistinctCells &cells,
                     const Mesh<dim, spacedim> &mesh,
                     const Element<dim, spacedim> &element,
                     const MaterialTable &materials,
                     const Method &method,
                     const FitOptions &options,
                     const ReferenceStates &states,
                     const std::string &name,
                     Session &session);
} // namespace springfit

#endif
