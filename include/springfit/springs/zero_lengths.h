#ifndef springfit_springs_zero_lengths_h
#define springfit_springs_zero_lengths_h

#include <springfit/springs/family.h>

namespace springfit
{
  /**
   * Springs of rest length zero between two nodes, energy k l^2 / 2 with their
   * distance l. Columns k (N/m) and rest_length, which is 0. The force is
   * linear in the places of the nodes; a negative k pushes.
   *
   * With k_ab = - mu times the integral of grad N_a . grad N_b over a cell they
   * have the energy of mu / 2 tr (F^T F) in it, see
   * fit/cell/stable_neo_hookean.h.
   */
  const SpringKind &
  zero_lengths(int dim);
} // namespace springfit

#endif
