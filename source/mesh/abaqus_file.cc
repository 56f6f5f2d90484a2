#include <springfit/mesh/abaqus_boundaries.h>
#include <springfit/mesh/abaqus_cells.h>
#include <springfit/mesh/abaqus_file.h>
#include <springfit/mesh/abaqus_materials.h>
#include <springfit/mesh/abaqus_model.h>

#include <utility>

namespace springfit
{
  MeshDescription
  read_abaqus_file(const std::filesystem::path &file,
                   const std::string &name,
                   const int dim)
  {
    const AbaqusModel model = make_abaqus_model(read_abaqus_blocks(file));
    AbaqusCells cells(model, name, dim);
    const auto material_names = label_abaqus_materials(model, cells);
    label_abaqus_boundaries(model, material_names, cells);
    return std::move(cells.mesh());
  }
} // namespace springfit
