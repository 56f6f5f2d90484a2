#ifndef springfit_mesh_gmsh_model_h
#define springfit_mesh_gmsh_model_h

#include <springfit/mesh/mesh_description.h>

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace springfit
{
  /**
   * gmsh is one global object: this switches it on for as long as it lives,
   * silent and repeatable (one thread, fixed algorithms and seed, none of the
   * user's own settings).
   */
  class GmshSession
  {
  public:
    GmshSession();
    ~GmshSession();

    GmshSession(const GmshSession &) = delete;
    GmshSession &
    operator=(const GmshSession &) = delete;
  };

  /** The edge length that gmsh shall give to all cells, in its units. */
  void
  set_gmsh_cell_size(double cell_size);

  /**
   * A spline with continuous second derivatives (C2) through points; @p first
   * and @p last are points of gmsh's current OpenCASCADE model. Returns its
   * number.
   */
  int
  add_gmsh_spline(int first, const std::vector<MeshPoint> &between, int last);

  /** gmsh shall fill surfaces with quadrilaterals only. */
  void
  make_gmsh_quadrilaterals();

  /**
   * Mesh the geometry of gmsh's current model. @p name begins the message.
   *
   * @throws InputError with gmsh's complaint.
   */
  void
  mesh_gmsh_model(const std::string &name, int dim);


  /** The cells of gmsh's current model. */
  struct GmshCells
  {
    /** All material ids are 0, no facets; all vertices are used. */
    MeshDescription mesh;

    /** gmsh's number of the surface or volume of each group of cells. */
    std::vector<int> entities;

    /** The vertex that a node of gmsh has become. */
    std::unordered_map<std::size_t, unsigned int> vertex_of_node;
  };

  /**
   * Read the elements of dimension @p dim of gmsh's current model, their
   * vertices in ascending order of gmsh's numbers. @p name becomes the mesh's.
   *
   * @throws InputError when there are none, or of several types, or of second
   * or higher order, or of a type other than the four of CellKind.
   */
  GmshCells
  read_gmsh_cells(const std::string &name, int dim);

  /** The number of elements of gmsh's current model of dimension @p dim. */
  std::size_t
  n_gmsh_elements(int dim);
} // namespace springfit

#endif
