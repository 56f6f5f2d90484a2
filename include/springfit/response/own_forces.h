#ifndef springfit_response_own_forces_h
#define springfit_response_own_forces_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/response/expression.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /** A vector for each point and time that acts at a place. */
  template <int spacedim>
  struct ForceStatement
  {
    std::string load_case; // empty: all own ones
    std::string place;     // empty: everywhere
    std::vector<Expression<spacedim>> components;
  };

  /**
   * The statements of an entry such as "press on top: 0, 0, -2".
   *
   * @throws EntryError when it cannot be understood, or a vector has not
   * spacedim components.
   */
  template <int spacedim>
  std::vector<ForceStatement<spacedim>>
  parse_forces(const std::string &text, const std::string &entry);

  /**
   * A vector without a place: "0, 0, -9.81". Of an empty text none.
   *
   * @throws EntryError as parse_forces() does.
   */
  template <int spacedim>
  std::vector<ForceStatement<spacedim>>
  parse_field(const std::string &text, const std::string &entry);


  /** A statement on a mesh: the force on node v is weight v times the vector.
   */
  template <int spacedim>
  struct PlacedForce
  {
    Eigen::VectorXd weights;
    std::vector<Expression<spacedim>> components;
  };

  // All of them throw EntryError when no face is at the place.

  /** Of a force in N: spread evenly over the faces of the place. */
  template <int dim, int spacedim>
  PlacedForce<spacedim>
  placed_force(const ForceStatement<spacedim> &statement,
               const Mesh<dim, spacedim> &mesh,
               const Element<dim, spacedim> &element,
               const std::string &entry);

  /** Of a traction in Pa on the faces of the place at rest. */
  template <int dim, int spacedim>
  PlacedForce<spacedim>
  placed_traction(const ForceStatement<spacedim> &statement,
                  const Mesh<dim, spacedim> &mesh,
                  const Element<dim, spacedim> &element,
                  double thickness,
                  const std::string &entry);

  /** Of an acceleration in m/s^2 of all nodes. */
  template <int spacedim>
  PlacedForce<spacedim>
  placed_acceleration(const ForceStatement<spacedim> &statement,
                      const Eigen::VectorXd &masses);

  /** N, spacedim x n_nodes; @throws EntryError where they have no finite value.
   */
  template <int dim, int spacedim>
  Eigen::MatrixXd
  forces_at(const std::vector<PlacedForce<spacedim>> &forces,
            const Mesh<dim, spacedim> &mesh,
            double time);
} // namespace springfit

#endif
