#ifndef springfit_response_loads_h
#define springfit_response_loads_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/response/load_case.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace springfit
{
  /** The section "Loads": what is held, what is pulled, and how. */
  template <int dim>
  class Loads : public dealii::ParameterAcceptor
  {
  public:
    Loads();

    /**
     * The supports and the nodal forces of a traction of 1 Pa (at its largest)
     * on the loaded part of the boundary (in 2-d times @p thickness in m).
     *
     * The axis of the pull is the mean outward normal of the loaded part. The
     * traction is uniform along it (tension), against it (compression), or
     * along the coordinate direction most perpendicular to it (shear); for
     * torsion it is the axis times the distance vector from the loaded part's
     * centroid, divided by the extent of that part.
     *
     * @throws EntryError when a boundary or region is empty or unknown, or
     * when every loaded node is fixed; InputError when the supports leave a
     * rigid motion free, with the motion named.
     */
    Loading
    resolve(const Mesh<dim> &mesh,
            const Element<dim> &element,
            double thickness) const;

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
     * it is the boundary @p otherwise.
     *
     * @throws EntryError when both are given.
     */
    void
    complete(const std::string &which,
             const std::string &boundaries,
             const std::string &region,
             const std::string &otherwise);

    std::vector<bool>
    fixed_nodes(const Mesh<dim> &mesh) const;

    std::vector<Load>
    cases() const;

    /** @throws EntryError when one of them is not among the cases. */
    std::vector<Load>
    training_cases() const;

    std::string cases_word_;
    std::string training_word_;
    std::string fixed_boundaries_;
    std::string loaded_boundaries_;
    std::string fixed_region_;
    std::string loaded_region_;
    double deformation_ = 0.1;
  };
} // namespace springfit

#endif
