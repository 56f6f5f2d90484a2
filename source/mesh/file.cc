#include <springfit/core/error.h>
#include <springfit/core/isolated.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/geo_script.h>
#include <springfit/mesh/gmsh_model.h>
#include <springfit/mesh/mesh_checks.h>
#include <springfit/mesh/objects.h>
#include <springfit/mesh/physical_groups.h>
#include <springfit/mesh/sizes.h>

#include <gmsh.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <new>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  namespace
  {
    std::string
    name_of(const ObjectRequest &request)
    {
      return "Mesh file '" + request.file.string() + "'";
    }

    const char *const readable_formats =
      "Mend it, or give a mesh in one of the formats .msh (1 to 4), "
      ".vtk, .inp, .unv, .mesh, .bdf, or a geometry in .geo, "
      ".step, .brep.";

    // What gmsh does, with its complaint as the message when it fails. It
    // throws its complaints as strings; exceptions are those of the library
    // inside, which tell a user nothing.
    template <typename Action>
    void
    run_gmsh(const std::string &name, const Action &action)
    {
      std::string complaint = "it is not what its ending says, or damaged";
      try
        {
          action();
          return;
        }
      catch (const InputError &)
        {
          throw;
        }
      catch (const std::bad_alloc &)
        {
          throw;
        }
      catch (const std::string &error)
        {
          if (!error.empty())
            complaint = error.substr(0, error.find('\n'));
        }
      catch (...)
        {}
      throw InputError(name + " cannot be read by gmsh (" + complaint + ").",
                       readable_formats);
    }

    bool
    is_unmeshed_geometry()
    {
      return gmsh::model::getDimension() > 0 &&
             n_gmsh_elements(1) + n_gmsh_elements(2) + n_gmsh_elements(3) == 0;
    }

    // Refuse to mesh what would take hours: the box around the geometry tells.
    void
    check_n_cells_of_geometry(const ObjectRequest &request)
    {
      double low[3], high[3];
      gmsh::model::getBoundingBox(
        -1, -1, low[0], low[1], low[2], high[0], high[1], high[2]);
      ObjectRequest box = request;
      box.size.clear();
      for (int d = 0; d < request.dim; ++d)
        box.size.push_back(request.scale * (high[d] - low[d]));
      check_n_cells(estimate_n_cells(box));
    }

    void
    mesh_geometry(const ObjectRequest &request)
    {
      const int dim = gmsh::model::getDimension();
      if (dim != request.dim)
        throw InputError(name_of(request) + " is a geometry of dimension " +
                           std::to_string(dim) + ", the scene has dimension " +
                           std::to_string(request.dim) + ".",
                         "Set Dimension to that of the geometry.");
      if (request.cell_kind == CellKind::hexahedron)
        throw EntryError("Geometry/Cells",
                         "gmsh cannot fill the geometry of '" +
                           request.file.string() + "' with hexahedra.",
                         "Set it to tetrahedra, or give a file that holds a "
                         "mesh of hexahedra (in gmsh: a transfinite or "
                         "extruded volume).");
      if (request.cell_size.size() != 1)
        throw EntryError("Geometry/Cell size",
                         "several numbers are given for a geometry that "
                         "gmsh meshes.",
                         "Give one length in m.");
      check_n_cells_of_geometry(request);
      gmsh::option::setNumber("Mesh.MeshSizeMax",
                              request.cell_size[0] / request.scale);
      gmsh::option::setNumber("Mesh.ElementOrder", 1);
      if (request.cell_kind == CellKind::quadrilateral)
        make_gmsh_quadrilaterals();
      mesh_gmsh_model(name_of(request), request.dim);
    }

    std::string
    found_dimensions()
    {
      std::vector<std::string> found;
      for (int d = 1; d <= 3; ++d)
        if (n_gmsh_elements(d) > 0)
          found.push_back(std::to_string(n_gmsh_elements(d)) +
                          " of dimension " + std::to_string(d));
      return found.empty() ? "no elements at all" : join(found, " and ");
    }

    void
    check_dimension(const std::string &name, const int dim)
    {
      if (n_gmsh_elements(dim) > 0 && (dim == 3 || n_gmsh_elements(3) == 0))
        return;

      const std::string found =
        name +
        (n_gmsh_elements(dim) == 0
           ? " has no cells of dimension " + std::to_string(dim)
           : std::string(" has cells of dimension 3 beside those of 2")) +
        "; gmsh finds " + found_dimensions() + ".";
      gmsh::vectorpair cells, sides;
      gmsh::model::getPhysicalGroups(cells, dim);
      gmsh::model::getPhysicalGroups(sides, dim - 1);
      const std::string side = dim == 2 ? "curve" : "surface";
      const std::string body = dim == 2 ? "surface" : "volume";
      if (n_gmsh_elements(dim) == 0 && cells.empty() && !sides.empty())
        throw InputError(found,
                         "The file has a physical " + side +
                           " but no physical " + body +
                           ", and gmsh saves only the elements of physical "
                           "groups: add a physical " +
                           body +
                           " with all cells and save the mesh again (or use "
                           "'gmsh -save_all').");
      if (n_gmsh_elements(1) + n_gmsh_elements(2) + n_gmsh_elements(3) == 0)
        throw InputError(found,
                         "Give a complete mesh or geometry in a format that "
                         "gmsh reads.");
      throw InputError(found,
                       "Set Dimension to that of the mesh, or give another "
                       "mesh.");
    }

    // gmsh's plane meshes may lie at any z.
    void
    put_into_plane(MeshDescription &mesh)
    {
      double low = mesh.vertices[0][2], high = low, extent = 0.;
      for (const MeshPoint &vertex : mesh.vertices)
        {
          low    = std::min(low, vertex[2]);
          high   = std::max(high, vertex[2]);
          extent = std::max({extent,
                             std::abs(vertex[0] - mesh.vertices[0][0]),
                             std::abs(vertex[1] - mesh.vertices[0][1])});
        }
      if (high - low > 1e-9 * extent)
        {
          std::ostringstream range;
          range << low << " to " << high;
          throw InputError(mesh.name + " is not plane: z goes from " +
                             range.str() + " (in m).",
                           "A mesh of dimension 2 must lie in a plane "
                           "z = constant.");
        }
      for (MeshPoint &vertex : mesh.vertices)
        vertex[2] = 0.;
    }

    void
    warn_of_unused_cell_size(MeshDescription &mesh,
                             const ObjectRequest &request)
    {
      if (request.cell_size != std::vector<double>{default_cell_size})
        mesh.warnings.push_back(mesh.name + " has its own cells: "
                                            "Geometry/Cell size is not used.");
    }

    void
    scale_to_metres(MeshDescription &mesh, const double scale)
    {
      for (MeshPoint &vertex : mesh.vertices)
        for (double &x : vertex)
          x *= scale;
    }
    // What the child does: read the file in gmsh.
    MeshDescription
    read_file(const ObjectRequest &request)
    {
      const std::string name = name_of(request);
      const GmshSession gmsh_session;
      open_with_groups(request.file, request.dim);

      const bool has_own_cells = !is_unmeshed_geometry();
      if (!has_own_cells)
        mesh_geometry(request);
      check_dimension(name, request.dim);

      GmshCells cells = read_gmsh_cells(name, request.dim);
      if (has_own_cells)
        warn_of_unused_cell_size(cells.mesh, request);
      scale_to_metres(cells.mesh, request.scale);
      check_coordinates(cells.mesh);
      check_no_duplicate_cells(cells.mesh);
      if (request.dim == 2)
        put_into_plane(cells.mesh);
      read_materials(cells);
      read_boundaries(cells);
      return cells.mesh;
    }

    /** What the child sends: a mesh, or an error with the entry it is about. */
    struct Answer
    {
      MeshDescription mesh;
      std::string error;
      std::string entry;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &mesh &error &entry;
      }
    };

    std::string
    answer(const ObjectRequest &request)
    {
      Answer answer;
      try
        {
          run_gmsh(name_of(request),
                   [&]() { answer.mesh = read_file(request); });
        }
      catch (const EntryError &error)
        {
          answer.error = error.what();
          answer.entry = error.entry;
        }
      catch (const InputError &error)
        {
          answer.error = error.what();
        }
      std::ostringstream text;
      boost::archive::binary_oarchive(text) << answer;
      return text.str();
    }

    /** @throws EntryError or InputError, if that is the answer. */
    MeshDescription
    mesh_of(const std::string &text)
    {
      Answer answer;
      std::istringstream stream(text);
      boost::archive::binary_iarchive(stream) >> answer;
      if (!answer.entry.empty())
        throw EntryError(answer.entry, answer.error);
      if (!answer.error.empty())
        throw InputError(answer.error);
      return std::move(answer.mesh);
    }

    /** In small letters, as ".geo". */
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

    // gmsh takes a file of an ending that it does not know for a script.
    bool
    may_be_script(const std::filesystem::path &file)
    {
      static const std::set<std::string> others = {".bdf",
                                                   ".brep",
                                                   ".iges",
                                                   ".igs",
                                                   ".inp",
                                                   ".mesh",
                                                   ".msh",
                                                   ".nas",
                                                   ".step",
                                                   ".stl",
                                                   ".stp",
                                                   ".unv",
                                                   ".vtk"};
      return others.count(ending_of(file)) == 0;
    }

    bool
    is_geometry_file(const std::filesystem::path &file)
    {
      const std::string ending = ending_of(file);
      return ending == ".geo" || ending == ".step" || ending == ".stp" ||
             ending == ".brep" || ending == ".iges" || ending == ".igs";
    }

    // A mesh is read in a few seconds and a few hundred bytes for each of its
    // own; what a geometry needs is in its cells, not in its size.
    WorkLimits
    limits_for(const std::filesystem::path &file)
    {
      if (is_geometry_file(file))
        return {1800., std::size_t(64) << 30};
      const double n = std::filesystem::file_size(file);
      return {40. + n / 1e6, (std::size_t(1) << 30) + std::size_t(200. * n)};
    }
  } // namespace


  void
  check_file(const ObjectRequest &request)
  {
    if (request.file.empty())
      throw EntryError("Geometry/File",
                       "no file is given although Object is 'file'.",
                       "Name a mesh file, relative to the folder of the .prm "
                       "file.");
    if (!(std::isfinite(request.scale) && request.scale > 0.))
      throw EntryError("Geometry/Scale",
                       "it is not a positive number.",
                       "Give the length of a unit of the file in m, as 0.001 "
                       "for a file in mm.");
    check_lengths(request.cell_size, "Geometry/Cell size");
  }


  void
  check_file_is_readable(const ObjectRequest &request)
  {
    const auto &file       = request.file;
    const std::string name = "'" + file.string() + "'";
    std::error_code ignored;
    const std::string mend = "Name a mesh file, relative to the folder of the "
                             ".prm file.";
    if (!std::filesystem::exists(file, ignored))
      throw EntryError("Geometry/File", name + " does not exist.", mend);
    if (std::filesystem::is_directory(file, ignored))
      throw EntryError("Geometry/File",
                       name + " is a directory, not a file.",
                       mend);
    if (!std::filesystem::is_regular_file(file, ignored))
      throw EntryError("Geometry/File", name + " is not a regular file.", mend);
    if (!std::ifstream(file))
      throw EntryError("Geometry/File",
                       name + " cannot be read.",
                       "Mend its permissions.");
  }


  MeshDescription
  describe_file(const ObjectRequest &request)
  {
    check_file_is_readable(request);
    if (may_be_script(request.file))
      check_geo_script(request.file);
    const IsolatedWork reading =
      run_isolated(limits_for(request.file), [&]() { return answer(request); });
    switch (reading.ending)
      {
        case WorkEnding::answered:
          break;
        case WorkEnding::crashed:
          if (!reading.answer.empty())
            throw InputError(
              name_of(request) + " cannot be read or meshed by gmsh (" +
                reading.answer.substr(0, reading.answer.find('\n')) + ").",
              readable_formats);
          throw InputError(name_of(request) + " makes gmsh crash.",
                           "It is probably damaged: look for wrong counts, "
                           "missing lines and numbers of nodes that are not "
                           "there, or write the file anew.");
        case WorkEnding::too_slow:
          throw InputError(
            name_of(request) + " keeps gmsh busy for more than " +
              std::to_string(
                static_cast<int>(limits_for(request.file).seconds)) +
              " s.",
            is_geometry_file(request.file)
              ? "Ask for larger cells, in the file too, or mesh it in gmsh "
                "and give the mesh."
              : "It is probably damaged: look for wrong counts and missing "
                "lines, or write the file anew.");
        case WorkEnding::too_large:
          throw InputError(name_of(request) + " asks for more memory than a "
                                              "file of its size can need.",
                           "It is probably damaged: look for counts and "
                           "numbers that are far too large.");
      }
    return mesh_of(reading.answer);
  }
} // namespace springfit
