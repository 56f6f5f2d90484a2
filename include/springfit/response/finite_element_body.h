#ifndef springfit_response_finite_element_body_h
#define springfit_response_finite_element_body_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/cell_energy.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/reference/material_law.h>
#include <springfit/response/elastic_body.h>
#include <springfit/springs/tangent_matrix.h>
#include <springfit/springs/tangent_operator.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace springfit
{
  /** The finite elements of a mesh as a body. */
  template <int dim, int spacedim = dim>
  class FiniteElementBody : public BodyOfMembers
  {
  public:
    using Cell = typename CellEnergy<dim, spacedim>::Cell;

    /** @p mesh and @p element must outlive the object. */
    FiniteElementBody(const Mesh<dim, spacedim> &mesh,
                      const Element<dim, spacedim> &element,
                      const MaterialTable &materials,
                      MaterialLaw law);

    /** Of some cells of the mesh. */
    FiniteElementBody(const Mesh<dim, spacedim> &mesh,
                      std::vector<Cell> cells,
                      const Element<dim, spacedim> &element,
                      const MaterialTable &materials,
                      MaterialLaw law);

    double
    energy(const Eigen::MatrixXd &displacement) const override;

    void
    add_forces(const Eigen::MatrixXd &displacement,
               Eigen::MatrixXd &forces) const override;

    void
    add_tangent_product(const Eigen::MatrixXd &displacement,
                        const Eigen::MatrixXd &u,
                        Eigen::MatrixXd &product) const override;

    std::unique_ptr<TangentOperator>
    tangent_operator() const override;

    void
    add_tangent(const Eigen::MatrixXd &displacement,
                TangentMatrix &tangent) const override;

    void
    add_convex_tangent(const Eigen::MatrixXd &displacement,
                       TangentMatrix &tangent) const override;

    void
    add_to_pattern(NodePattern &pattern) const override;

    std::unique_ptr<const BodyOfMembers>
    share(const std::vector<bool> &nodes) const override;

    std::unique_ptr<const BodyOfMembers>
    touching(const std::vector<bool> &nodes) const override;

  private:
    const CellMaterial &
    material_of(std::size_t c) const;

    /** Of cells_[c]; nothing where it has no finite energy. */
    std::optional<EnergyTerm>
    term(std::size_t c, const Eigen::MatrixXd &displacement) const;

    /** Calls @p f with the energy term of each cell; of finite energy. */
    template <typename F>
    void
    for_each_term(const Eigen::MatrixXd &displacement, const F &f) const;

    const Mesh<dim, spacedim> &mesh_;
    const std::vector<Cell> cells_;
    const Element<dim, spacedim> &element_;
    const MaterialTable materials_;
    const MaterialLaw law_;

    // deal.II's values move from cell to cell.
    mutable CellEnergy<dim, spacedim> cell_energy_;

    /** Of all cells, unless the law is linear. */
    std::vector<RestShape<dim, spacedim>> shapes_;
  };


  /**
   * The number of cells that a displacement (m, spacedim x n_nodes) turns
   * inside out: det F <= 0 at a quadrature point.
   */
  template <int dim, int spacedim>
  unsigned int
  n_inverted_cells(const Mesh<dim, spacedim> &mesh,
                   const Element<dim, spacedim> &element,
                   const Eigen::MatrixXd &displacement);
} // namespace springfit

#endif
