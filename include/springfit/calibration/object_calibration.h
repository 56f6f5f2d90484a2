#ifndef springfit_calibration_object_calibration_h
#define springfit_calibration_object_calibration_h

#include <springfit/calibration/calibrated_network.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/calibration/object_scope.h>
#include <springfit/core/session.h>
#include <springfit/fit/fit.h>
#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/springs/spring_law.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /**
   * Fit all springs of a mesh at once. Warns of springs that are unstable.
   *
   * With FitOptions::nonnegative the constants are moved towards those of the
   * same fit of the cells, where they would be unstable for their volumes or
   * angles (to 90 % of the way to instability from there, with a warning) or
   * where springs that are zero leave a mechanism (3 % of the way). What a fit
   * minimises is convex, so that it is never more than with the fits of the
   * cells. Collective.
   *
   * @param cells every_cell() of the mesh
   * @param method one with a Method::fit_object
   * @param fields, responses see displacement_fields(); of the consistent fit
   * @param name of the fit, for messages
   *
   * @throws RunError as fit_object() does.
   */
  template <int dim>
  FittedNetwork
  calibrate_object(const DistinctCells &cells,
                   const Mesh<dim> &mesh,
                   const Element<dim> &element,
                   const MaterialTable &materials,
                   const Method &method,
                   const FitOptions &options,
                   SpringLaw law,
                   const std::vector<Field> &fields,
                   const Eigen::MatrixXd &responses,
                   const std::string &name,
                   Session &session);
} // namespace springfit

#endif
