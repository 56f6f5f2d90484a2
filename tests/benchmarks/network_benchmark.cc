// Time of the forces of a network, and of its tangents (with energy and
// forces), for each cell and enrichment and both laws of springs: the price of
// a step in time, and of a step of Newton's method. Per cell of a regular mesh,
// whose cells share springs and angles.

#include <springfit/core/words.h>
#include <springfit/fit/enrichment.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/network.h>
#include <springfit/springs/network_terms.h>
#include <springfit/springs/spring_law.h>
#include <springfit/springs/volume.h>

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "../unit/cells.h"

using namespace springfit;

namespace
{
  using Cell = std::vector<unsigned int>;

  /** A regular mesh of edges of length 1: a square or a cube. */
  struct Grid
  {
    Eigen::MatrixXd nodes;
    std::vector<Cell> cells;
  };

  /** The tensor product cell as cells of @p kind. */
  std::vector<Cell>
  divide(const Cell &v, const CellKind kind)
  {
    if (kind == CellKind::triangle)
      return {{v[0], v[1], v[3]}, {v[0], v[3], v[2]}};
    if (kind == CellKind::tetrahedron) // along the diagonal from 0 to 7
      return {{v[0], v[1], v[3], v[7]},
              {v[0], v[3], v[2], v[7]},
              {v[0], v[2], v[6], v[7]},
              {v[0], v[6], v[4], v[7]},
              {v[0], v[4], v[5], v[7]},
              {v[0], v[5], v[1], v[7]}};
    return {v};
  }

  Grid
  make_grid(const CellKind kind)
  {
    const int dim        = dimension(kind);
    const unsigned int n = dim == 2 ? 16 : 6; // cells along an edge
    const unsigned int m = n + 1;
    Grid grid{Eigen::MatrixXd(dim, dim == 2 ? m * m : m * m * m), {}};
    for (unsigned int v = 0; v < grid.nodes.cols(); ++v)
      for (int d = 0, rest = v; d < dim; ++d, rest /= m)
        grid.nodes(d, v) = rest % m;
    for (unsigned int v = 0; v < grid.nodes.cols(); ++v)
      {
        if (grid.nodes.col(v).maxCoeff() == n)
          continue;
        Cell cell;
        for (int corner = 0; corner < 1 << dim; ++corner)
          cell.push_back(v + (corner & 1) + m * (corner >> 1 & 1) +
                         m * m * (corner >> 2 & 1));
        for (const Cell &part : divide(cell, kind))
          grid.cells.push_back(part);
      }
    return grid;
  }

  /** All constants are 1: the time does not depend on them. */
  SpringNetwork
  make_network(const Grid &grid,
               const CellKind kind,
               const Enrichment enrichment,
               const SpringLaw law)
  {
    const auto &pairs   = node_pairs(kind);
    const auto &triples = cell_angles(kind);
    std::vector<LengthCoupling> couplings;
    for (unsigned int b = 0; b < pairs.size(); ++b)
      for (unsigned int a = 0; a < b; ++a)
        couplings.push_back({a, b, 1.});

    NetworkBuilder builder(grid.nodes);
    for (const Cell &cell : grid.cells)
      {
        builder.add_springs(cell, pairs, Eigen::VectorXd::Ones(pairs.size()));
        if (enrichment == Enrichment::coupling)
          builder.add_couplings(cell, pairs, couplings);
        if (enrichment == Enrichment::angles)
          builder.add_angles(cell,
                             triples,
                             Eigen::VectorXd::Ones(triples.size()));
        if (enrichment == Enrichment::volume)
          builder.add_volume(cell, 1., 1.);
      }
    SpringNetwork network = builder.build();
    network.law           = law;
    return network;
  }

  template <int dim>
  struct Forces
  {
    static void
    run(const SpringNetwork &network, const Eigen::MatrixXd &displacement)
    {
      Eigen::MatrixXd gradient =
        Eigen::MatrixXd::Zero(dim, displacement.cols());
      for (unsigned int t = 0; t < n_terms(network); ++t)
        add_term_gradient<dim>(network, t, displacement, gradient);
      benchmark::DoNotOptimize(gradient);
    }
  };

  template <int dim>
  struct Tangents
  {
    static void
    run(const SpringNetwork &network, const Eigen::MatrixXd &displacement)
    {
      for (unsigned int t = 0; t < n_terms(network); ++t)
        benchmark::DoNotOptimize(evaluate_term<dim>(network, t, displacement));
    }
  };

  template <template <int> class Work>
  void
  time_network(benchmark::State &state,
               const CellKind kind,
               const Enrichment enrichment,
               const SpringLaw law)
  {
    oracle::Random random(2010);
    const Grid grid    = make_grid(kind);
    const auto network = make_network(grid, kind, enrichment, law);
    const Eigen::MatrixXd displacement =
      0.05 * random.matrix(grid.nodes.rows(), grid.nodes.cols());
    const auto run = dimension(kind) == 2 ? &Work<2>::run : &Work<3>::run;
    // Batches of all cells: the time shown is the average of one.
    while (state.KeepRunningBatch(grid.cells.size()))
      run(network, displacement);
  }

  template <template <int> class Work>
  void
  register_all(const std::string &what)
  {
    for (const CellKind kind : oracle::all_kinds)
      for (const auto &[enrichment, word] : enrichment_words())
        for (const auto &[law, law_word] : spring_law_words())
          benchmark::RegisterBenchmark((what + "/" +
                                        word_of(cell_kind_words(), kind) + "/" +
                                        word + "/" + law_word)
                                         .c_str(),
                                       time_network<Work>,
                                       kind,
                                       enrichment,
                                       law)
            ->Unit(benchmark::kMicrosecond);
  }
} // namespace

int
main(int argc, char *argv[])
{
  register_all<Forces>("forces");
  register_all<Tangents>("tangents");
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
