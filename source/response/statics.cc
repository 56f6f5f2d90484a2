#include <springfit/core/error.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/response/linear_model.h>
#include <springfit/response/model_words.h>
#include <springfit/response/network_body.h>
#include <springfit/response/nonlinear_model.h>
#include <springfit/response/stability.h>
#include <springfit/response/statics.h>

#include <sstream>
#include <utility>

namespace springfit
{
  namespace
  {
    // From how many unknowns on "automatic" means conjugate gradients. Networks
    // with negative springs want factors as long as these are affordable;
    // Newton's method needs many of them, and has the convex tangent.
    template <int spacedim>
    constexpr unsigned int smallest_cg_linear = spacedim == 2 ? 100000 : 10000;

    template <int spacedim>
    constexpr unsigned int smallest_cg_nonlinear = spacedim == 2 ? 20000 : 1500;

    const WordTable<SolverChoice> &
    solver_words()
    {
      static const WordTable<SolverChoice> table = {
        {SolverChoice::automatic, "automatic"},
        {SolverChoice::direct, "direct"},
        {SolverChoice::cg, "cg"}};
      return table;
    }

    /** Why a state of such cells is none to go on from. */
    template <int dim, int spacedim>
    std::string
    objection_to_inversion(const Mesh<dim, spacedim> &mesh,
                           const Element<dim, spacedim> &element,
                           const Eigen::MatrixXd &displacement)
    {
      const unsigned int n = n_inverted_cells(mesh, element, displacement);
      if (n == 0)
        return {};
      return std::to_string(n) + " of " +
             std::to_string(mesh.triangulation.n_active_cells()) +
             " cells turn inside out";
    }

    /**
     * Why a state is no equilibrium to go on from.
     *
     * @param entries_of_a_node relative to linear elements
     */
    template <int spacedim>
    std::string
    objection_to_instability(const Discretization<spacedim> &discretization,
                             const unsigned int entries_of_a_node,
                             const ElasticBody &body,
                             const Eigen::MatrixXd &displacement)
    {
      // Counting takes a direct factorisation: too much for the largest ones.
      constexpr unsigned int most_nodes = spacedim == 2 ? 50000 : 5000;
      if (discretization.n_nodes() * entries_of_a_node <= most_nodes)
        if (const unsigned int n =
              n_unstable_motions(body, displacement, discretization.held());
            n > 0)
          return "it is unstable (buckles), " + std::to_string(n) +
                 " of its motions release energy";
      return {};
    }
  } // namespace

  const WordTable<Kinematics> &
  kinematics_words()
  {
    static const WordTable<Kinematics> table = {{Kinematics::linear, "linear"},
                                                {Kinematics::nonlinear,
                                                 "nonlinear"}};
    return table;
  }

  template <int spacedim>
  Statics<spacedim>::Statics() : dealii::ParameterAcceptor("Response")
  {
    add_parameter("Kinematics",
                  kinematics_words_,
                  "How the springs answer: " +
                    join(words_of(kinematics_words()), " or ") +
                    ", or both between commas, each a row of the tables (no "
                    "unit). Linear is the tangent at rest, nonlinear the true "
                    "forces of the springs at any deformation.");
    add_parameter("Material law",
                  law_word_,
                  "How the finite elements answer that the springs are "
                  "compared with: " +
                    join(words_of(material_law_words()), " or ") +
                    " (no unit). The loads are scaled by the linear one.");
    add_parameter("Solver",
                  solver_word_,
                  "Solver of the linear systems: " +
                    join(words_of(solver_words()), " or ") +
                    " (no unit). Direct is Trilinos' KLU, cg conjugate "
                    "gradients with algebraic multigrid; automatic takes cg "
                    "from 100,000 unknowns in 2-d and 10,000 in 3-d, for "
                    "nonlinear responses from 20,000 and 1,500.");
    add_parameter("Tolerance",
                  tolerance_,
                  "For cg and for nonlinear responses: the forces left over, "
                  "relative to the load (no unit), between 1e-15 and 1e-6.");
  }

  template <int spacedim>
  std::vector<Kinematics>
  Statics<spacedim>::kinematics() const
  {
    return values_of(kinematics_words(),
                     kinematics_words_,
                     "Response/Kinematics");
  }

