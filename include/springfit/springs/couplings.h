#ifndef springfit_springs_couplings_h
#define springfit_springs_couplings_h

#include <springfit/springs/family.h>
#include <springfit/springs/spring_law.h>

namespace springfit
{
  /**
   * Terms between the elongations q_a and q_b of two pairs of nodes, see
   * SpringLaw: energy stiffness q_a q_b. Nodes i_a < j_a, i_b < j_b, the pairs
   * in ascending order; columns stiffness (N/m), rest_length_a and
   * rest_length_b (m). By the law quadratic they have no derivatives where the
   * nodes of a pair coincide. The pairs need not be springs.
   */
  const SpringKind &
  couplings(int dim, SpringLaw law);
} // namespace springfit

#endif
