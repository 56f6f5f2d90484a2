#ifndef springfit_response_own_supports_h
#define springfit_response_own_supports_h

#include <springfit/mesh/mesh.h>
#include <springfit/response/expression.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** Components of the nodes at a place that are held, or moved. */
  template <int spacedim>
  struct SupportStatement
  {
    std::string load_case; // in which it moves; empty: in all own ones
    std::string place;

    /** The displacement of a component, m; none: it is free. */
    std::array<std::optional<Expression<spacedim>>, spacedim> components;
  };

  /**
   * The statements of an entry such as "base; floor: z; lid: z = -0.01 * t":
   * without components all of them are held, without an expression they stay
   * where they are.
   *
   * @throws EntryError when it cannot be understood.
   */
  template <int spacedim>
  std::vector<SupportStatement<spacedim>>
  parse_supports(const std::string &text, const std::string &entry);

  /**
   * A flag per node: those of the place.
   *
   * @throws EntryError when there are none, or a boundary is unknown.
   */
  template <int dim, int spacedim>
  std::vector<bool>
  nodes_of(const SupportStatement<spacedim> &statement,
           const Mesh<dim, spacedim> &mesh,
           const std::string &entry);


  /** A statement on a mesh. */
  template <int spacedim>
  struct PlacedSupport
  {
    std::vector<bool> nodes; // a flag per node
    SupportStatement<spacedim> statement;
  };

  /**
   * The displacements at a time, m, spacedim x n_nodes; 0 where nothing is
   * said.
   *
   * @throws EntryError when two statements move a component of a node to
   * different places, or an expression has no finite value.
   */
  template <int dim, int spacedim>
  Eigen::MatrixXd
  displacement_at(const std::vector<PlacedSupport<spacedim>> &supports,
                  const Mesh<dim, spacedim> &mesh,
                  double time,
                  const std::string &entry);
} // namespace springfit

#endif
