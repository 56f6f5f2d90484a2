// Time of the stiffness R of one cell by deal.II, averaged over 100 random
// cells of each kind: what every fit starts from.

#include <springfit/mesh/build_mesh.h>
#include <springfit/reference/cell_matrices.h>

#include <benchmark/benchmark.h>

#include "../unit/cells.h"

using namespace springfit;

namespace
{
  constexpr unsigned int n_cells = 100;

  template <int dim>
  std::unique_ptr<Mesh<dim>>
  random_cells(const CellKind kind)
  {
    oracle::Random random(2010);
    MeshDescription description;
    description.cell_kind = kind;
    for (unsigned int c = 0; c < n_cells; ++c)
      {
        const Eigen::MatrixXd points = oracle::random_cell(kind, random);
        for (Eigen::Index v = 0; v < points.cols(); ++v)
          {
            MeshPoint point{};
            for (int d = 0; d < dim; ++d)
              point[d] = points(d, v);
            point[0] += 3. * c; // apart from each other
            description.cells.push_back(description.vertices.size());
            description.vertices.push_back(point);
          }
        description.material_ids.push_back(0);
      }
    return build_mesh<dim>(description);
  }

  template <int dim>
  void
  time_stiffness(benchmark::State &state, const CellKind kind)
  {
    const auto mesh    = random_cells<dim>(kind);
    const auto element = make_element<dim>(kind);
    CellMatrices<dim> matrices(element);
    const ElasticConstants constants = {1e4, 0.3, 1000.};
    const CellMaterial material = {constants, lame_constants(constants), 1.};
    while (state.KeepRunningBatch(n_cells))
      for (const auto &cell : mesh->triangulation.active_cell_iterators())
        benchmark::DoNotOptimize(matrices.stiffness(cell, material));
  }
} // namespace

int
main(int argc, char *argv[])
{
  for (const CellKind kind : oracle::all_kinds)
    benchmark::RegisterBenchmark(("R (deal.II)/" + singular(kind)).c_str(),
                                 dimension(kind) == 2 ? time_stiffness<2>
                                                      : time_stiffness<3>,
                                 kind)
      ->Unit(benchmark::kMicrosecond);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
