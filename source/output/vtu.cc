#include <springfit/core/atomic_file.h>
#include <springfit/output/vtu.h>

#include <deal.II/base/data_out_base.h>

#include <cstddef>
#include <tuple>

namespace springfit
{
  namespace
  {
    using Interpretation =
      dealii::DataComponentInterpretation::DataComponentInterpretation;
    using VectorRange =
      std::tuple<unsigned int, unsigned int, std::string, Interpretation>;

    /** Names of all components, and which of them are vectors. */
    struct Components
    {
      std::vector<std::string> names;
      std::vector<VectorRange> vectors;
    };

    Components
    describe(const std::vector<NodalField> &fields, const int dim)
    {
      Components components;
      for (const auto &field : fields)
        {
          const unsigned int first = components.names.size();
          const unsigned int n     = field.values.rows();
          components.names.insert(components.names.end(), n, field.name);
          if (n == static_cast<unsigned int>(dim))
            components.vectors.emplace_back(
              first,
              first + n - 1,
              field.name,
              dealii::DataComponentInterpretation::component_is_part_of_vector);
        }
      return components;
    }

    /** Copy a node's values, component by component, to a patch's vertex. */
    template <typename PatchType>
    void
    fill(PatchType &patch,
         const unsigned int vertex,
         const std::vector<NodalField> &fields,
         const unsigned int node)
    {
      unsigned int component = 0;
      for (const auto &field : fields)
        for (Eigen::Index c = 0; c < field.values.rows(); ++c)
          patch.data(component++, vertex) = field.values(c, node);
    }

    template <int dim, int spacedim>
    void
    write(const std::filesystem::path &path,
          const std::vector<dealii::DataOutBase::Patch<dim, spacedim>> &patches,
          const Components &components)
    {
      dealii::DataOutBase::VtkFlags flags;
      // The same results are the same files.
      flags.print_date_and_time = false;
      // The best compression takes several times as long and saves a twentieth.
      flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
      write_file(path, [&](std::ostream &file) {
        dealii::DataOutBase::write_vtu(
          patches, components.names, components.vectors, flags, file);
      });
    }
  } // namespace

  namespace
  {
    template <int dim, int spacedim, typename Condition>
    void
    write_cells(const std::filesystem::path &path,
                const Mesh<dim, spacedim> &mesh,
                const Condition &is_wanted,
                const std::vector<NodalField> &fields,
                const std::vector<CellField> &cell_fields)
    {
      auto components                = describe(fields, spacedim);
      const std::size_t n_components = components.names.size();
      for (const auto &field : cell_fields)
        components.names.push_back(field.name);
      std::vector<dealii::DataOutBase::Patch<dim, spacedim>> patches;
      patches.reserve(mesh.triangulation.n_active_cells());
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        {
          const unsigned int c = cell->active_cell_index();
          if (!is_wanted(c))
            continue;
          dealii::DataOutBase::Patch<dim, spacedim> patch;
          patch.reference_cell = cell->reference_cell();
          patch.patch_index    = patches.size();
          patch.data.reinit(components.names.size(), cell->n_vertices());
          for (const unsigned int v : cell->vertex_indices())
            {
              patch.vertices[v] = cell->vertex(v);
              fill(patch, v, fields, cell->vertex_index(v));
              for (std::size_t f = 0; f < cell_fields.size(); ++f)
                patch.data(n_components + f, v) = cell_fields[f].values[c];
            }
          patches.push_back(patch);
        }
      write(path, patches, components);
    }
  } // namespace

  template <int dim, int spacedim>
  void
  write_mesh_vtu(const std::filesystem::path &path,
                 const Mesh<dim, spacedim> &mesh,
                 const std::vector<NodalField> &fields)
  {
    write_mesh_vtu(path, mesh, fields, std::vector<CellField>());
  }

