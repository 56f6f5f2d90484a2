#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/mesh/build_mesh.h>
#include <springfit/mesh/file_formats.h>
#include <springfit/mesh/geometry.h>
#include <springfit/mesh/jitter.h>
#include <springfit/mesh/leave_out.h>
#include <springfit/mesh/mesh_checks.h>
#include <springfit/mesh/refine.h>
#include <springfit/mesh/sizes.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    std::string
    help_on_objects()
    {
      std::string text = "The object. ";
      for (const Object &object : objects())
        text += object.name + ": " + object.help + ". ";
      return text + "No unit.";
    }

    std::string
    text_of(const std::vector<double> &size)
    {
      return dealii::Patterns::Tools::to_string(size);
    }

    std::string
    help_on_size(const int spacedim)
    {
      std::string text =
        std::string("Extents of the object along x") +
        (spacedim == 2 ? " and y" : ", y and z") +
        ", separated by commas; of a cylinder: height, diameter, diameter; "
        "of a cell: the length of its edges. Not for a file. If empty, the object's own";
      for (const Object &object : objects())
        for (const auto &[dim, size] : object.default_size)
          if (dim <= spacedim && size.size() <= std::size_t(spacedim))
            text += "; " + object.name +
                    (dim < spacedim ? " of triangles: " : ": ") + text_of(size);
      return text + ". In m.";
    }

    /**
     * The mesh of an object. gmsh has tolerances in its unit of length: what is
     * far from its size is made some tens of millimetres large, in gmsh's
     * eyes, and brought back.
     */
    MeshDescription
    describe(const Object &object, ObjectRequest request)
    {
      if (request.size.empty())
        return object.describe(request);
      const double extent =
        *std::max_element(request.size.begin(), request.size.end());
      if (extent > 1e-3 && extent < 1e2)
        return object.describe(request);
      const double factor = std::pow(10., -2. - std::floor(std::log10(extent)));
      for (double &size : request.size)
        size *= factor;
      for (double &size : request.cell_size)
        size *= factor;
      auto mesh = object.describe(request);
      for (auto &vertex : mesh.vertices)
        for (double &x : vertex)
          x /= factor;
      if (mesh.straight_part)
        {
          mesh.straight_part->lowest /= factor;
          mesh.straight_part->highest /= factor;
        }
      return mesh;
    }

    /** @throws EntryError when there would be too many cells. */
    void
    check_refinements(const double n_cells,
                      const int dim,
                      const unsigned int refinements)
    {
      constexpr double most = 5e7;
      const double n        = n_cells * std::pow(2., dim * int(refinements));
      if (refinements > 0 && n > most)
        throw EntryError("Geometry/Refinements",
                         "they would make " + text_of({n}) +
                           " cells, more than " + text_of({most}) + ".",
                         "Give fewer: each makes 4 cells of one in the plane, "
                         "8 in space.");
    }

    std::string
    help_on_cells()
    {
      return "The cells: " + join(words_of(cell_kind_words())) +
             ". Boxes, cylinders and specimens have structured "
             "quadrilaterals and hexahedra; gmsh makes the others. A mesh file decides for "
             "itself; a geometry file can have all but hexahedra. In 3-d, "
             "triangles are a surface in space: a membrane in plane stress, "
             "without stiffness in bending. No unit.";
    }
  } // namespace


  template <int spacedim>
  Geometry<spacedim>::Geometry() : ParameterAcceptor("Geometry")
  {
    add_parameter("Object", object_, help_on_objects());
    add_parameter("Cells", cells_, help_on_cells());
    add_parameter("Size", size_, help_on_size(spacedim));
    add_parameter(
      "Cell size",
      cell_size_,
      "Edge length of a cell. Quadrilaterals and hexahedra may "
      "have one for each direction, separated by commas (of a "
      "cylinder: along its axis, around it, along its radius; of "
      "a specimen, whose width varies: at half the grip's width; "
      "not of tissue). At most a quarter of a specimen's "
      "transition, the width of its straight part and, for "
      "tetrahedra, its thickness; the radius of a hole; a quarter "
      "of the tissue's smaller extent. The largest edge that a geometry file is meshed with; a "
      "mesh file has its own. Not for a cell. If empty, " +
        text_of({default_cell_size}) + ". In m.");
    add_parameter("Refinements",
                  refinements_,
                  "How many times each edge of the mesh is divided in two, "
                  "be it made or read (no unit). Sides that are curved stay "
                  "as the coarse mesh has them.",
                  prm,
                  dealii::Patterns::Integer(0));
    add_parameter("Jitter",
                  jitter_,
                  "Distort the mesh: each coordinate of every vertex inside "
                  "the object moves by a random number between -Jitter and "
                  "Jitter times the shortest edge that meets there, the same "
                  "in every run. Boundaries stay as they are, interfaces of "
                  "materials move. At least 0, less than 0.5. No unit.");
    add_parameter("File",
                  file_,
                  "Mesh file (.msh 1 to 4, .vtk, .inp, .unv, .mesh, .bdf) or "
                  "geometry file (.geo, .step, .brep), relative to the folder "
                  "of this parameter file. A .geo file is a program that gmsh "
                  "runs: take none from strangers. No unit.");
    add_parameter("Material ids",
                  material_array_,
                  "Name of the cell array of a .vtk file that holds the ids of "
                  "the materials and, for sides of cells, of the boundaries. "
                  "No unit.");
    add_parameter("Leave out",
                  left_out_,
                  "Materials of the mesh, by names or numbers between commas, "
                  "whose cells are not built: what no load reaches, or what "
                  "is stiff enough to be held instead. Where the rest touched "
                  "them it has a boundary with the name of the material "
                  "(left out 3, of one without a name). No unit.");
    add_parameter("Scale",
                  scale_,
                  "Length of a unit of File, as 0.001 for a file in mm. In m. "
                  "STEP and IGES files state their unit and are taken in m: "
                  "leave it at 1.");
    this->parse_parameters_call_back.connect([this]() {
      complete();
      check();
    });
  }


  template <int spacedim>
  void
  Geometry<spacedim>::complete()
  {
    // Through the entry, so that it is among the values in force.
    const auto &sizes = find_object(object_).default_size;
    if (const auto own = sizes.find(dimension_of_cells());
        size_.empty() && own != sizes.end())
      this->prm.set("Size", text_of(own->second));
    if (cell_size_.empty() && find_object(object_).check_files == nullptr)
      this->prm.set("Cell size", text_of({default_cell_size}));
  }


  template <int spacedim>
  Meshing
  Geometry<spacedim>::meshing() const
  {
    return {value_of(cell_kind_words(), cells_, "Geometry/Cells"),
            cell_size_,
            refinements_};
  }


  template <int spacedim>
  int
  Geometry<spacedim>::dimension_of_cells() const
  {
    return dimension(meshing().cells);
  }


  template <int spacedim>
  bool
  Geometry<spacedim>::has_its_own_cells() const
  {
    return find_object(object_).check_files != nullptr &&
           !is_geometry_file(file_);
  }


  template <int spacedim>
  ObjectRequest
  Geometry<spacedim>::request(const Meshing &meshing,
                              const std::filesystem::path &folder_of_prm) const
  {
    ObjectRequest request;
    request.dim       = dimension(meshing.cells);
    request.spacedim  = spacedim;
    request.cell_kind = meshing.cells;
    request.size      = size_;
    request.cell_size = meshing.cell_size;
    if (!file_.empty())
      request.file = folder_of_prm / file_;
    request.scale          = scale_;
    request.material_array = material_array_;
    return request;
  }


  template <int spacedim>
  void
  Geometry<spacedim>::check() const
  {
    check(meshing());
  }


  template <int spacedim>
  void
  Geometry<spacedim>::check(const Meshing &meshing) const
  {
    const Object &object        = find_object(object_);
    const ObjectRequest request = this->request(meshing, "");
    if (request.dim > spacedim)
      throw EntryError("Geometry/Cells",
                       word_of(cell_kind_words(), meshing.cells) +
                         " are cells of dimension 3, the scene has "
                         "dimension 2.",
                       "Set it to triangles or quadrilaterals, or change "
                       "Dimension.");
    if (request.dim < spacedim && !is_simplex(request.cell_kind))
      throw EntryError("Geometry/Cells",
                       "a surface in space is made of triangles.",
                       "Split each quadrilateral into two, or set Dimension "
                       "= 2 for a plane mesh.");
    constexpr unsigned int most_refinements = 5;
    if (meshing.refinements > most_refinements)
      throw EntryError("Geometry/Refinements",
                       std::to_string(meshing.refinements) +
                         " make too many cells.",
                       "Give at most " + std::to_string(most_refinements) +
                         ": each makes 4 cells of one in the plane, 8 in "
                         "space.");
    object.check(request);
    if (!(jitter_ >= 0. && jitter_ < 0.5))
      throw EntryError("Geometry/Jitter",
                       text_of(jitter_) + " is out of range.",
                       "Give a fraction of the cells' edges, at least 0 and "
                       "less than 0.5.");
    if (jitter_ > 0. && request.dim < spacedim)
      throw EntryError("Geometry/Jitter",
                       "surfaces in space are not distorted.",
                       "Leave it at 0.");
  }


  template <int spacedim>
  void
  Geometry<spacedim>::check_files(
    const std::filesystem::path &folder_of_prm) const
  {
    const Object &object = find_object(object_);
    if (object.check_files != nullptr)
      object.check_files(request(meshing(), folder_of_prm));
  }


  template <int spacedim>
  template <int dim>
  std::unique_ptr<Mesh<dim, spacedim>>
  Geometry<spacedim>::create(const MPI_Comm communicator,
                             const std::filesystem::path &folder_of_prm) const
  {
    return create<dim>(meshing(), communicator, folder_of_prm);
  }


  template <int spacedim>
  template <int dim>
  std::unique_ptr<Mesh<dim, spacedim>>
  Geometry<spacedim>::create(const Meshing &meshing,
                             const MPI_Comm communicator,
                             const std::filesystem::path &folder_of_prm) const
  {
    check(meshing);
    Assert(dim == dimension(meshing.cells), dealii::ExcInternalError());
    MeshDescription description;
    run_on_root(communicator, [&]() {
      description =
        describe(find_object(object_), request(meshing, folder_of_prm));
      check_refinements(description.n_cells(), dim, meshing.refinements);
      if (!left_out_.empty())
        leave_out(description, split_at_commas(left_out_));
      if constexpr (dim == spacedim)
        check_mesh(description);
      else
        check_surface(description);
      if (jitter_ > 0.)
        jitter(description, jitter_);
    });
    description =
      dealii::Utilities::MPI::broadcast(communicator, description, 0);
    auto mesh = build_mesh<dim, spacedim>(
      description, dealii::Utilities::MPI::n_mpi_processes(communicator));
    for (unsigned int i = 0; i < meshing.refinements; ++i)
      refine(*mesh);
    return mesh;
  }


  template class Geometry<2>;
  template class Geometry<3>;
  template std::unique_ptr<Mesh<2>>
  Geometry<2>::create(MPI_Comm, const std::filesystem::path &) const;
  template std::unique_ptr<Mesh<2, 3>>
  Geometry<3>::create(MPI_Comm, const std::filesystem::path &) const;
  template std::unique_ptr<Mesh<3>>
  Geometry<3>::create(MPI_Comm, const std::filesystem::path &) const;
  template std::unique_ptr<Mesh<2>>
  Geometry<2>::create(const Meshing &,
                      MPI_Comm,
                      const std::filesystem::path &) const;
  template std::unique_ptr<Mesh<2, 3>>
  Geometry<3>::create(const Meshing &,
                      MPI_Comm,
                      const std::filesystem::path &) const;
  template std::unique_ptr<Mesh<3>>
  Geometry<3>::create(const Meshing &,
                      MPI_Comm,
                      const std::filesystem::path &) const;
} // namespace springfit
