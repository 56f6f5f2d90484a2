#ifndef springfit_response_finite_element_body_h
#define springfit_response_finite_element_body_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/cell_energy.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/reference/material_law.h>
#include <springfit/response/elastic_body.h>

#include <vector>

namespace springfit
{
  /** The finite elements of a mesh as a body: a term for each cell. */
  template <int dim>
  class FiniteElementBody : public ElasticBody
  {
  public:
    /** @p mesh must outlive the object. */
    FiniteElementBody(const Mesh<dim> &mesh,
                      const Element<dim> &element,
                      const MaterialTable &materials,
                      MaterialLaw law);

    unsigned int
    n_terms() const override;

    unsigned int
    first_node(unsigned int term) const override;

    std::optional<EnergyTerm>
    evaluate(unsigned int term,
             const Eigen::MatrixXd &displacement) const override;

  private:
    const MaterialTable materials_;
    std::vector<typename CellEnergy<dim>::Cell> cells_;

    // deal.II's values move from cell to cell.
    mutable CellEnergy<dim> energy_;
  };


  /**
   * The number of cells that a displacement (m, dim x n_nodes) turns inside
   * out: det F <= 0 at a quadrature point.
   */
  template <int dim>
  unsigned int
  n_inverted_cells(const Mesh<dim> &mesh,
                   const Element<dim> &element,
                   const Eigen::MatrixXd &displacement);
} // namespace springfit

#endif
