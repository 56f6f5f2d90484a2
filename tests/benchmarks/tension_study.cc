// Do springs whose rest lengths are free pay? The least squares of tensions
// besides stiffnesses, against the closed form of springs of rest length zero:
// square and cube under tension, shear and (cube) torsion, and a bar in
// bending, linear, each model against Q1 on the same mesh and against a fine
// mesh.
//
// Unknown are k_s and T_s / L_s of a cell's springs and k and the pressure p of
// its volume, with the tangent
//   sum_s k_s b_s b_s^T + (T_s / L_s) (I - n n^T)_s + k g g^T + p H,
// linear in all of them, and the forces at rest in equilibrium,
//   sum_s T_s b_s + p g = 0,
// which is linear too: the least squares are over a basis of its null space.
// (Preloaded springs: B. Lloyd, G. Szekely and M. Harders, IEEE TVCG 13 (2007);
// X. Wang and V. Devarajan, The Visual Computer 24 (2008).)

#include <springfit/fit/displacement_fields.h>
#include <springfit/fit/fit.h>
#include <springfit/springs/rigid_modes.h>
#include <springfit/springs/volume.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../unit/cells.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  using Matrix = Eigen::MatrixXd;
  using Vector = Eigen::VectorXd;

  // Cells.

  FitProblem
  problem_of(const Matrix &points, const double nu)
  {
    return fit_problem(points, cell_kind(points.rows(), points.cols()), nu);
  }

  Matrix
  of_fit(const Matrix &points,
         const double nu,
         const std::string &word,
         const Enrichment enrichment)
  {
    FitOptions options;
    options.enrichment  = enrichment;
    options.nonnegative = true;
    const auto problem  = problem_of(points, nu);
    return problem.stiffness -
           residual(problem, fit(problem, method_named(word), options));
  }

  Matrix
  q1(const Matrix &points, const double nu)
  {
    return problem_of(points, nu).stiffness;
  }

  /**
   * Q1 with the mean dilatation of the cell (J. C. Nagtegaal, D. M. Parks and
   * J. R. Rice, CMAME 4 (1974)), which does not lock as nu -> 1/2.
   */
  Matrix
  mean_dilatation(const Matrix &points, const double nu)
  {
    const CellKind kind = cell_kind(points.rows(), points.cols());
    const int dim       = points.rows();
    const double mu     = 0.5 / (1. + nu);
    const double lambda = usual_elasticity(kind, nu)(0, 1);
    const Vector g      = volume_gradient(points, kind);
    return stiffness(points, kind, isotropic(dim, 0., mu)) +
           lambda / volume(points, kind) * g * g.transpose();
  }

  /** All terms of a cell by columns: tangents, and forces at rest. */
  struct Terms
  {
    std::vector<Matrix> tangents;
    Matrix forces;
  };

  Terms
  terms_under_tension(const FitProblem &problem)
  {
    const Matrix &x        = problem.points;
    const Eigen::Index dim = x.rows(), n = x.size();
    std::vector<Matrix> tangents;
    std::vector<Vector> forces;
    const auto add = [&](const Matrix &tangent, const Vector &force) {
      const double size = tangent.norm();
      tangents.push_back(tangent / size);
      forces.push_back(force / size);
    };
    for (std::size_t s = 0; s < problem.springs.size(); ++s)
      {
        const auto [i, j]  = problem.springs[s];
        const Vector b     = problem.gradients.col(s);
        const double L     = (x.col(j) - x.col(i)).norm();
        const Vector along = (x.col(j) - x.col(i)) / L;
        const Matrix across =
          Matrix::Identity(dim, dim) - along * along.transpose();
        Matrix turning = Matrix::Zero(n, n);
        for (const auto a : {i, j})
          for (const auto c : {i, j})
            turning.block(dim * a, dim * c, dim, dim) =
              (a == c ? 1. : -1.) * across;
        add(b * b.transpose(), Vector::Zero(n));
        add(turning, L * b);
      }
    const Vector g = volume_gradient(x, problem.kind);
    add(g * g.transpose(), Vector::Zero(n));
    add(volume_hessian(x, problem.kind), g);

    Terms terms{tangents, Matrix(n, forces.size())};
    for (std::size_t t = 0; t < forces.size(); ++t)
      terms.forces.col(t) = forces[t];
    return terms;
  }

  /** What a least squares fit looks at: linear in a matrix of the cell. */
  using Measure = std::function<Vector(const Matrix &)>;

  Vector
  all_entries(const Matrix &A)
  {
    return A.reshaped();
  }

  /** The rungs of the fit `consistent`, see consistent.h. */
  Measure
  ladder(const Matrix &x)
  {
    const Eigen::Index dim = x.rows();
    const Matrix fields    = affine_fields(x);
    const Matrix M = fields * std::sqrt(fields.cols() / fields.squaredNorm());
    const Matrix H = hourglass_basis(x);
    const Eigen::JacobiSVD<Matrix> svd(H.transpose() * quadratic_fields(x),
                                       Eigen::ComputeFullU);
    const Eigen::ArrayXd part =
      svd.singularValues().array() / svd.singularValues()[0];
    const Vector length  = part.square() / (part.square() + 0.0025);
    const Matrix reached = H * svd.matrixU() * length.asDiagonal();
    return [=](const Matrix &A) {
      const Matrix tensor = M.transpose() * A * M;
      Vector all(2 + tensor.size() + 2 * M.cols() * H.cols() +
                 H.cols() * H.cols());
      all << 1e4 * tensor.topLeftCorner(dim, dim).sum(), 1e4 * tensor.trace(),
        1e3 * tensor.reshaped(),
        300. * (M.transpose() * A * reached).reshaped(),
        std::sqrt(2.) * (M.transpose() * A * H).reshaped(),
        (H.transpose() * A * H).reshaped();
      return all;
    };
  }

  double worst_imbalance = 0.; // of all cells fitted

  Matrix
  with_free_rest_lengths(const FitProblem &problem, const Measure &measure)
  {
    const Terms terms  = terms_under_tension(problem);
    const Matrix basis = terms.forces.fullPivLu().kernel();
    Matrix A(measure(problem.stiffness).size(), basis.rows());
    for (Eigen::Index t = 0; t < basis.rows(); ++t)
      A.col(t) = measure(terms.tangents[t]);
    const Vector c = basis * (A * basis).colPivHouseholderQr().solve(
                               measure(problem.stiffness));
    Matrix K = Matrix::Zero(problem.points.size(), problem.points.size());
    for (Eigen::Index t = 0; t < c.size(); ++t)
      K += c[t] * terms.tangents[t];
    worst_imbalance = std::max(worst_imbalance,
                               (terms.forces * c).norm() /
                                 (terms.forces * c.asDiagonal()).norm());
    return K;
  }

  struct Model
  {
    std::string name;
    std::function<Matrix(const Matrix &points, double nu)> stiffness;
  };

  const std::vector<Model> models = {
    {"Q1", &q1},
    {"springs + volume (`consistent`, k >= 0)",
     [](const Matrix &x, const double nu) {
       return of_fit(x, nu, "consistent", Enrichment::volume);
     }},
    {"the same with free rest lengths",
     [](const Matrix &x, const double nu) {
       return with_free_rest_lengths(problem_of(x, nu), ladder(x));
     }},
    {"frobenius with free rest lengths",
     [](const Matrix &x, const double nu) {
       return with_free_rest_lengths(problem_of(x, nu), &all_entries);
     }},
    {"`stable neo-hookean`, `volume`", [](const Matrix &x, const double nu) {
       return of_fit(x, nu, "stable neo-hookean", Enrichment::volume);
     }}};


  // Meshes: boxes of n_cells in each direction; the first one is the pull's.

  struct Grid
  {
    std::vector<int> n_cells;
    Matrix nodes;

    Eigen::Index
    node(const std::vector<int> &index) const
    {
      Eigen::Index number = 0;
      for (int d = index.size() - 1; d >= 0; --d)
        number = number * (n_cells[d] + 1) + index[d];
      return number;
    }
  };

  void
  for_each(const std::vector<int> &n,
           const std::function<void(const std::vector<int> &)> &action)
  {
    std::vector<int> index(n.size(), 0);
    while (true)
      {
        action(index);
        std::size_t d = 0;
        while (d < n.size() && ++index[d] == n[d])
          index[d++] = 0;
        if (d == n.size())
          return;
      }
  }

  std::vector<int>
  plus(std::vector<int> index, const int corner)
  {
    for (std::size_t d = 0; d < index.size(); ++d)
      index[d] += corner >> d & 1;
    return index;
  }

  Grid
  make_grid(const std::vector<int> &n_cells,
            const double cell_size,
            const double jitter)
  {
    Random random(4);
    const int dim = n_cells.size();
    const auto n  = plus(n_cells, 7);
    Grid grid{n_cells,
              Matrix(dim, dim == 2 ? n[0] * n[1] : n[0] * n[1] * n[2])};
    for_each(n, [&](const std::vector<int> &index) {
      bool is_inner = true;
      for (int d = 0; d < dim; ++d)
        is_inner = is_inner && index[d] > 0 && index[d] < n_cells[d];
      auto x = grid.nodes.col(grid.node(index));
      for (int d = 0; d < dim; ++d)
        x[d] =
          cell_size * (index[d] + (is_inner ? jitter * random(-1., 1.) : 0.));
    });
    return grid;
  }

  std::vector<Eigen::Index>
  cell_nodes(const Grid &grid, const std::vector<int> &cell)
  {
    std::vector<Eigen::Index> nodes;
    for (int v = 0; v < 1 << cell.size(); ++v)
      nodes.push_back(grid.node(plus(cell, v)));
    return nodes;
  }

  /** Every cell as factor^dim cells of its own Q1 mapping. */
  Grid
  refined(const Grid &coarse, const int factor)
  {
    auto n = coarse.n_cells;
    for (int &n_d : n)
      n_d *= factor;
    Grid fine = make_grid(n, 1., 0.);
    for_each(plus(n, 7), [&](const std::vector<int> &index) {
      std::vector<int> cell = index;
      Vector xi(index.size());
      for (std::size_t d = 0; d < index.size(); ++d)
        {
          cell[d] = std::min(index[d] / factor, coarse.n_cells[d] - 1);
          xi[d]   = double(index[d]) / factor - cell[d];
        }
      auto x = fine.nodes.col(fine.node(index));
      x.setZero();
      const auto corners = cell_nodes(coarse, cell);
      for (std::size_t v = 0; v < corners.size(); ++v)
        {
          double weight = 1.;
          for (Eigen::Index d = 0; d < xi.size(); ++d)
            weight *= v >> d & 1 ? xi[d] : 1. - xi[d];
          x += weight * coarse.nodes.col(corners[v]);
        }
    });
    return fine;
  }

  /** Forces of tractions on the last face: dim x n_nodes, integrated. */
  Matrix
  forces(const Grid &grid,
         const std::function<Vector(const Vector &)> &traction)
  {
    const int dim = grid.nodes.rows();
    Matrix all    = Matrix::Zero(dim, grid.nodes.cols());
    auto faces    = grid.n_cells;
    faces[0]      = 1;
    for_each(faces, [&](std::vector<int> face) {
      face[0]            = grid.n_cells[0] - 1;
      const auto corners = cell_nodes(grid, face);
      const int n        = corners.size();
      const double area =
        std::pow((grid.nodes.col(corners[n - 1]) - grid.nodes.col(corners[1]))
                   .cwiseAbs()
                   .maxCoeff(),
                 dim - 1);
      for (int a = 1; a < n; a += 2) // those of the last face
        for (int b = 1; b < n; b += 2)
          {
            double weight = area;
            for (int d = 1; d < dim; ++d)
              weight *= (a >> d & 1) == (b >> d & 1) ? 1. / 3. : 1. / 6.;
            all.col(corners[a]) +=
              weight * traction(grid.nodes.col(corners[b]));
          }
    });
    return all;
  }

  /**
   * The displacements of a grid that the first face holds; nothing where the
   * stiffness is not positive definite.
   */
  std::optional<std::vector<Matrix>>
  respond(const Grid &grid,
          const std::function<Matrix(const Matrix &)> &cell_stiffness,
          const std::vector<Matrix> &loads)
  {
    const int dim = grid.nodes.rows();
    std::vector<Eigen::Index> unknown(grid.nodes.size(), -1);
    Eigen::Index n_unknowns = 0;
    for (Eigen::Index v = 0; v < grid.nodes.cols(); ++v)
      if (v % (grid.n_cells[0] + 1) != 0)
        for (int d = 0; d < dim; ++d)
          unknown[dim * v + d] = n_unknowns++;

    std::vector<Eigen::Triplet<double>> entries;
    for_each(grid.n_cells, [&](const std::vector<int> &cell) {
      const auto nodes = cell_nodes(grid, cell);
      const Matrix K   = cell_stiffness(grid.nodes(Eigen::all, nodes));
      for (Eigen::Index a = 0; a < K.rows(); ++a)
        for (Eigen::Index b = 0; b < K.cols(); ++b)
          {
            const auto row    = unknown[dim * nodes[a / dim] + a % dim];
            const auto column = unknown[dim * nodes[b / dim] + b % dim];
            if (row >= 0 && column >= 0)
              entries.emplace_back(row, column, K(a, b));
          }
    });
    Eigen::SparseMatrix<double> K(n_unknowns, n_unknowns);
    K.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(K);
    if (factors.info() != Eigen::Success || factors.vectorD().minCoeff() <= 0.)
      return {};

    std::vector<Matrix> displacements;
    for (const auto &load : loads)
      {
        Vector f(n_unknowns);
        for (std::size_t i = 0; i < unknown.size(); ++i)
          if (unknown[i] >= 0)
            f[unknown[i]] = load.reshaped()[i];
        const Vector u = factors.solve(f);
        Matrix all     = Matrix::Zero(dim, grid.nodes.cols());
        for (std::size_t i = 0; i < unknown.size(); ++i)
          if (unknown[i] >= 0)
            all.reshaped()[i] = u[unknown[i]];
        displacements.push_back(all);
      }
    return displacements;
  }


  // The tables.

  /** e_rms in % of the largest displacement, as in comparison.csv. */
  double
  error(const Matrix &reference, const Matrix &model)
  {
    return 100. * (model - reference).norm() / std::sqrt(model.cols()) /
           reference.colwise().norm().maxCoeff();
  }

  std::vector<Matrix>
  load_cases(const Grid &grid)
  {
    const int dim = grid.nodes.rows();
    const auto in = [dim](const int d) {
      return
        [dim, d](const Vector &) -> Vector { return Vector::Unit(dim, d); };
    };
    std::vector<Matrix> cases = {forces(grid, in(0)), forces(grid, in(1))};
    if (dim == 3)
      cases.push_back(forces(grid, [](const Vector &x) -> Vector {
        return Eigen::Vector3d(0., 0.5 - x[2], x[1] - 0.5);
      }));
    return cases;
  }

  using Errors = std::optional<std::vector<double>>;

  std::string
  text(const Errors &errors)
  {
    if (!errors)
      return " unstable";
    std::string all;
    for (const double e : *errors)
      {
        char number[32];
        std::snprintf(
          number, sizeof(number), "%s%.2f", all.empty() ? " " : " / ", e);
        all += number;
      }
    return all;
  }

  /** Errors of a model on a unit square or cube. */
  Errors
  errors_of(const Model &model,
            const Grid &grid,
            const double nu,
            const std::vector<Matrix> &reference)
  {
    const auto found = respond(
      grid,
      [&](const Matrix &x) { return model.stiffness(x, nu); },
      load_cases(grid));
    if (!found)
      return {};
    std::vector<double> errors;
    for (std::size_t c = 0; c < found->size(); ++c)
      errors.push_back(error(reference[c], (*found)[c]));
    return errors;
  }

  /** The fine mesh's displacements at the nodes of the coarse one. */
  std::vector<Matrix>
  fine_reference(const Grid &grid, const double nu, const int factor)
  {
    const Grid fine = refined(grid, factor);
    const auto all  = *respond(
      fine,
      [&](const Matrix &x) { return mean_dilatation(x, nu); },
      load_cases(fine));
    std::vector<Matrix> at_nodes;
    for (const auto &u : all)
      {
        Matrix own(u.rows(), grid.nodes.cols());
        for_each(plus(grid.n_cells, 7), [&](const std::vector<int> &index) {
          auto of_fine = index;
          for (int &i : of_fine)
            i *= factor;
          own.col(grid.node(index)) = u.col(fine.node(of_fine));
        });
        at_nodes.push_back(own);
      }
    return at_nodes;
  }

  const std::vector<double> ratios = {0., 0.3, 0.45, 0.49};

  void
  print_header(const std::string &first, const std::string &column)
  {
    std::printf("| %s |", first.c_str());
    for (const double nu : ratios)
      std::printf(" nu = %g, %s |", nu, column.c_str());
    std::printf("\n|---|");
    for (std::size_t c = 0; c < ratios.size(); ++c)
      std::printf("---|");
    std::printf("\n");
  }

  void
  print_errors(const std::vector<int> &n_cells, const double jitter)
  {
    const int dim   = n_cells.size();
    const Grid grid = make_grid(n_cells, 1. / n_cells[0], jitter);
    std::map<double, std::vector<Matrix>> same, fine;
    for (const double nu : ratios)
      {
        same[nu] = *respond(
          grid, [&](const Matrix &x) { return q1(x, nu); }, load_cases(grid));
        fine[nu] = fine_reference(grid, nu, dim == 2 ? 8 : 4);
      }
    std::printf("\n%s of %d^%d cells%s, e_rms in %%: %s.\n\n",
                dim == 2 ? "Square" : "Cube",
                n_cells[0],
                dim,
                jitter > 0. ? ", inner vertices moved by up to 20 % of the edge"
                            : "",
                dim == 2 ? "tension / shear" : "tension / shear / torsion");
    for (const bool against_fine : {false, true})
      {
        print_header(against_fine ? "against a fine mesh"
                                  : "against Q1 on the same mesh",
                     "errors");
        for (const auto &model : models)
          {
            std::printf("| %s |", model.name.c_str());
            for (const double nu : ratios)
              std::printf("%s |",
                          text(errors_of(model,
                                         grid,
                                         nu,
                                         against_fine ? fine[nu] : same[nu]))
                            .c_str());
            std::printf("\n");
          }
        std::printf("\n");
      }
  }

  /**
   * Deflection in % of that of Timoshenko's beam, kappa after Cowper (1966);
   * nothing where the bar is unstable.
   */
  std::optional<double>
  deflection(const Model &model, const int n_across, const double nu)
  {
    const Grid bar =
      make_grid({10 * n_across, n_across, n_across}, 1. / n_across, 0.);
    const auto load =
      forces(bar, [](const Vector &) -> Vector { return Vector::Unit(3, 1); });
    const auto found =
      respond(bar,
              [&](const Matrix &x) { return model.stiffness(x, nu); },
              {load});
    if (!found)
      return {};
    const double L = 10., I = 1. / 12., G = 0.5 / (1. + nu);
    const double kappa = 10. * (1. + nu) / (12. + 11. * nu);
    return 100. * load.cwiseProduct(found->front()).sum() /
           (L * L * L / (3. * I) + L / (kappa * G));
  }

  void
  print_bending()
  {
    std::printf(
      "\nA clamped bar of cubes, ten times as long as thick: deflection in %% of "
      "Timoshenko's, 1 / 2 / 4 cells across\n\n");
    print_header("model", "deflection");
    for (const auto &model : models)
      {
        std::printf("| %s |", model.name.c_str());
        for (const double nu : ratios)
          {
            std::string all;
            for (const int n_across : {1, 2, 4})
              {
                const auto found = deflection(model, n_across, nu);
                all +=
                  (all.empty() ? "" : " /") +
                  (found ? text(std::vector<double>{*found}) : " unstable");
              }
            std::printf("%s |", all.c_str());
          }
        std::printf("\n");
      }
  }
} // namespace

int
main()
{
  for (const double jitter : {0., 0.2})
    {
      print_errors({4, 4}, jitter);
      print_errors({4, 4, 4}, jitter);
    }
  print_bending();
  std::printf(
    "\nForces at rest left over in a fitted cell, relative: at most %.1e\n",
    worst_imbalance);
}
