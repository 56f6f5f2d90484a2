#include <springfit/core/energy_term.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/springs/positive_part.h>

#include <deal.II/base/exceptions.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

namespace springfit
{
  namespace
  {
    template <int dim, int spacedim>
    std::vector<typename CellEnergy<dim, spacedim>::Cell>
    all_cells(const Mesh<dim, spacedim> &mesh)
    {
      std::vector<typename CellEnergy<dim, spacedim>::Cell> cells;
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        cells.push_back(cell);
      return cells;
    }

    /** Adds a Hessian of some nodes times their part of @p u. */
    template <int dim>
    void
    add_products(const std::vector<unsigned int> &nodes,
                 const Eigen::MatrixXd &hessian,
                 const Eigen::MatrixXd &u,
                 Eigen::MatrixXd &product)
    {
      Eigen::VectorXd of_nodes(hessian.cols());
      for (std::size_t a = 0; a < nodes.size(); ++a)
        of_nodes.segment<dim>(dim * a) = u.col(nodes[a]);
      const Eigen::VectorXd forces = hessian * of_nodes;
      for (std::size_t a = 0; a < nodes.size(); ++a)
        product.col(nodes[a]) += forces.segment<dim>(dim * a);
    }

    /** Keeps the Hessians of all cells. */
    template <int dim>
    class CellsOperator : public TangentOperator
    {
    public:
      /** Calls its second argument with the energy terms at the first. */
      using ForEachTerm =
        std::function<void(const Eigen::MatrixXd &,
                           const std::function<void(const EnergyTerm &)> &)>;

      explicit CellsOperator(ForEachTerm for_each_term)
        : for_each_term_(std::move(for_each_term))
      {}

      void
      linearise(const Eigen::MatrixXd &state) override
      {
        hessians_.clear();
        for_each_term_(state, [&](const EnergyTerm &term) {
          hessians_.emplace_back(term.nodes, term.hessian);
        });
      }

      void
      add_product(const Eigen::MatrixXd &u,
                  Eigen::MatrixXd &product) const override
      {
        for (const auto &[nodes, hessian] : hessians_)
          add_products<dim>(nodes, hessian, u, product);
      }

    private:
      const ForEachTerm for_each_term_;
      std::vector<std::pair<std::vector<unsigned int>, Eigen::MatrixXd>>
        hessians_;
    };

    template <int dim>
    void
    add_blocks(const std::vector<unsigned int> &nodes,
               const Eigen::MatrixXd &hessian,
               TangentMatrix &tangent)
    {
      for (std::size_t b = 0; b < nodes.size(); ++b)
        for (std::size_t a = 0; a < nodes.size(); ++a)
          tangent.add(nodes[a],
                      nodes[b],
                      hessian.block<dim, dim>(dim * a, dim * b).eval());
    }
  } // namespace

  template <int dim, int spacedim>
  FiniteElementBody<dim, spacedim>::FiniteElementBody(
    const Mesh<dim, spacedim> &mesh,
    const Element<dim, spacedim> &element,
    const MaterialTable &materials,
    const MaterialLaw law)
    : FiniteElementBody(mesh, all_cells(mesh), element, materials, law)
  {}

  template <int dim, int spacedim>
  FiniteElementBody<dim, spacedim>::FiniteElementBody(
    const Mesh<dim, spacedim> &mesh,
    std::vector<Cell> cells,
    const Element<dim, spacedim> &element,
    const MaterialTable &materials,
    const MaterialLaw law)
    : mesh_(mesh)
    , cells_(std::move(cells))
    , element_(element)
    , materials_(materials)
    , law_(law)
    , cell_energy_(element)
  {
    if (law != MaterialLaw::linear)
      for (const auto &cell : cells_)
        shapes_.push_back(cell_energy_.rest_shape(cell));
  }

  template <int dim, int spacedim>
  const CellMaterial &
  FiniteElementBody<dim, spacedim>::material_of(const std::size_t c) const
  {
    return materials_.at(cells_[c]->material_id());
  }

  template <int dim, int spacedim>
  std::optional<EnergyTerm>
  FiniteElementBody<dim, spacedim>::term(
    const std::size_t c,
    const Eigen::MatrixXd &displacement) const
  {
    const auto &nodes              = mesh_.nodes.of(cells_[c]);
    const Eigen::MatrixXd of_nodes = displacement(Eigen::all, nodes);
    auto term =
      law_ == MaterialLaw::linear
        ? cell_energy_.evaluate(law_, cells_[c], material_of(c), of_nodes)
        : energy_term(shapes_[c], law_, material_of(c), of_nodes);
    if (term)
      term->nodes = nodes;
    return term;
  }

  template <int dim, int spacedim>
  template <typename F>
  void
  FiniteElementBody<dim, spacedim>::for_each_term(
    const Eigen::MatrixXd &displacement,
    const F &f) const
  {
    for (std::size_t c = 0; c < cells_.size(); ++c)
      {
        const auto of_cell = term(c, displacement);
        Assert(of_cell, dealii::ExcMessage("The state has no finite energy."));
        f(*of_cell);
      }
  }

