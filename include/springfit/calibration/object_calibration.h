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
   * Fit all springs of a mesh at once. Warns of springs that are unstable or
   * a mechanism.
   * Where with FitOptions::nonnegative they would be so, for their volumes or
   * angles, the constants are those 90 % of the way to instability from the fit
   * with all constants >= 0 towards them. Collective.
   *
   * @param cells every_cell() of the mesh
   * @param method one of object_methods()
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
