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
     * The vertices of the reference cell with equal weights: on a simplex and
     * on a hypercube alike this is the rule of the lumped mass matrix.
     */
    template <int dim, int spacedim>
    dealii::Quadrature<dim>
    vertex_rule(const dealii::FiniteElement<dim, spacedim> &element)
    {
      const auto &points = element.get_unit_support_points();
      std::vector<double> weights(points.size(),
                                  element.reference_cell().volume() /
                                    points.size());
      return dealii::Quadrature<dim>(points, weights);
    }
  } // namespace

  template <int dim, int spacedim>
  Element<dim, spacedim>
  make_element(const CellKind kind)
  {
    Element<dim, spacedim> element;
    if (is_simplex(kind))
      {
        const dealii::FE_SimplexP<dim, spacedim> p1(1);
        element.mapping =
          std::make_unique<dealii::MappingFE<dim, spacedim>>(p1);
        element.quadrature      = dealii::QGaussSimplex<dim>(1);
        element.face_quadrature = dealii::QGaussSimplex<dim - 1>(2);
        element.scalar          = p1.clone();
      }
    else
      {
        element.mapping = std::make_unique<dealii::MappingQ1<dim, spacedim>>();
        element.quadrature      = dealii::QGauss<dim>(2);
        element.face_quadrature = dealii::QGauss<dim - 1>(2);
        element.scalar = std::make_unique<dealii::FE_Q<dim, spacedim>>(1);
      }
    element.nodal_quadrature = vertex_rule(*element.scalar);
    return element;
  }

  template Element<2> make_element<2>(CellKind);
  template Element<2, 3> make_element<2, 3>(CellKind);
  template Element<3> make_element<3>(CellKind);
} // namespace springfit
