#include <springfit/mesh/nodes.h>
#include <springfit/reference/cell_matrices.h>
#include <springfit/studies/varied_scene.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace springfit
{
  namespace
  {
    template <int dim, int spacedim>
    void
    move_vertices(const Variation &variation, Mesh<dim, spacedim> &mesh)
    {
      const auto size   = value_of(variation, StabilityAxis::size);
      const auto aspect = value_of(variation, StabilityAxis::aspect_ratio);
      const auto angle  = value_of(variation, StabilityAxis::angle);
      if (!size && !aspect && !angle)
        return;
      const double lean = angle.value_or(90.) * M_PI / 180.;
      dealii::GridTools::transform(
        [&](const dealii::Point<spacedim> &place) {
          dealii::Point<spacedim> moved = place;
          constexpr int last            = spacedim - 1;
          moved[last] /= aspect.value_or(1.);
          moved[0] += std::cos(lean) * moved[last];
          moved[last] *= std::sin(lean);
          return moved;
        },
        mesh.triangulation);
      if (size)
        {
          const dealii::BoundingBox<spacedim> box(
            mesh.triangulation.get_vertices());
          double extent = 0.;
          for (int d = 0; d < spacedim; ++d)
            extent = std::max(extent, box.side_length(d));
          dealii::GridTools::scale(*size / extent, mesh.triangulation);
          if (mesh.straight_part)
            {
              mesh.straight_part->lowest *= *size / extent;
              mesh.straight_part->highest *= *size / extent;
            }
        }
      mesh.nodes = vertices_as_nodes(mesh.triangulation);
    }

    template <int dim, int spacedim>
    void
    change_materials(const Scene<spacedim> &scene,
                     const Variation &variation,
                     CalibratedScene<dim, spacedim> &varied)
    {
      const auto nu       = value_of(variation, StabilityAxis::poissons_ratio);
      const auto modulus  = value_of(variation, StabilityAxis::youngs_modulus);
      const auto contrast = value_of(variation, StabilityAxis::contrast);
      auto &materials     = varied.materials;
      const double first  = materials.begin()->second.constants.youngs_modulus;
      const auto changed  = [&](ElasticConstants constants) {
        if (nu)
          constants.poissons_ratio = *nu;
        if (modulus)
          constants.youngs_modulus *= *modulus / first;
        return scene.material.template with_constants<dim>(constants);
      };
      for (auto &[id, material] : materials)
        material = changed(material.constants);
      if (!contrast)
        return;

      auto &triangulation = varied.mesh->triangulation;
      const double middle =
        dealii::BoundingBox<spacedim>(triangulation.get_vertices()).center()[0];
      const auto n_ids = materials.rbegin()->first + 1;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->center()[0] > middle)
          cell->set_material_id(cell->material_id() + n_ids);
      const MaterialTable soft = materials;
      for (const auto &[id, material] : soft)
        {
          auto constants = material.constants;
          constants.youngs_modulus *= *contrast;
          materials[id + n_ids] =
            scene.material.template with_constants<dim>(constants);
        }
    }
  } // namespace

  template <int dim, int spacedim>
  CalibratedScene<dim, spacedim>
  varied_scene(const Scene<spacedim> &scene,
               const Variation &variation,
               const MPI_Comm communicator)
  {
    auto mesh = scene.geometry.template create<dim>(communicator, scene.folder);
    move_vertices(variation, *mesh);
    auto varied = scene_of<dim>(std::move(mesh), scene);
    change_materials(scene, variation, varied);
    return varied;
  }

  template CalibratedScene<2>
  varied_scene<2>(const Scene<2> &, const Variation &, MPI_Comm);
  template CalibratedScene<2, 3>
  varied_scene<2, 3>(const Scene<3> &, const Variation &, MPI_Comm);
  template CalibratedScene<3>
  varied_scene<3>(const Scene<3> &, const Variation &, MPI_Comm);
} // namespace springfit
