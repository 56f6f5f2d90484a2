#ifndef springfit_response_own_loads_h
#define springfit_response_own_loads_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/response/load_case.h>
#include <springfit/response/own_forces.h>
#include <springfit/response/own_supports.h>

#include <functional>
#include <string>
#include <vector>

namespace springfit
{
  /** The entries of section Loads in which a user writes loads of their own. */
  struct OwnLoadTexts
  {
    std::string supports;
    std::string forces;    // N
    std::string tractions; // Pa
    std::string gravity;   // m/s^2
  };


  /** Loads in physical units, as a user describes them without a mesh. */
  template <int spacedim>
  class OwnLoads
  {
  public:
    /**
     * @throws EntryError when an entry cannot be understood, or a case is
     * called as a canned one or as "fem".
     */
    explicit OwnLoads(const OwnLoadTexts &texts);

    /**
     * The names of the load cases in the order in which they are mentioned.
     * Loads without a case are there in all of them; if no case is mentioned
     * and something is loaded or moved, there is one, called "own".
     */
    std::vector<std::string>
    cases() const;

    /**
     * The supports that are named on a mesh, each with what it holds.
     *
     * @throws EntryError when a place has no nodes.
     */
    template <int dim>
    std::vector<Support>
    supports(const Mesh<dim, spacedim> &mesh) const;

    /**
     * What acts in a case, be it one of none of these loads but those without
     * a case, at a time; it throws EntryError where something has
     * no finite value. @p mesh must outlive it.
     *
     * @throws EntryError when a place is empty.
     */
    template <int dim>
    std::function<NodalLoad(double time)>
    load(const std::string &load_case,
         const Mesh<dim, spacedim> &mesh,
         const Element<dim, spacedim> &element,
         const MaterialTable &materials) const;

  private:
    std::vector<SupportStatement<spacedim>> supports_;
    std::vector<ForceStatement<spacedim>> forces_;
    std::vector<ForceStatement<spacedim>> tractions_;
    std::vector<ForceStatement<spacedim>> gravity_;
  };
} // namespace springfit

#endif
