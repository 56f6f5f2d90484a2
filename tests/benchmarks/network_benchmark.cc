// Time of the forces of a network, of its tangent times a vector without a
// matrix, and of the entries of its tangent: the price of an explicit step in
// time, of an iteration of an implicit one, and of a step of Newton's method.
// Per cell of regular meshes of at least 10^5 cells, which no cache holds,
// whose cells share springs and angles (hexahedra with all couplings: 4096
// cells).
//
// Names are what/cells/model/law; families/cells/word/ has the forces of a
// single family with its members and bytes per second, triad the memory's own
// speed (McCalpin's STREAM, a = b + s c).

#include <springfit/core/words.h>
#include <springfit/fit/cell/cell_terms.h>
#include <springfit/fit/cell/stable_neo_hookean.h>
#include <springfit/fit/enrichment.h>
#include <springfit/fit/problem.h>
#include <springfit/springs/network.h>
#include <springfit/springs/spring_law.h>
#include <springfit/springs/volume_law.h>
#include <springfit/springs/zero_lengths.h>

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
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
  make_grid(const CellKind kind, const unsigned int n) // cells along an edge
  {
    const int dim        = dimension(kind);
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

  unsigned int
  cells_along_an_edge(const CellKind kind, const std::string &model)
  {
    switch (kind)
      {
        case CellKind::triangle:
          return 230;
        case CellKind::quadrilateral:
          return 320;
        case CellKind::tetrahedron:
          return 26;
        default:
          return model == "coupling" ? 16 : 47;
      }
  }


  /** The springs of a cell. */
  using Model = std::function<Families(const FitProblem &)>;

  struct NamedModel
  {
    std::string name;
    Model model;
  };

  /** Times do not depend on the constants. */
  std::vector<NamedModel>
  models(const CellKind kind)
  {
    std::vector<NamedModel> all;
    for (const Enrichment enrichment : {Enrichment::none,
                                        Enrichment::volume,
                                        Enrichment::angles,
                                        Enrichment::coupling})
      all.push_back({word_of(enrichment_words(), enrichment),
                     [enrichment](const FitProblem &problem) {
                       return unit_families(problem, enrichment);
                     }});
    for (const auto &[law, word] : volume_law_words())
      {
        const std::string name =
          "stable neo-hookean, " +
          (law == VolumeLaw::quadratic ? std::string() : word + " ");
        all.push_back(
          {name + "volume", [law = law](const FitProblem &problem) {
             return fit_stable_neo_hookean_volume(problem, law).families;
           }});
        if (!is_simplex(kind))
          all.push_back(
            {name + "point volumes", [law = law](const FitProblem &problem) {
               return fit_stable_neo_hookean_points(problem, law).families;
             }});
      }
    return all;
  }


  /** A network, and a state of it away from rest. */
  struct Example
  {
    SpringNetwork network;
    std::size_t n_cells;
    Eigen::MatrixXd x;
    Eigen::MatrixXd u;
  };

  Example
  make_example(const CellKind kind,
               const NamedModel &model,
               const SpringLaw law)
  {
    const Grid grid = make_grid(kind, cells_along_an_edge(kind, model.name));
    NetworkBuilder builder(grid.nodes);
    for (const Cell &cell : grid.cells)
      {
        Eigen::MatrixXd points(grid.nodes.rows(), cell.size());
        for (std::size_t v = 0; v < cell.size(); ++v)
          points.col(v) = grid.nodes.col(cell[v]);
        auto problem =
          make_fit_problem(points,
                           kind,
                           Eigen::MatrixXd::Zero(points.size(), points.size()),
                           {1., 0.3, 1.});
        problem.law = law;
        for (const auto &family : model.model(problem))
          builder.add(family, cell);
      }
    oracle::Random random(2010);
    Example example{builder.build(), grid.cells.size(), grid.nodes, {}};
    example.x += 0.05 * random.matrix(grid.nodes.rows(), grid.nodes.cols());
    example.u = random.matrix(grid.nodes.rows(), grid.nodes.cols());
    return example;
  }

  /** Made when it is first asked for; the last one is kept. */
  const Example &
  example(const CellKind kind, const NamedModel &model, const SpringLaw law)
  {
    static std::string name;
    static std::unique_ptr<Example> kept;
    const std::string wanted = word_of(cell_kind_words(), kind) + model.name +
                               word_of(spring_law_words(), law);
    if (name != wanted)
      {
        kept.reset();
        kept = std::make_unique<Example>(make_example(kind, model, law));
        name = wanted;
      }
    return *kept;
  }


  void
  time_forces(benchmark::State &state, const Example &example)
  {
    Eigen::MatrixXd forces =
      Eigen::MatrixXd::Zero(example.x.rows(), example.x.cols());
    // Batches of all cells: the time shown is the average of one.
    while (state.KeepRunningBatch(example.n_cells))
      {
        add_forces(example.network.families, example.x, forces);
        benchmark::DoNotOptimize(forces.data());
      }
  }

  void
  time_product(benchmark::State &state, const Example &example)
  {
    Eigen::MatrixXd product =
      Eigen::MatrixXd::Zero(example.x.rows(), example.x.cols());
    while (state.KeepRunningBatch(example.n_cells))
      {
        add_tangent_product(example.network.families,
                            example.x,
                            example.u,
                            product);
        benchmark::DoNotOptimize(product.data());
      }
  }

  void
  time_tangent(benchmark::State &state, const Example &example)
  {
    NodePattern pattern(example.x.cols());
    add_to_pattern(example.network.families, pattern);
    TangentMatrix tangent(example.x.rows(), pattern);
    while (state.KeepRunningBatch(example.n_cells))
      {
        tangent.set_zero();
        add_tangent(example.network.families, example.x, tangent);
        benchmark::DoNotOptimize(tangent.matrix().valuePtr());
      }
  }

  /**
   * What has to come from memory and go there: the members' nodes and numbers,
   * the places, and the forces twice.
   */
  double
  bytes_of_forces(const Family &family, const Eigen::MatrixXd &x)
  {
    double numbers = 0.;
    for (const auto &column : family.members.columns)
      numbers += column.size();
    if (family.kind == &zero_lengths(x.rows()))
      numbers -= family.size(); // the rest lengths
    return sizeof(unsigned int) * family.members.nodes.size() +
           sizeof(double) * (numbers + 3. * x.size());
  }

  void
  time_family(benchmark::State &state,
              const Example &example,
              const Family &family)
  {
    Eigen::MatrixXd forces =
      Eigen::MatrixXd::Zero(example.x.rows(), example.x.cols());
    for (auto _ : state)
      {
        family.kind->add_forces(family.members, example.x, forces);
        benchmark::DoNotOptimize(forces.data());
      }
    state.SetItemsProcessed(state.iterations() * family.size());
    state.SetBytesProcessed(state.iterations() *
                            bytes_of_forces(family, example.x));
  }

  void
  time_triad(benchmark::State &state)
  {
    const Eigen::Index n = 20000000;
    // Touched before, so that their pages are there.
    Eigen::VectorXd a = Eigen::VectorXd::Ones(n), b = a, c = a;
    for (auto _ : state)
      {
        a = b + 3. * c;
        benchmark::DoNotOptimize(a.data());
      }
    state.SetBytesProcessed(state.iterations() * 3 * n * sizeof(double));
  }

  void
  register_models(const CellKind kind)
  {
    using Work =
      std::pair<const char *, void (*)(benchmark::State &, const Example &)>;
    const std::string cells = word_of(cell_kind_words(), kind);
    for (const auto &model : models(kind))
      for (const auto &[law, law_word] : spring_law_words())
        for (const auto &[what, work] : {Work{"forces", &time_forces},
                                         Work{"product", &time_product},
                                         Work{"tangent", &time_tangent}})
          benchmark::RegisterBenchmark(
            (what + ('/' + cells) + '/' + model.name + '/' + law_word).c_str(),
            [kind, model, law = law, work = work](benchmark::State &state) {
              work(state, example(kind, model, law));
            })
            ->Unit(benchmark::kNanosecond);
  }

  void
  register_families(const CellKind kind)
  {
    const std::string cells = word_of(cell_kind_words(), kind);
    for (const auto &model : models(kind))
      {
        // The springs are those of the first model, and of stable neo-hookean.
        const std::size_t n = model.name == "none" ? 1 : 2;
        for (std::size_t f = 0; f < n; ++f)
          {
            if (f == 0 && model.name != "none" &&
                model.name != "stable neo-hookean, volume")
              continue;
            benchmark::RegisterBenchmark(
              ("families/" + cells + '/' + model.name + '/' +
               (f == 0 ? "springs" : "others"))
                .c_str(),
              [kind, model, f](benchmark::State &state) {
                const auto &of_all = example(kind, model, SpringLaw::quadratic);
                const Family &family = of_all.network.families[f];
                state.SetLabel(family.kind->word());
                time_family(state, of_all, family);
              })
              ->Unit(benchmark::kMicrosecond);
          }
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  benchmark::RegisterBenchmark("triad", time_triad)
    ->Unit(benchmark::kMillisecond)
    ->MinTime(0.5);
  for (const CellKind kind : oracle::all_kinds)
    register_families(kind);
  for (const CellKind kind : oracle::all_kinds)
    register_models(kind);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