  template <int dim, int spacedim>
  double
  FiniteElementBody<dim, spacedim>::energy(
    const Eigen::MatrixXd &displacement) const
  {
    double sum = 0.;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (law_ == MaterialLaw::linear)
        sum += term(c, displacement)->energy;
      else
        {
          const auto of_cell =
            springfit::energy(shapes_[c],
                              law_,
                              material_of(c),
                              displacement(Eigen::all,
                                           mesh_.nodes.of(cells_[c])));
          if (!of_cell)
            return std::numeric_limits<double>::infinity();
          sum += *of_cell;
        }
    return sum;
  }

  template <int dim, int spacedim>
  void
  FiniteElementBody<dim, spacedim>::add_forces(
    const Eigen::MatrixXd &displacement,
    Eigen::MatrixXd &forces) const
  {
    for (std::size_t c = 0; c < cells_.size(); ++c)
      {
        const auto &nodes = mesh_.nodes.of(cells_[c]);
        Eigen::MatrixXd gradient;
        if (law_ == MaterialLaw::linear)
          gradient =
            term(c, displacement)->gradient.reshaped(spacedim, nodes.size());
        else
          {
            const auto of_cell =
              energy_gradient(shapes_[c],
                              law_,
                              material_of(c),
                              displacement(Eigen::all, nodes));
            Assert(of_cell,
                   dealii::ExcMessage("The state has no finite energy."));
            gradient = *of_cell;
          }
        for (std::size_t a = 0; a < nodes.size(); ++a)
          forces.col(nodes[a]) -= gradient.col(a);
      }
  }

  template <int dim, int spacedim>
  void
  FiniteElementBody<dim, spacedim>::add_tangent_product(
    const Eigen::MatrixXd &displacement,
    const Eigen::MatrixXd &u,
    Eigen::MatrixXd &product) const
  {
    for_each_term(displacement, [&](const EnergyTerm &term) {
      add_products<spacedim>(term.nodes, term.hessian, u, product);
    });
  }

  template <int dim, int spacedim>
  std::unique_ptr<TangentOperator>
  FiniteElementBody<dim, spacedim>::tangent_operator() const
  {
    return std::make_unique<CellsOperator<spacedim>>(
      [this](const Eigen::MatrixXd &displacement, const auto &f) {
        for_each_term(displacement, f);
      });
  }

  template <int dim, int spacedim>
  void
  FiniteElementBody<dim, spacedim>::add_tangent(
    const Eigen::MatrixXd &displacement,
    TangentMatrix &tangent) const
  {
    for_each_term(displacement, [&](const EnergyTerm &term) {
      add_blocks<spacedim>(term.nodes, term.hessian, tangent);
    });
  }

  template <int dim, int spacedim>
  void
  FiniteElementBody<dim, spacedim>::add_convex_tangent(
    const Eigen::MatrixXd &displacement,
    TangentMatrix &tangent) const
  {
    for_each_term(displacement, [&](const EnergyTerm &term) {
      add_blocks<spacedim>(term.nodes, positive_part(term.hessian), tangent);
    });
  }

  template <int dim, int spacedim>
  void
  FiniteElementBody<dim, spacedim>::add_to_pattern(NodePattern &pattern) const
  {
    for (const auto &cell : cells_)
      {
        const auto &nodes = mesh_.nodes.of(cell);
        pattern.add_clique(nodes.data(), nodes.size());
      }
  }

  template <int dim, int spacedim>
  std::unique_ptr<const BodyOfMembers>
  FiniteElementBody<dim, spacedim>::share(const std::vector<bool> &nodes) const
  {
    std::vector<Cell> mine;
    for (const auto &cell : cells_)
      if (nodes[mesh_.nodes.of(cell)[0]])
        mine.push_back(cell);
    return std::make_unique<FiniteElementBody<dim, spacedim>>(
      mesh_, std::move(mine), element_, materials_, law_);
  }

  template <int dim, int spacedim>
  std::unique_ptr<const BodyOfMembers>
  FiniteElementBody<dim, spacedim>::touching(
    const std::vector<bool> &nodes) const
  {
    std::vector<Cell> touching;
    for (const auto &cell : cells_)
      for (const unsigned int v : mesh_.nodes.of(cell))
        if (nodes[v])
          {
            touching.push_back(cell);
            break;
          }
    return std::make_unique<FiniteElementBody<dim, spacedim>>(
      mesh_, std::move(touching), element_, materials_, law_);
  }

  template <int dim, int spacedim>
  unsigned int
  n_inverted_cells(const Mesh<dim, spacedim> &mesh,
                   const Element<dim, spacedim> &element,
                   const Eigen::MatrixXd &displacement)
  {
    CellEnergy<dim, spacedim> energy(element);
    unsigned int n = 0;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      if (!(energy.smallest_jacobian(
              cell, displacement(Eigen::all, mesh.nodes.of(cell))) > 0.))
        ++n;
    return n;
  }

  template class FiniteElementBody<2>;
  template class FiniteElementBody<2, 3>;
  template class FiniteElementBody<3>;
  template unsigned int
  n_inverted_cells<2>(const Mesh<2> &,
                      const Element<2> &,
                      const Eigen::MatrixXd &);
  template unsigned int
  n_inverted_cells<2, 3>(const Mesh<2, 3> &,
                         const Element<2, 3> &,
                         const Eigen::MatrixXd &);
  template unsigned int
  n_inverted_cells<3>(const Mesh<3> &,
                      const Element<3> &,
                      const Eigen::MatrixXd &);
} // namespace springfit