  template <int spacedim>
  MaterialLaw
  Statics<spacedim>::material_law() const
  {
    return value_of(material_law_words(), law_word_, "Response/Material law");
  }

  template <int spacedim>
  void
  Statics<spacedim>::check() const
  {
    kinematics();
    material_law();
    value_of(solver_words(), solver_word_, "Response/Solver");
    if (!(tolerance_ >= 1e-15 && tolerance_ <= 1e-6))
      {
        std::ostringstream value;
        value << tolerance_;
        throw EntryError("Response/Tolerance",
                         value.str() + " is out of range.",
                         "Give a number between 1e-15 and 1e-6.");
      }
  }

  template <int spacedim>
  SolverFactory<spacedim>
  Statics<spacedim>::solver_factory(
    const Discretization<spacedim> &discretization,
    const unsigned int smallest_cg) const
  {
    const auto choice =
      value_of(solver_words(), solver_word_, "Response/Solver");
    const double tolerance = tolerance_;
    return
      [&discretization, choice, tolerance, smallest_cg](const auto &matrix) {
        if (choice == SolverChoice::direct ||
            (choice == SolverChoice::automatic && matrix.m() < smallest_cg))
          return make_direct_solver<spacedim>(matrix);
        return make_cg_solver<spacedim>(discretization, matrix, tolerance);
      };
  }

  template <int spacedim>
  std::unique_ptr<Model>
  Statics<spacedim>::linear(const Discretization<spacedim> &discretization,
                            const BodyOfMembers &body,
                            const ModelWords &words) const
  {
    return std::make_unique<LinearModel<spacedim>>(
      discretization, body, linear_solvers(discretization), words);
  }

  template <int spacedim>
  template <int dim>
  std::unique_ptr<Model>
  Statics<spacedim>::nonlinear(const Discretization<spacedim> &discretization,
                               const Mesh<dim, spacedim> &mesh,
                               const Element<dim, spacedim> &element,
                               std::unique_ptr<const BodyOfMembers> body,
                               const InvertedCells inverted_cells,
                               const ModelWords &words) const
  {
    const BodyOfMembers &judged = *body;
    const auto judge            = [&discretization,
                        &mesh,
                        &element,
                        &judged,
                        inverted_cells](const Eigen::MatrixXd &displacement) {
      std::string objection;
      if (inverted_cells == InvertedCells::refused)
        objection = objection_to_inversion(mesh, element, displacement);
      return objection.empty()
                          ? objection_to_instability(discretization,
                                          mesh.nodes.degree * mesh.nodes.degree,
                                          judged,
                                          displacement)
                          : objection;
    };
    return std::make_unique<NonlinearModel<spacedim>>(
      discretization,
      std::move(body),
      solver_factory(discretization, smallest_cg_nonlinear<spacedim>),
      words,
      judge,
      tolerance_);
  }

  template <int spacedim>
  template <int dim>
  std::unique_ptr<Model>
  Statics<spacedim>::finite_elements(
    const Discretization<spacedim> &discretization,
    const Mesh<dim, spacedim> &mesh,
    const Element<dim, spacedim> &element,
    const MaterialTable &materials) const
  {
    return finite_elements_of(
      material_law(), discretization, mesh, element, materials);
  }

  template <int spacedim>
  template <int dim>
  std::unique_ptr<Model>
  Statics<spacedim>::finite_elements_of(
    const MaterialLaw law,
    const Discretization<spacedim> &discretization,
    const Mesh<dim, spacedim> &mesh,
    const Element<dim, spacedim> &element,
    const MaterialTable &materials) const
  {
    auto body = std::make_unique<FiniteElementBody<dim, spacedim>>(mesh,
                                                                   element,
                                                                   materials,
                                                                   law);
    if (law == MaterialLaw::linear)
      return linear(discretization,
                    *body,
                    words_of_finite_elements(dim < spacedim));
    return nonlinear(discretization,
                     mesh,
                     element,
                     std::move(body),
                     law == MaterialLaw::stable_neo_hookean
                       ? InvertedCells::accepted
                       : InvertedCells::refused,
                     words_of_nonlinear_finite_elements(law));
  }

