#ifndef springfit_calibration_mechanisms_h
#define springfit_calibration_mechanisms_h

#include <springfit/calibration/calibrated_network.h>
#include <springfit/core/session.h>

#include <string>

namespace springfit
{
  /**
   * Warn of nodes and of larger parts of an object that its springs do not
   * hold, where they are, and of what helps.
   *
   * Cells that are no mechanisms make none together: the mesh was checked for
   * hinges. Only a network with a cell that is one, or one whose cells were not
   * fitted singly, is examined, by factorisations; of the largest ones the
   * nodes alone are.
   *
   * @param name what the message calls the fit
   */
  void
  warn_of_mechanisms(const FittedNetwork &fitted,
                     const std::string &name,
                     Session &session);
} // namespace springfit

#endif
