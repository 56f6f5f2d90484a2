#ifndef springfit_mesh_geometry_h
#define springfit_mesh_geometry_h

#include <springfit/mesh/mesh.h>
#include <springfit/mesh/objects.h>

#include <deal.II/base/parameter_acceptor.h>

#include <mpi.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace springfit
{
  /** Of which cells an object is made. */
  struct Meshing
  {
    CellKind cells;

    /** Of each direction or of all, m; empty: that of the file. */
    std::vector<double> cell_size;

    /** How many times each edge is divided in two, then. */
    unsigned int refinements;
  };


  /**
   * The section Geometry: which object, of which cells.
   */
  template <int spacedim>
  class Geometry : public dealii::ParameterAcceptor
  {
  public:
    Geometry();

    /**
     * Check all values that can be judged without looking at files; done
     * whenever the parameters are read.
     *
     * @throws EntryError
     */
    void
    check() const;

    /**
     * Check that the mesh file, if the object is one, is there to be read.
     * Relative names start at @p folder_of_prm. Call it on one rank.
     *
     * @throws EntryError
     */
    void
    check_files(const std::filesystem::path &folder_of_prm) const;

    /** That of space, or 2 for a surface in it. */
    int
    dimension_of_cells() const;

    /**
     * Make the mesh on the first rank, check it and give it to all ranks,
     * which share the cells among them by subdomain ids. Collective.
     * @p dim is dimension_of_cells().
     *
     * @throws EntryError or InputError, the same on all ranks.
     */
    template <int dim = spacedim>
    std::unique_ptr<Mesh<dim, spacedim>>
    create(MPI_Comm communicator,
           const std::filesystem::path &folder_of_prm) const;

    /** The same of other cells. */
    template <int dim = spacedim>
    std::unique_ptr<Mesh<dim, spacedim>>
    create(const Meshing &meshing,
           MPI_Comm communicator,
           const std::filesystem::path &folder_of_prm) const;

    /**
     * Check the same of other cells.
     *
     * @throws EntryError
     */
    void
    check(const Meshing &meshing) const;

    /** What the entries say. */
    Meshing
    meshing() const;

    /** Whether the object is a file of cells, which only refinements change. */
    bool
    has_its_own_cells() const;

  private:
    /** Where no Size is given, set the entry to the object's own. */
    void
    complete();

    ObjectRequest
    request(const Meshing &meshing,
            const std::filesystem::path &folder_of_prm) const;


    std::string object_ = "box";
    std::string cells_  = spacedim == 2 ? "quadrilaterals" : "hexahedra";
    std::vector<double> size_;
    std::vector<double> cell_size_;
    unsigned int refinements_ = 0;
    double jitter_            = 0.;
    std::string file_;
    std::string material_array_;
    std::string left_out_;
    double scale_ = 1.;
  };
} // namespace springfit

#endif
