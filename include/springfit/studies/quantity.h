#ifndef springfit_studies_quantity_h
#define springfit_studies_quantity_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/response/load_case.h>
#include <springfit/response/model.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /** A number that a scene is about, as a user names it. */
  struct QuantityStatement
  {
    enum class Kind
    {
      mean_displacement, // of a boundary
      displacement,      // at a point
      reaction           // of a support
    };

    std::string text;
    Kind kind;
    std::string place;         // of a boundary or support
    std::vector<double> point; // m
    int component;
  };

  /**
   * "displacement of top: z", "displacement at 0.01, 0.01, 0.02: x" or
   * "reaction of base: z".
   *
   * @throws EntryError when it cannot be understood.
   */
  QuantityStatement
  parse_quantity(const std::string &text,
                 int spacedim,
                 const std::string &entry);


  /** The same on a mesh: a linear function of what an equilibrium has. */
  struct Quantity
  {
    bool is_reaction;        // N, else of the displacement, m
    Eigen::MatrixXd weights; // spacedim x n_nodes
  };

  /** m or N */
  double
  value_of(const Quantity &quantity, const Equilibrium &equilibrium);

  /**
   * @throws EntryError when there is no such boundary or support, or the point
   * is outside of the mesh by more than a hundredth of its size: a coarse mesh
   * cuts curves short.
   */
  template <int dim, int spacedim>
  Quantity
  on_mesh(const QuantityStatement &statement,
          const Mesh<dim, spacedim> &mesh,
          const Element<dim, spacedim> &element,
          const Loading &loading,
          const std::string &entry);
} // namespace springfit

#endif
