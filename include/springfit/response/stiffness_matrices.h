#ifndef springfit_response_stiffness_matrices_h
#define springfit_response_stiffness_matrices_h

#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/response/discretization.h>
#include <springfit/springs/network.h>

namespace springfit
{
  /** The finite element model's stiffness; fixed rows become diagonal. */
  template <int dim>
  void
  assemble_finite_elements(const Discretization<dim> &discretization,
                           const Element<dim> &element,
                           const MaterialTable &materials,
                           typename Discretization<dim>::Matrix &matrix);

  /**
   * The network's tangent at rest: sum of k n n^T over its springs
   * (Natsupakpong and Cavusoglu 2010); fixed rows become diagonal.
   */
  template <int dim>
  void
  assemble_springs(const Discretization<dim> &discretization,
                   const SpringNetwork &network,
                   typename Discretization<dim>::Matrix &matrix);
} // namespace springfit

#endif
