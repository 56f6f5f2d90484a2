#include <springfit/reference/element.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q1.h>

#include <vector>

namespace springfit
{
  namespace
  {
    /**
     * On simplices and hypercubes alike that of linear elements, of equal
     * weights, is the rule of the lumped mass matrix.
     */
    template <int dim, int spacedim>
    dealii::Quadrature<dim>
    nodal_rule(const dealii::FiniteElement<dim, spacedim> &element,
               const dealii::Quadrature<dim> &quadrature)
    {
      std::vector<double> weights(element.dofs_per_cell, 0.);
      for (unsigned int a = 0; a < weights.size(); ++a)
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          weights[a] +=
            quadrature.weight(q) * element.shape_value(a, quadrature.point(q));
      return dealii::Quadrature<dim>(element.get_unit_support_points(),
                                     weights);
    }
  } // namespace

  template <int dim, int spacedim>
  Element<dim, spacedim>
  make_element(const CellKind kind, const unsigned int degree)
  {
    // The square of a quadratic simplex' strain is of degree 2; hyperelastic
    // energies are not polynomials of few terms.
    const unsigned int n_points =
      is_simplex(kind) && degree == 1 ? 1 : degree + 1;
    Element<dim, spacedim> element;
    if (is_simplex(kind))
      {
        element.mapping = std::make_unique<dealii::MappingFE<dim, spacedim>>(
          dealii::FE_SimplexP<dim, spacedim>(1));
        element.quadrature      = dealii::QGaussSimplex<dim>(n_points);
        element.face_quadrature = dealii::QGaussSimplex<dim - 1>(degree + 1);
        element.scalar =
          std::make_unique<dealii::FE_SimplexP<dim, spacedim>>(degree);
      }
    else
      {
        element.mapping = std::make_unique<dealii::MappingQ1<dim, spacedim>>();
        element.quadrature      = dealii::QGauss<dim>(n_points);
        element.face_quadrature = dealii::QGauss<dim - 1>(degree + 1);
        element.scalar = std::make_unique<dealii::FE_Q<dim, spacedim>>(degree);
      }
    element.nodal_quadrature = nodal_rule(*element.scalar, element.quadrature);
    return element;
  }

  template Element<2>
  make_element<2>(CellKind, unsigned int);
  template Element<2, 3>
  make_element<2, 3>(CellKind, unsigned int);
  template Element<3>
  make_element<3>(CellKind, unsigned int);
} // namespace springfit
