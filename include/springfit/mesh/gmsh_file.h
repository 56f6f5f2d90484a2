#ifndef springfit_mesh_gmsh_file_h
#define springfit_mesh_gmsh_file_h

#include <springfit/mesh/mesh_description.h>
#include <springfit/mesh/objects.h>

namespace springfit
{
  /**
   * What gmsh reads from a mesh file, or makes of a geometry file, in the
   * file's units (STEP and IGES: m). Must run in a process of its own, since
   * gmsh 4.8 crashes on some damaged files.
   *
   * @throws InputError or EntryError with what is wrong.
   */
  MeshDescription
  read_gmsh_file(const ObjectRequest &request);

  /** @throws EntryError: a mesh has its own cells. */
  [[noreturn]] void
  refuse_cell_size(const ObjectRequest &request);
} // namespace springfit

#endif