  template <int spacedim>
  template <int dim>
  std::unique_ptr<Model>
  Statics<spacedim>::body(const Discretization<spacedim> &discretization,
                          const Mesh<dim, spacedim> &mesh,
                          const Element<dim, spacedim> &element,
                          std::unique_ptr<const BodyOfMembers> body,
                          const ModelWords &words,
                          const Kinematics kinematics) const
  {
    if (kinematics == Kinematics::linear)
      return linear(discretization, *body, words);
    return nonlinear(discretization,
                     mesh,
                     element,
                     std::move(body),
                     InvertedCells::accepted,
                     words);
  }

  template <int spacedim>
  SolverFactory<spacedim>
  Statics<spacedim>::linear_solvers(
    const Discretization<spacedim> &discretization) const
  {
    return solver_factory(discretization, smallest_cg_linear<spacedim>);
  }

  template <int spacedim>
  template <int dim>
  std::unique_ptr<Model>
  Statics<spacedim>::springs(const Discretization<spacedim> &discretization,
                             const Mesh<dim, spacedim> &mesh,
                             const Element<dim, spacedim> &element,
                             const SpringNetwork &network,
                             const std::string &name,
                             const Kinematics kinematics) const
  {
    auto body = std::make_unique<NetworkBody>(network);
    if (kinematics == Kinematics::linear)
      return linear(discretization, *body, words_of_springs(name, network));
    return nonlinear(discretization,
                     mesh,
                     element,
                     std::move(body),
                     bear_inversion(network.families) ? InvertedCells::accepted
                                                      : InvertedCells::refused,
                     words_of_nonlinear_springs(name, network));
  }

  template class Statics<2>;
  template class Statics<3>;
  template std::unique_ptr<Model>
  Statics<2>::finite_elements(const Discretization<2> &,
                              const Mesh<2> &,
                              const Element<2> &,
                              const MaterialTable &) const;
  template std::unique_ptr<Model>
  Statics<2>::finite_elements_of(MaterialLaw,
                                 const Discretization<2> &,
                                 const Mesh<2> &,
                                 const Element<2> &,
                                 const MaterialTable &) const;
  template std::unique_ptr<Model>
  Statics<2>::body(const Discretization<2> &,
                   const Mesh<2> &,
                   const Element<2> &,
                   std::unique_ptr<const BodyOfMembers>,
                   const ModelWords &,
                   Kinematics) const;
  template std::unique_ptr<Model>
  Statics<2>::springs(const Discretization<2> &,
                      const Mesh<2> &,
                      const Element<2> &,
                      const SpringNetwork &,
                      const std::string &,
                      Kinematics) const;
  template std::unique_ptr<Model>
  Statics<3>::finite_elements(const Discretization<3> &,
                              const Mesh<2, 3> &,
                              const Element<2, 3> &,
                              const MaterialTable &) const;
  template std::unique_ptr<Model>
  Statics<3>::finite_elements_of(MaterialLaw,
                                 const Discretization<3> &,
                                 const Mesh<2, 3> &,
                                 const Element<2, 3> &,
                                 const MaterialTable &) const;
  template std::unique_ptr<Model>
  Statics<3>::body(const Discretization<3> &,
                   const Mesh<2, 3> &,
                   const Element<2, 3> &,
                   std::unique_ptr<const BodyOfMembers>,
                   const ModelWords &,
                   Kinematics) const;
  template std::unique_ptr<Model>
  Statics<3>::springs(const Discretization<3> &,
                      const Mesh<2, 3> &,
                      const Element<2, 3> &,
                      const SpringNetwork &,
                      const std::string &,
                      Kinematics) const;
  template std::unique_ptr<Model>
  Statics<3>::finite_elements(const Discretization<3> &,
                              const Mesh<3> &,
                              const Element<3> &,
                              const MaterialTable &) const;
  template std::unique_ptr<Model>
  Statics<3>::finite_elements_of(MaterialLaw,
                                 const Discretization<3> &,
                                 const Mesh<3> &,
                                 const Element<3> &,
                                 const MaterialTable &) const;
  template std::unique_ptr<Model>
  Statics<3>::body(const Discretization<3> &,
                   const Mesh<3> &,
                   const Element<3> &,
                   std::unique_ptr<const BodyOfMembers>,
                   const ModelWords &,
                   Kinematics) const;
  template std::unique_ptr<Model>
  Statics<3>::springs(const Discretization<3> &,
                      const Mesh<3> &,
                      const Element<3> &,
                      const SpringNetwork &,
                      const std::string &,
                      Kinematics) const;
} // namespace springfit
