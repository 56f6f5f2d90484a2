#ifndef springfit_reference_element_h
#define springfit_reference_element_h

#include <springfit/core/cell_kind.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping.h>

#include <memory>

namespace springfit
{
  /**
   * What deal.II needs to integrate on the cells of one kind: the scalar
   * element (P1 or Q1, of degree 2 P2 or Q2), the mapping of cells with
   * straight edges, and quadratures that are exact for its stiffness on affine
   * cells.
   */
  template <int dim, int spacedim = dim>
  struct Element
  {
    std::unique_ptr<dealii::FiniteElement<dim, spacedim>> scalar;
    std::unique_ptr<dealii::Mapping<dim, spacedim>> mapping;
    dealii::Quadrature<dim> quadrature;
    dealii::Quadrature<dim - 1> face_quadrature;

    /**
     * The element's nodes, in their order, with the integrals of their shape
     * functions.
     */
    dealii::Quadrature<dim> nodal_quadrature;
  };

  template <int dim, int spacedim = dim>
  Element<dim, spacedim>
  make_element(CellKind kind, unsigned int degree = 1);
} // namespace springfit

#endif
