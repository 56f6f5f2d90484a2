#include <springfit/core/error.h>
#include <springfit/core/isolated.h>
#include <springfit/core/words.h>
#include <springfit/mesh/abaqus_file.h>
#include <springfit/mesh/file_formats.h>
#include <springfit/mesh/geo_script.h>
#include <springfit/mesh/gmsh_file.h>
#include <springfit/mesh/medit_file.h>
#include <springfit/mesh/mesh_checks.h>
#include <springfit/mesh/nastran_file.h>
#include <springfit/mesh/objects.h>
#include <springfit/mesh/sizes.h>
#include <springfit/mesh/unv_file.h>
#include <springfit/mesh/vtk_file.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <new>
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

    // Plane meshes may lie at any z.
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
    scale_to_metres(MeshDescription &mesh, const double scale)
    {
      for (MeshPoint &vertex : mesh.vertices)
        for (double &x : vertex)
          x *= scale;
    }

    /** Of the box around the mesh, along each axis, in m. */
    MeshPoint
    extents_of(const MeshDescription &mesh)
    {
      MeshPoint extents;
      for (unsigned int d = 0; d < 3; ++d)
        {
          const auto [low, high] =
            std::minmax_element(mesh.vertices.begin(),
                                mesh.vertices.end(),
                                [d](const MeshPoint &a, const MeshPoint &b) {
                                  return a[d] < b[d];
                                });
          extents[d] = (*high)[d] - (*low)[d];
        }
      return extents;
    }

    // Most who simulate tissue and parts mean mm when they forget to say so.
    void
    ask_about_scale(MeshDescription &mesh, const ObjectRequest &request)
    {
      const MeshPoint extents = extents_of(mesh);
      const double largest = *std::max_element(extents.begin(), extents.end());
      if (largest >= 1e-4 && largest <= 10.)
        return;
      std::ostringstream text;
      text.precision(3);
      text << mesh.name << " measures " << extents[0] << " x " << extents[1];
      if (request.spacedim == 3)
        text << " x " << extents[2];
      text.precision(6);
      text << " m. Is Geometry/Scale = " << request.scale
           << " right? It is the length of a unit of the file in m, as 0.001 "
              "for a file in mm.";
      mesh.warnings.push_back(text.str());
    }

    void
    bring_into_scene(MeshDescription &mesh, const ObjectRequest &request)
    {
      scale_to_metres(mesh, request.scale);
      check_coordinates(mesh);
      check_no_duplicate_cells(mesh);
      if (request.spacedim == 2)
        put_into_plane(mesh);
      ask_about_scale(mesh, request);
    }

    /** Null for a file that gmsh reads. */
    using OwnReader = MeshDescription (*)(const ObjectRequest &request);

    OwnReader
    own_reader(const std::filesystem::path &file)
    {
      const std::string ending = ending_of(file);
      if (ending == ".inp")
        return [](const ObjectRequest &request) {
          return read_abaqus_file(request.file, name_of(request), request.dim);
        };
      if (ending == ".mesh")
        return [](const ObjectRequest &request) {
          return read_medit_file(request.file, name_of(request), request.dim);
        };
      if (ending == ".unv")
        return [](const ObjectRequest &request) {
          return read_unv_file(request.file,
                               name_of(request),
                               request.dim,
                               request.scale);
        };
      if (ending == ".bdf" || ending == ".nas")
        return [](const ObjectRequest &request) {
          return read_nastran_file(request.file, name_of(request), request.dim);
        };
      if (ending == ".vtk")
        return [](const ObjectRequest &request) {
          return read_vtk_file(request.file,
                               name_of(request),
                               request.dim,
                               request.material_array);
        };
      return nullptr;
    }

    // What the child does.
    MeshDescription
    read_file(const ObjectRequest &request)
    {
      const OwnReader read = own_reader(request.file);
      if (read != nullptr && !request.cell_size.empty())
        refuse_cell_size(request);
      if (!request.material_array.empty() && ending_of(request.file) != ".vtk")
        throw EntryError(
          "Geometry/Material ids",
          "it is the name of a cell array of a .vtk file, which " +
            name_of(request) + " is not.",
          "Leave it empty.");
      MeshDescription mesh =
        read == nullptr ? read_gmsh_file(request) : read(request);
      bring_into_scene(mesh, request);
      return mesh;
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
          answer.mesh = read_file(request);
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
    if (!request.cell_size.empty())
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
    check_format(request.file, name_of(request));
    if (is_geo_script(request.file))
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
              mend_format());
          throw InputError(name_of(request) + " makes its reader crash.",
                           "It is probably damaged: look for wrong counts, "
                           "missing lines and numbers of nodes that are not "
                           "there, or write the file anew.");
        case WorkEnding::too_slow:
          throw InputError(
            name_of(request) + " keeps its reader busy for more than " +
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
