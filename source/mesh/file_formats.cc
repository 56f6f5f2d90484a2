#include <springfit/core/error.h>
#include <springfit/mesh/file_contents.h>
#include <springfit/mesh/file_formats.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace springfit
{
  namespace
  {
    struct ForeignFormat
    {
      std::string what;
      std::string mend;
    };

    const std::string meshio = "Convert it with meshio (Debian's package "
                               "meshio-tools): meshio convert ";

    const std::string fill_stl =
      "Fill it: write a file mesh.geo with the lines 'Merge \"mesh.stl\"; "
      "Surface Loop(1) = {1}; Volume(1) = {1}; Mesh 3;' and give that.";

    const ForeignFormat ls_dyna = {
      "a deck of LS-DYNA",
      "Save it as an Abaqus (.inp) or Nastran (.bdf) file where it comes from."};

    const std::map<std::string, ForeignFormat> &
    foreign_formats()
    {
      static const std::map<std::string, ForeignFormat> formats = {
        {".vtu",
         {"a VTK XML file",
          meshio + "mesh.vtu mesh.vtk; or save it in ParaView as .vtk."}},
        {".pvtu",
         {"a VTK XML file in parts", "Save it in ParaView as one .vtk file."}},
        {".pvd",
         {"a series of VTK files",
          "Save one of its files in ParaView as .vtk."}},
        {".vtp", {"a VTK XML surface", "Give a mesh with cells inside."}},
        {".stl", {"a surface without cells inside", fill_stl}},
        {".off",
         {"a surface without cells inside",
          meshio + "mesh.off mesh.stl. " + fill_stl}},
        {".obj",
         {"a surface without cells inside",
          meshio + "mesh.obj mesh.stl. " + fill_stl}},
        {".ply",
         {"a surface without cells inside",
          meshio + "mesh.ply mesh.stl. " + fill_stl}},
        {".veg",
         {"a mesh of Vega FEM",
          "Write its vertices and elements as a .mesh file: 'Vertices', their "
          "count, x y z 0 each; 'Tetrahedra', their count, four vertices and "
          "the material's number each; 'End'."}},
        {".node",
         {"a mesh of TetGen",
          meshio + "mesh.node mesh.vtk (beside mesh.ele)."}},
        {".ele",
         {"a mesh of TetGen",
          meshio + "mesh.ele mesh.vtk (beside mesh.node)."}},
        {".xdmf", {"an XDMF file", meshio + "mesh.xdmf mesh.vtk."}},
        {".e", {"an Exodus file", meshio + "mesh.e mesh.vtk."}},
        {".exo", {"an Exodus file", meshio + "mesh.exo mesh.vtk."}},
        {".vol", {"a mesh of Netgen", meshio + "mesh.vol mesh.vtk."}},
        {".meshb",
         {"a binary file of Medit", "Save it as text, with the ending .mesh."}},
        {".med",
         {"a MED file of Salome",
          meshio + "mesh.med mesh.vtk; or save it in Salome as .unv."}},
        {".cgns", {"a CGNS file", meshio + "mesh.cgns mesh.vtk."}},
        {".h5",
         {"an HDF5 file, as those of MED, CGNS and Exodus are",
          meshio + "mesh.med mesh.vtk, with the ending that tells which."}},
        {".su2", {"a mesh of SU2", meshio + "mesh.su2 mesh.vtk."}},
        {".k", ls_dyna},
        {".key", ls_dyna},
        {".cas",
         {"a mesh of Fluent",
          meshio + "--input-format ansys mesh.msh mesh.vtk."}},
        {".gz", {"packed", "Unpack it: gunzip."}},
        {".zip", {"packed", "Unpack it: unzip."}},
        {"git-lfs",
         {"a pointer of Git LFS that stands for a file",
          "Fetch the file itself: git lfs pull."}},
        {".prm", {"a parameter file", "Name a mesh file."}}};
      return formats;
    }

    /** What each ending that is read means, as ending_by_content() has it. */
    const std::map<std::string, std::string> &
    known_endings()
    {
      static const std::map<std::string, std::string> endings = {
        {".bdf", ".bdf"},
        {".brep", ".brep"},
        {".geo", ".geo"},
        {".iges", ".igs"},
        {".igs", ".igs"},
        {".inp", ".inp"},
        {".mesh", ".mesh"},
        {".msh", ".msh"},
        {".nas", ".bdf"},
        {".step", ".step"},
        {".stp", ".step"},
        {".unv", ".unv"},
        {".vtk", ".vtk"}};
      return endings;
    }

    void
    refuse_foreign(const std::string &ending, const std::string &name)
    {
      const auto foreign = foreign_formats().find(ending);
      if (foreign != foreign_formats().end())
        throw InputError(name + " is " + foreign->second.what +
                           ", which springfit does not read.",
                         foreign->second.mend);
    }
  } // namespace


  std::string
  ending_of(const std::filesystem::path &file)
  {
    std::string ending = file.extension();
    std::transform(ending.begin(),
                   ending.end(),
                   ending.begin(),
                   [](const unsigned char c) { return std::tolower(c); });
    return ending;
  }


  bool
  is_geo_script(const std::filesystem::path &file)
  {
    return ending_of(file) == ".geo";
  }


  bool
  is_geometry_file(const std::filesystem::path &file)
  {
    const std::string ending = ending_of(file);
    return ending == ".geo" || ending == ".brep" || states_its_unit(file);
  }


  bool
  states_its_unit(const std::filesystem::path &file)
  {
    const std::string ending = ending_of(file);
    return ending == ".step" || ending == ".stp" || ending == ".iges" ||
           ending == ".igs";
  }


  void
  check_format(const std::filesystem::path &file, const std::string &name)
  {
    const std::string ending  = ending_of(file);
    const std::string content = ending_by_content(file);
    const auto known          = known_endings().find(ending);
    const bool is_known       = known != known_endings().end();
    if (is_known && known->second == content)
      return;
    if (known_endings().count(content) > 0)
      throw InputError(name + " begins as a " + content +
                         " file does, which its ending does not say.",
                       "Give it the ending " + content + '.');
    refuse_foreign(ending, name);
    refuse_foreign(content, name);
    if (!is_known)
      throw InputError(name + " is of no format that springfit knows.",
                       mend_format());
    if (ending == ".msh")
      throw InputError(name + " does not begin with $MeshFormat, as those of "
                              "gmsh do.",
                       "If it is one, remove what stands before, even blanks "
                       "and a mark of byte order. " +
                         mend_format());
  }


  std::string
  mend_format()
  {
    return "Mend it, or give a mesh in one of the formats .msh (1 to 4), .vtk, "
           ".inp, .unv, .mesh, .bdf, or a geometry in .geo, .step, .brep.";
  }
} // namespace springfit
