#ifndef springfit_motion_stiffness_spectrum_h
#define springfit_motion_stiffness_spectrum_h

#include <springfit/response/elastic_body.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /** The ends of the spectrum of a held body's tangent stiffness. */
  struct StiffnessSpectrum
  {
    double largest  = 0.; // N/m
    double smallest = 0.; // N/m; 0 of a mechanism

    /** Motions that release energy. */
    unsigned int n_negative = 0;

    /** Motions that cost none, up to rounding: 1e-13 of the largest. */
    unsigned int n_mechanisms = 0;
  };

  /**
   * That at a displacement (m, dim x n_nodes) of finite energy: all eigenvalues
   * of up to 500 unknowns; of more the signs by a sparse L D L^T factorisation
   * and the ends by Lanczos' method to 0.1 %, the smallest by solutions with
   * the factors.
   *
   * @param held a flag per unknown, dim * v + d
   */
  StiffnessSpectrum
  stiffness_spectrum(const ElasticBody &body,
                     const Eigen::MatrixXd &displacement,
                     const std::vector<bool> &held);
} // namespace springfit

#endif
