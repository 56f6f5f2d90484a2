#ifndef springfit_response_statics_h
#define springfit_response_statics_h

#include <springfit/core/words.h>
#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/reference/material_law.h>
#include <springfit/response/discretization.h>
#include <springfit/response/elastic_body.h>
#include <springfit/response/linear_solver.h>
#include <springfit/response/model.h>
#include <springfit/springs/network.h>

#include <deal.II/base/parameter_acceptor.h>

#include <memory>
#include <string>
#include <vector>

namespace springfit
{
  enum class Kinematics
  {
    linear,
    nonlinear
  };

  const WordTable<Kinematics> &
  kinematics_words();


  enum class SolverChoice
  {
    automatic,
    direct,
    cg
  };


  /**
   * The section "Response": statics of both models on the same unknowns. What
   * is given to make a model must outlive it.
   */
  template <int spacedim>
  class Statics : public dealii::ParameterAcceptor
  {
  public:
    Statics();

    /** How the springs are to be computed: one or both. */
    std::vector<Kinematics>
    kinematics() const;

    MaterialLaw
    material_law() const;

    /** The finite elements with the material law asked for. */
    template <int dim>
    std::unique_ptr<Model>
    finite_elements(const Discretization<spacedim> &discretization,
                    const Mesh<dim, spacedim> &mesh,
                    const Element<dim, spacedim> &element,
                    const MaterialTable &materials) const;

    /** Those of any law; the linear ones scale the loads. */
    template <int dim>
    std::unique_ptr<Model>
    finite_elements_of(MaterialLaw law,
                       const Discretization<spacedim> &discretization,
                       const Mesh<dim, spacedim> &mesh,
                       const Element<dim, spacedim> &element,
                       const MaterialTable &materials) const;

    /**
     * Any body on the nodes of a mesh, which bears cells turned inside out.
     *
     * @param words for errors
     */
    template <int dim>
    std::unique_ptr<Model>
    body(const Discretization<spacedim> &discretization,
         const Mesh<dim, spacedim> &mesh,
         const Element<dim, spacedim> &element,
         std::unique_ptr<const BodyOfMembers> body,
         const ModelWords &words,
         Kinematics kinematics) const;

    /** For single systems with a matrix that is assembled. */
    SolverFactory<spacedim>
    linear_solvers(const Discretization<spacedim> &discretization) const;

    /** @p name is the fit's, for errors. */
    template <int dim>
    std::unique_ptr<Model>
    springs(const Discretization<spacedim> &discretization,
            const Mesh<dim, spacedim> &mesh,
            const Element<dim, spacedim> &element,
            const SpringNetwork &network,
            const std::string &name,
            Kinematics kinematics) const;

    /**
     * Check all values; for the studies that load something.
     *
     * @throws EntryError
     */
    void
    check() const;

  private:
    /** Whether an equilibrium of cells turned inside out is one. */
    enum class InvertedCells
    {
      refused,
      accepted
    };

    std::unique_ptr<Model>
    linear(const Discretization<spacedim> &discretization,
           const BodyOfMembers &body,
           const ModelWords &words) const;

    template <int dim>
    std::unique_ptr<Model>
    nonlinear(const Discretization<spacedim> &discretization,
              const Mesh<dim, spacedim> &mesh,
              const Element<dim, spacedim> &element,
              std::unique_ptr<const BodyOfMembers> body,
              InvertedCells inverted_cells,
              const ModelWords &words) const;

    /**
     * Makes the solver for a matrix, as asked for or by its size: by default
     * conjugate gradients from @p smallest_cg unknowns on.
     */
    SolverFactory<spacedim>
    solver_factory(const Discretization<spacedim> &discretization,
                   unsigned int smallest_cg) const;

    std::string kinematics_words_ = "linear";
    std::string law_word_         = "linear";
    std::string solver_word_      = "automatic";
    double tolerance_             = 1e-10;
  };
} // namespace springfit

#endif
