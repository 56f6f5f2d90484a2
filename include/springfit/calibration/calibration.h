#ifndef springfit_calibration_calibration_h
#define springfit_calibration_calibration_h

#include <springfit/core/session.h>
#include <springfit/fit/fit.h>
#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/springs/network.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace springfit
{
  enum class Enrichment
  {
    none
  };

  /** What a fit reached on one distinct cell. */
  struct CellFit
  {
    unsigned int cell; // active index of the first such cell of the mesh
    unsigned int multiplicity;
    FitResult result;
    double seconds;
  };

  /** A mesh turned into springs by one fit. */
  struct CalibratedNetwork
  {
    std::string fit;
    std::string enrichment;
    SpringNetwork network;
    std::vector<CellFit> cells;
    double seconds; // wall time of the calibration
  };


  /**
   * The section "Fit": for every distinct cell, the reference stiffness, the
   * springs' gradients and the fit; then the network of all cells.
   */
  template <int dim>
  class Calibration : public dealii::ParameterAcceptor
  {
  public:
    Calibration();

    /**
     * A network for each method asked for.
     *
     * @throws RunError when a fit fails or its certified gap exceeds the
     * tolerance, with the cell, its place and its shape quality.
     */
    std::vector<CalibratedNetwork>
    calibrate(const Mesh<dim> &mesh,
              const Element<dim> &element,
              const MaterialTable &materials,
              Session &session) const;

  private:
    void
    check() const;

    std::string methods_word_    = "frobenius, spectral";
    std::string enrichment_word_ = "none";
    std::string engine_word_     = "ipopt";
    FitOptions options_;
  };
} // namespace springfit

#endif
