#ifndef springfit_studies_tradeoff_section_h
#define springfit_studies_tradeoff_section_h

#include <springfit/comparison/tradeoff.h>
#include <springfit/mesh/geometry.h>
#include <springfit/reference/material_law.h>
#include <springfit/studies/quantity.h>

#include <deal.II/base/parameter_acceptor.h>

#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /**
   * The section "Tradeoff": which meshes and models are measured, against what,
   * and what is wanted of the one to choose.
   */
  template <int dim>
  class TradeoffSection : public dealii::ParameterAcceptor
  {
  public:
    TradeoffSection();

    /**
     * Where the models are the program's choice, set the entries of other
     * sections that name them, so that they are among the values in force.
     *
     * @throws EntryError
     */
    void
    choose_models();

    /** @throws EntryError when a value is wrong or does not suit the object. */
    void
    check(const Geometry<dim> &geometry) const;

    /**
     * Those of the models, each cell kind from coarse to fine.
     *
     * @throws EntryError
     */
    std::vector<Meshing>
    meshings(const Geometry<dim> &geometry) const;

    /** Of a reference, and of the one that tells its error. */
    struct ReferenceMeshings
    {
      Meshing fine, coarse;
    };

    /** @throws EntryError when the reference is coarser than a model. */
    ReferenceMeshings
    reference(const Geometry<dim> &geometry) const;

    unsigned int
    reference_degree() const;

    /** Of the finite elements among the models; @p otherwise if none is given.
     */
    std::vector<MaterialLaw>
    material_laws(MaterialLaw otherwise) const;

    /** @p time_step s */
    Demand
    demand(double time_step) const;

    std::optional<QuantityStatement>
    quantity() const;

    unsigned int
    n_repetitions() const;

  private:
    std::string models_ = "chosen";
    std::string cells_;
    std::vector<double> cell_sizes_;
    unsigned int n_halvings_ = 1;
    std::string laws_;
    std::string reference_cells_;
    double reference_size_         = 0.;
    unsigned int reference_degree_ = 2;
    double accuracy_               = 5.;
    double budget_                 = 0.;
    std::string purpose_           = "implicit motion";
    std::string quantity_;
    unsigned int n_repetitions_ = 5;
  };
} // namespace springfit

#endif
