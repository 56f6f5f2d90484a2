#ifndef springfit_mesh_abaqus_file_h
#define springfit_mesh_abaqus_file_h

#include <springfit/mesh/mesh_description.h>

#include <filesystem>
#include <string>

namespace springfit
{
  /**
   * The mesh of an Abaqus or CalculiX file, in its own units, with the cells of
   * dimension @p dim; @p name becomes the mesh's.
   *
   * Materials are numbered from 1 in the order of the sections (*SOLID SECTION
   * and the like), which have the names of their set and of their material;
   * cells without a section are of the material that the ELSET of their
   * *ELEMENT names, or of 0. Sets of nodes, surfaces, and sets of elements that
   * lie on the boundary name parts of it.
   *
   * The reader is springfit's own: gmsh 4.8 writes the format only. deal.II
   * 9.4's GridIn::read_abaqus reads nodes, elements and the surfaces of quad-
   * rilaterals and hexahedra without tetrahedra, parts, sections or names, and
   * passes over in silence what it does not know; VTK 9.1, which ParaView
   * brings, reads under .inp another format, that of AVS-UCD.
   *
   * @throws InputError with the file and the line of what cannot be understood,
   * or when there are no cells of that dimension, or of several types, or of a
   * type that is none of CellKind.
   */
  MeshDescription
  read_abaqus_file(const std::filesystem::path &file,
                   const std::string &name,
                   int dim);
} // namespace springfit

#endif
