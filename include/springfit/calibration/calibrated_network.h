#ifndef springfit_calibration_calibrated_network_h
#define springfit_calibration_calibrated_network_h

#include <springfit/calibration/object_scope.h>
#include <springfit/fit/fit.h>
#include <springfit/springs/network.h>

#include <string>
#include <vector>

namespace springfit
{
  /** What a fit reached on one distinct cell. */
  struct CellFit
  {
    unsigned int cell; // active index of the first such cell of the mesh
    unsigned int multiplicity;
    FitResult result;
    double seconds;
  };

  /** The springs of a mesh, and what their fit reached. */
  struct FittedNetwork
  {
    SpringNetwork network;

    /** Of scope object a single one, which stands for the object. */
    std::vector<CellFit> cells;
  };

  /** A mesh turned into springs by one fit. */
  struct CalibratedNetwork : FittedNetwork
  {
    /**
     * What files and tables call it: <fit>, or <fit>_<enrichment> where it has
     * an enrichment.
     */
    std::string name;

    std::string fit;
    std::string enrichment;

    /** What the unknowns of the fit were. */
    Scope scope;

    /** Whether its fit has Feature::finite_element. */
    bool is_finite_element;

    /** Whether it was made with responses to the scene's loads. */
    bool is_trained;

    double seconds; // wall time of the calibration
  };
} // namespace springfit

#endif
