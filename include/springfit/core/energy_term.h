#ifndef springfit_core_energy_term_h
#define springfit_core_energy_term_h

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /**
   * A part of a body's elastic energy that depends on a few nodes only: the
   * energy of a spring, of a cell. Entry dim * a + d of the gradient belongs to
   * component d of the displacement of nodes[a]; a node may occur twice.
   */
  struct EnergyTerm
  {
    std::vector<unsigned int> nodes;

    double energy;            // J
    Eigen::VectorXd gradient; // N: the forces that hold the state
    Eigen::MatrixXd hessian;  // N/m: the tangent stiffness, symmetric
  };
} // namespace springfit

#endif
