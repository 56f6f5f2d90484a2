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
  template <int dim>
  struct ForceStatement
  {
    std::string load_case; // empty: all own ones
    std::string place;     // empty: everywhere
    std::vector<Expression<dim>> components;
  };

  /**
   * The statements of an entry such as "press on top: 0, 0, -2".
   *
   * @throws EntryError when it cannot be understood, or a vector has not dim
   * components.
   */
  template <int dim>
  std::vector<ForceStatement<dim>>
  parse_forces(const std::string &text, const std::string &entry);

  /**
   * A vector without a place: "0, 0, -9.81". Of an empty text none.
   *
   * @throws EntryError as parse_forces() does.
   */
  template <int dim>
  std::vector<ForceStatement<dim>>
  parse_field(const std::string &text, const std::string &entry);


  /** A statement on a mesh: the force on node v is weight v times the vector.
   */
  template <int dim>
  struct PlacedForce
  {
    Eigen::VectorXd weights;
    std::vector<Expression<dim>> components;
  };

  // All of them throw EntryError when no face is at the place.

  /** Of a force in N: spread evenly over the faces of the place. */
  template <int dim>
  PlacedForce<dim>
  placed_force(const ForceStatement<dim> &statement,
               const Mesh<dim> &mesh,
               const Element<dim> &element,
               const std::string &entry);

  /** Of a traction in Pa on the faces of the place at rest. */
  template <int dim>
  PlacedForce<dim>
  placed_traction(const ForceStatement<dim> &statement,
                  const Mesh<dim> &mesh,
                  const Element<dim> &element,
                  double thickness,
                  const std::string &entry);

  /** Of an acceleration in m/s^2 of all nodes. */
  template <int dim>
  PlacedForce<dim>
  placed_acceleration(const ForceStatement<dim> &statement,
                      const Eigen::VectorXd &masses);

  /** N, dim x n_nodes; @throws EntryError where they have no finite value. */
  template <int dim>
  Eigen::MatrixXd
  forces_at(const std::vector<PlacedForce<dim>> &forces,
            const Mesh<dim> &mesh,
            double time);
} // namespace springfit

#endif
