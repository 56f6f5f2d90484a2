#ifndef springfit_response_stability_h
#define springfit_response_stability_h

#include <springfit/springs/network.h>

#include <vector>

namespace springfit
{
  /**
   * The number of independent motions of a held network at rest that release
   * energy, or cost none: the eigenvalues <= 0 of its tangent, counted by the
   * signs of a sparse L D L^T factorisation (Sylvester's law of inertia). 0 is
   * a stable network; springs of negative stiffness can make it unstable.
   *
   * @p fixed has a flag per node.
   */
  unsigned int
  n_unstable_motions(const SpringNetwork &network,
                     const std::vector<bool> &fixed);
} // namespace springfit

#endif
