#ifndef springfit_response_loads_h
#define springfit_response_loads_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/response/load_case.h>
#include <springfit/response/own_loads.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace springfit
{
  /** The section "Loads": what is held, what acts on it, and how. */
  template <int spacedim>
  class Loads : public dealii::ParameterAcceptor
  {
  public:
    Loads();

    /**
     * The supports and the load cases on a mesh.
     *
     * A canned case is the nodal forces of a traction of 1 Pa on the loaded
     * part of the boundary, see unit_traction(), in 2-d times the thickness of
     * @p materials. The axis of the pull is the mean outward normal of the
     * loaded part.
     *
     * @p mesh must outlive the result.
     *
     * @throws EntryError when a boundary or region is empty or unknown, when
     * or when every loaded node is fixed.
     */
    template <int dim>
    Loading
    resolve(const Mesh<dim, spacedim> &mesh,
            const Element<dim, spacedim> &element,
            const MaterialTable &materials) const;

    /**
     * For statics.
     *
     * @throws EntryError when the supports leave a rigid motion free, with the
     * motion named.
     */
    template <int dim>
    void
    check_supports(const Mesh<dim, spacedim> &mesh,
                   const Loading &loading) const;

    /**
     * Check the values that can be judged without a mesh; for the studies that
     * load something.
     *
     * @throws EntryError
     */
    void
    check() const;

  private:
    /**
     * A part of the boundary is given by its boundaries or by a region, or else
     * it is the boundary @p otherwise, unless that is empty.
     *
     * @throws EntryError when both are given.
     */
    void
    complete(const std::string &which,
             const std::string &boundaries,
             const std::string &region,
             const std::string &otherwise);

    /** What the entries that are left empty mean, through the entries. */
    void
    complete();

    OwnLoads<spacedim>
    own_loads() const;

    /** The names of all cases of an entry. */
    std::vector<std::string>
    cases_of(const std::string &words, const std::string &entry) const;

    /** @throws EntryError when one of them is not among the cases. */
    std::vector<std::string>
    training_cases() const;

    bool
    has_canned_cases() const;

    /** The nodes of 'Fixed boundaries' or of the region; none of both. */
    template <int dim>
    std::vector<bool>
    fixed_nodes(const Mesh<dim, spacedim> &mesh) const;

    std::string
    entry_of_supports() const;

    /** Fill in the canned cases and their pull. */
    template <int dim>
    void
    add_canned(const Mesh<dim, spacedim> &mesh,
               const Element<dim, spacedim> &element,
               double thickness,
               Loading &loading) const;

    std::string cases_word_;
    std::string training_word_;
    std::string fixed_boundaries_;
    std::string loaded_boundaries_;
    std::string fixed_region_;
    std::string loaded_region_;
    double deformation_ = 0.1;
    OwnLoadTexts own_;
    double time_ = 0.;
  };
} // namespace springfit

#endif
