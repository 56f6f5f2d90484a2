#ifndef springfit_mesh_objects_h
#define springfit_mesh_objects_h

#include <springfit/mesh/mesh_description.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace springfit
{
  /** The entry `Cell size` where none is given, in m. */
  constexpr double default_cell_size = 0.0025;

  /** What the section Geometry of a parameter file asks for. */
  struct ObjectRequest
  {
    /** Of the cells: 2 of a surface in space, too. */
    int dim;

    int spacedim;
    CellKind cell_kind;

    /** Extents along x, y, z in m: dim numbers. */
    std::vector<double> size;

    /**
     * Edge length in m: one number, or one for each direction; empty for a
     * file if none is given.
     */
    std::vector<double> cell_size;

    /** Absolute or relative to the working directory; only for a file. */
    std::filesystem::path file;

    /** Units of the file to m. */
    double scale;

    /** The cell array of a .vtk file that holds the ids; may be empty. */
    std::string material_array = {};
  };


  /**
   * A geometry that a user can name. A new one is a file with its check and
   * its description, and a line in the table of objects.cc.
   */
  struct Object
  {
    std::string name;

    /** A phrase for the entry's text: what it is, and its boundary ids. */
    std::string help;

    /**
     * The Size where none is given, m, for each dimension that its cells can
     * have; empty if it has no use for a size.
     */
    std::map<int, std::vector<double>> default_size;

    /** @throws EntryError when the request does not suit the object. */
    void (*check)(const ObjectRequest &request);

    /**
     * Null, or: look whether the files of the request can be read.
     *
     * @throws EntryError
     */
    void (*check_files)(const ObjectRequest &request);

    /**
     * Make the mesh; its checks (mesh_checks.h) are yet to be done.
     *
     * @throws InputError
     */
    MeshDescription (*describe)(const ObjectRequest &request);
  };

  /** Every object, in the order in which they are offered. */
  const std::vector<Object> &
  objects();

  /** @throws EntryError with the nearest known name. */
  const Object &
  find_object(const std::string &name);


  void
  check_box(const ObjectRequest &request);

  MeshDescription
  describe_box(const ObjectRequest &request);

  void
  check_cylinder(const ObjectRequest &request);

  MeshDescription
  describe_cylinder(const ObjectRequest &request);

  void
  check_hollow_cylinder(const ObjectRequest &request);

  MeshDescription
  describe_hollow_cylinder(const ObjectRequest &request);

  void
  check_tissue(const ObjectRequest &request);

  MeshDescription
  describe_tissue(const ObjectRequest &request);

  void
  check_specimen(const ObjectRequest &request);

  MeshDescription
  describe_specimen(const ObjectRequest &request);

  void
  check_single_cell(const ObjectRequest &request);

  MeshDescription
  describe_single_cell(const ObjectRequest &request);

  void
  check_ventricle_floor(const ObjectRequest &request);

  MeshDescription
  describe_ventricle_floor(const ObjectRequest &request);

  void
  check_file(const ObjectRequest &request);

  void
  check_file_is_readable(const ObjectRequest &request);

  MeshDescription
  describe_file(const ObjectRequest &request);
} // namespace springfit

#endif
