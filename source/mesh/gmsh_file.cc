#include <springfit/core/error.h>
#include <springfit/mesh/announced.h>
#include <springfit/mesh/file_elements.h>
#include <springfit/mesh/file_formats.h>
#include <springfit/mesh/gmsh_file.h>
#include <springfit/mesh/gmsh_model.h>
#include <springfit/mesh/mesh_checks.h>
#include <springfit/mesh/mesh_text.h>
#include <springfit/mesh/msh_names.h>
#include <springfit/mesh/physical_groups.h>
#include <springfit/mesh/sizes.h>

#include <gmsh.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <new>
#include <optional>
#include <string>
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
                       mend_format());
    }

    bool
    is_unmeshed_geometry()
    {
      return gmsh::model::getDimension() > 0 &&
             n_gmsh_elements(1) + n_gmsh_elements(2) + n_gmsh_elements(3) == 0;
    }

    // Refuse to mesh what would take hours: the box around the geometry tells.
    void
    check_n_cells_of_geometry(const ObjectRequest &request,
                              const std::vector<double> &cell_size)
    {
      double low[3], high[3];
      gmsh::model::getBoundingBox(
        -1, -1, low[0], low[1], low[2], high[0], high[1], high[2]);
      ObjectRequest box = request;
      box.cell_size     = cell_size;
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
                           std::to_string(dim) +
                           ", the scene has cells of "
                           "dimension " +
                           std::to_string(request.dim) + ".",
                         advice_on_dimension(dim));
      if (request.cell_kind == CellKind::hexahedron)
        throw EntryError("Geometry/Cells",
                         "gmsh cannot fill the geometry of '" +
                           request.file.string() + "' with hexahedra.",
                         "Set it to tetrahedra, or give a file that holds a "
                         "mesh of hexahedra (in gmsh: a transfinite or "
                         "extruded volume).");
      const std::vector<double> size =
        request.cell_size.empty() ? std::vector<double>{default_cell_size}
                                  : request.cell_size;
      if (size.size() != 1)
        throw EntryError("Geometry/Cell size",
                         "several numbers are given for a geometry that "
                         "gmsh meshes.",
                         "Give one length in m.");
      check_n_cells_of_geometry(request, size);
      gmsh::option::setNumber("Mesh.MeshSizeMax", size[0] / request.scale);
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
                           "'gmsh -save_all')." +
                           (dim == 3 ? " Or: " + advice_on_dimension(2) : ""));
      if (n_gmsh_elements(1) + n_gmsh_elements(2) + n_gmsh_elements(3) == 0)
        throw InputError(found,
                         "Give a complete mesh or geometry in a format that "
                         "gmsh reads.");
      throw InputError(found,
                       advice_on_dimension(n_gmsh_elements(3) > 0   ? 3
                                           : n_gmsh_elements(2) > 0 ? 2
                                                                    : 1));
    }

    std::optional<Announced>
    announced_in(const std::filesystem::path &file)
    {
      return ending_of(file) == ".msh" ? announced_in_msh(file) : std::nullopt;
    }

    // Cells and sides; gmsh may leave out points and lines.
    void
    check_arrival(const std::string &name,
                  const Announced &announced,
                  const int dim)
    {
      for (int d = dim - 1; d <= dim; ++d)
        if (d > 1 && n_gmsh_elements(d) != announced.n_elements[d])
          throw InputError(name + " holds " +
                             std::to_string(announced.n_elements[d]) +
                             " elements of dimension " + std::to_string(d) +
                             ", of which gmsh reads " +
                             std::to_string(n_gmsh_elements(d)) + ".",
                           "Some may be of a type that it does not know: "
                           "remove what is no part of the mesh, or give the "
                           "mesh in another format.");
    }

    // gmsh itself leaves out most nodes without cells.
    void
    count_unused_nodes(const Announced &announced, MeshDescription &mesh)
    {
      const std::size_t n_used = mesh.vertices.size();
      if (announced.n_nodes <= n_used)
        return;
      for (std::string &warning : mesh.warnings)
        if (warning.find("belong to no cell") != std::string::npos)
          return;
      mesh.warnings.push_back(
        std::to_string(announced.n_nodes - n_used) + " of the " +
        std::to_string(announced.n_nodes) +
        " nodes of the mesh belong to no cell and are left out; the others "
        "are numbered from 0 in the order of their numbers there.");
    }

    bool
    is_known(const std::string &name,
             const std::multimap<unsigned int, std::string> &names,
             const std::map<std::string, std::string> &unused)
    {
      return unused.count(name) > 0 ||
             std::any_of(names.begin(), names.end(), [&](const auto &other) {
               return other.second == name;
             });
    }

    // gmsh forgets the names of groups that have no elements.
    void
    note_empty_groups(const std::vector<MshName> &names, MeshDescription &mesh)
    {
      const int dim_of_cells = dimension(mesh.cell_kind);
      std::vector<std::string> empty;
      for (const auto &[dim, number, name] : names)
        {
          const bool is_of_cells = dim == dim_of_cells;
          if (!is_of_cells && dim != dim_of_cells - 1)
            continue;
          auto &unused = is_of_cells ? mesh.unused_material_names
                                     : mesh.unused_boundary_names;
          if (is_known(name,
                       is_of_cells ? mesh.material_names : mesh.boundary_names,
                       unused))
            continue;
          unused[name] = "holds no elements";
          empty.push_back('\'' + name + '\'');
        }
      if (!empty.empty())
        mesh.warnings.push_back(
          mesh.name +
          " names groups that hold no elements: " + join_some(empty) + '.');
    }

    // By another name, since gmsh knows some endings in small letters only, and
    // runs the file mesh.msh.opt that may stand beside mesh.msh. The files that
    // a script names are sought beside it.
    void
    open(const std::filesystem::path &file, const int dim)
    {
      if (is_geo_script(file))
        return open_with_groups(file, dim);
      const auto link =
        std::filesystem::temp_directory_path() /
        ("springfit_" + std::to_string(::getpid()) + ending_of(file));
      std::filesystem::remove(link);
      std::filesystem::create_symlink(std::filesystem::absolute(file), link);
      const auto remove = [&link]() { std::filesystem::remove(link); };
      try
        {
          open_with_groups(link, dim);
        }
      catch (std::string &complaint)
        {
          remove();
          if (const auto at = complaint.find(link.string());
              at != std::string::npos)
            complaint.replace(at, link.string().size(), file.string());
          throw;
        }
      catch (...)
        {
          remove();
          throw;
        }
      remove();
    }

    MeshDescription
    read(const ObjectRequest &request)
    {
      const std::string name = name_of(request);
      const auto announced   = announced_in(request.file);
      const GmshSession gmsh_session;
      if (states_its_unit(request.file))
        gmsh::option::setString("Geometry.OCCTargetUnit", "M");
      open(request.file, request.dim);

      const bool has_own_cells = !is_unmeshed_geometry();
      if (!has_own_cells)
        mesh_geometry(request);
      else if (!request.cell_size.empty())
        refuse_cell_size(request);
      check_dimension(name, request.dim);
      if (announced)
        check_arrival(name, *announced, request.dim);

      GmshCells cells = read_gmsh_cells(name, request.dim);
      check_no_duplicate_cells(cells.mesh); // or sides would have three
      const auto names = ending_of(request.file) == ".msh"
                           ? names_in_msh(request.file)
                           : std::vector<MshName>();
      read_materials(cells, names);
      read_boundaries(cells, names);
      MeshDescription &mesh = cells.mesh;
      if (announced)
        count_unused_nodes(*announced, mesh);
      note_empty_groups(names, mesh);
      if (states_its_unit(request.file) && request.scale != 1.)
        mesh.warnings.push_back(
          name + " states the unit of its lengths, which are taken in m and "
                 "then multiplied by Geometry/Scale.");
      return mesh;
    }
  } // namespace


  void
  refuse_cell_size(const ObjectRequest &request)
  {
    throw EntryError("Geometry/Cell size",
                     name_of(request) + " has its own cells.",
                     "Leave the entry empty, or give a geometry that is yet to "
                     "be meshed.");
  }


  MeshDescription
  read_gmsh_file(const ObjectRequest &request)
  {
    MeshDescription mesh;
    run_gmsh(name_of(request), [&]() { mesh = read(request); });
    return mesh;
  }
} // namespace springfit
