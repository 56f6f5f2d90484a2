#ifndef springfit_tests_mesh_scene_h
#define springfit_tests_mesh_scene_h

#include <springfit/mesh/geometry.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>

/** Entries of the section Geometry, each as "Cells = triangles; ". */
inline std::string
section_of(std::string entries)
{
  std::string text = "subsection Geometry\n set ";
  for (const char c : entries)
    text += c == ';' ? std::string("\n set ") : std::string(1, c);
  return text + "\nend\n";
}

/** The mesh that a parameter file would give; paths start in @p folder. */
template <int dim, int spacedim = dim>
std::unique_ptr<springfit::Mesh<dim, spacedim>>
make_mesh(const std::string &entries, const std::string &folder = ".")
{
  dealii::ParameterAcceptor::clear();
  springfit::Geometry<spacedim> geometry;
  auto &prm = dealii::ParameterAcceptor::prm;
  prm.parse_input_from_string(section_of(entries));
  dealii::ParameterAcceptor::parse_all_parameters(prm);
  return geometry.template create<dim>(MPI_COMM_SELF, folder);
}

template <int dim, int spacedim>
double
measure_of(const springfit::Mesh<dim, spacedim> &mesh)
{
  double measure = 0.;
  for (const auto &cell : mesh.triangulation.active_cell_iterators())
    {
      EXPECT_GT(cell->measure(), 0.);
      measure += cell->measure();
    }
  return measure;
}

#endif
