#ifndef springfit_mesh_abaqus_file_h
#define springfit_mesh_abaqus_file_h

#include <filesystem>

namespace springfit
{
  /**
   * Put the mesh of an Abaqus file (.inp), which gmsh writes but does not
   * read, into gmsh's current model: nodes, elements and element sets. The
   * sets become physical groups, numbered from 1 in the order in which the
   * file names them; an element belongs to the first *ELSET that lists it, or
   * else to the set that its *ELEMENT line names. Sets of nodes and everything
   * else is passed over.
   *
   * @throws InputError with the line that cannot be understood.
   */
  void
  open_abaqus_file(const std::filesystem::path &file);
} // namespace springfit

#endif