  template <int dim, int spacedim>
  void
  write_mesh_vtu(const std::filesystem::path &path,
                 const Mesh<dim, spacedim> &mesh,
                 const std::vector<NodalField> &fields,
                 const std::vector<CellField> &cell_fields)
  {
    write_cells(
      path, mesh, [](unsigned int) { return true; }, fields, cell_fields);
  }

  template <int dim, int spacedim>
  void
  write_mesh_vtu(const std::filesystem::path &path,
                 const Mesh<dim, spacedim> &mesh,
                 const std::vector<bool> &cells,
                 const std::vector<NodalField> &fields)
  {
    write_cells(
      path, mesh, [&](const unsigned int c) { return cells[c]; }, fields, {});
  }

  template <int dim>
  void
  write_springs_vtu(const std::filesystem::path &path,
                    const SpringNetwork &network,
                    const std::vector<NodalField> &fields)
  {
    auto components = describe(fields, dim);
    components.names.insert(components.names.end(), {"k", "rest_length"});
    const unsigned int n = components.names.size();

    std::vector<dealii::DataOutBase::Patch<1, dim>> patches;
    for (const auto &family : network.families)
      {
        if (family.kind->n_nodes() != 2)
          continue;
        for (std::size_t s = 0; s < family.size(); ++s)
          {
            dealii::DataOutBase::Patch<1, dim> patch;
            patch.reference_cell = dealii::ReferenceCells::Line;
            patch.patch_index    = patches.size();
            patch.data.reinit(n, 2);
            for (unsigned int v = 0; v < 2; ++v)
              {
                const unsigned int node = family.nodes(s)[v];
                for (int d = 0; d < dim; ++d)
                  patch.vertices[v][d] = network.nodes(d, node);
                fill(patch, v, fields, node);
                patch.data(n - 2, v) = family.members.columns[0][s];
                patch.data(n - 1, v) = family.members.columns[1][s];
              }
            patches.push_back(patch);
          }
      }
    write(path, patches, components);
  }

  void
  write_pvd(const std::filesystem::path &path,
            const std::vector<std::pair<double, std::string>> &files)
  {
    write_file(path, [&](std::ostream &file) {
      dealii::DataOutBase::write_pvd_record(file, files);
    });
  }

  template void
  write_mesh_vtu<2>(const std::filesystem::path &,
                    const Mesh<2> &,
                    const std::vector<NodalField> &,
                    const std::vector<CellField> &);
  template void
  write_mesh_vtu<2>(const std::filesystem::path &,
                    const Mesh<2> &,
                    const std::vector<NodalField> &);
  template void
  write_mesh_vtu<2>(const std::filesystem::path &,
                    const Mesh<2> &,
                    const std::vector<bool> &,
                    const std::vector<NodalField> &);
  template void
  write_mesh_vtu<2, 3>(const std::filesystem::path &,
                       const Mesh<2, 3> &,
                       const std::vector<NodalField> &,
                       const std::vector<CellField> &);
  template void
  write_mesh_vtu<2, 3>(const std::filesystem::path &,
                       const Mesh<2, 3> &,
                       const std::vector<NodalField> &);
  template void
  write_mesh_vtu<2, 3>(const std::filesystem::path &,
                       const Mesh<2, 3> &,
                       const std::vector<bool> &,
                       const std::vector<NodalField> &);
  template void
  write_mesh_vtu<3>(const std::filesystem::path &,
                    const Mesh<3> &,
                    const std::vector<NodalField> &,
                    const std::vector<CellField> &);
  template void
  write_mesh_vtu<3>(const std::filesystem::path &,
                    const Mesh<3> &,
                    const std::vector<NodalField> &);
  template void
  write_mesh_vtu<3>(const std::filesystem::path &,
                    const Mesh<3> &,
                    const std::vector<bool> &,
                    const std::vector<NodalField> &);
  template void
  write_springs_vtu<2>(const std::filesystem::path &,
                       const SpringNetwork &,
                       const std::vector<NodalField> &);
  template void
  write_springs_vtu<3>(const std::filesystem::path &,
                       const SpringNetwork &,
                       const std::vector<NodalField> &);
} // namespace springfit
