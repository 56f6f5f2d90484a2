#ifndef springfit_tests_benchmarks_pulled_cube_h
#define springfit_tests_benchmarks_pulled_cube_h

// The case of the step benchmarks: a cube of soft tissue's stiffness, clamped
// at z = 0 and pulled at the opposite face by a traction that comes and goes.

#include <springfit/core/cell_kind.h>
#include <springfit/fit/cell/stable_neo_hookean.h>
#include <springfit/fit/problem.h>
#include <springfit/response/network_body.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/network.h>
#include <springfit/springs/rest_families.h>

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <vector>

namespace springfit::pulled_cube
{
  constexpr double edge    = 0.02;  // m
  constexpr double modulus = 1e4;   // E, Pa
  constexpr double density = 1000.; // kg/m^3
  constexpr double pull    = 1000.; // the largest traction, Pa
  constexpr double period  = 0.5;   // of the traction, s
  constexpr double step    = 0.01;  // s

  /** Of cells whose edge is h, as springs and volumes. */
  using CellModel = std::function<Families(const Eigen::MatrixXd &points)>;

  /** 28 springs of the stiffness 0.12, 0.16, 0.06 E h by their lengths. */
  inline Families
  plain_springs(const Eigen::MatrixXd &points)
  {
    const double h   = (points.col(1) - points.col(0)).norm();
    const auto pairs = node_pairs(CellKind::hexahedron);
    Eigen::VectorXd k(pairs.size());
    for (std::size_t s = 0; s < pairs.size(); ++s)
      {
        const double l =
          (points.col(pairs[s][1]) - points.col(pairs[s][0])).norm();
        k[s] = (l < 1.2 * h ? 0.12 : l < 1.6 * h ? 0.16 : 0.06) * modulus * h;
      }
    return {lengths_at_rest(points, pairs, k, SpringLaw::quadratic)};
  }

  /** Of nu = 0.3, with the volumes of cells. */
  inline Families
  stable_neo_hookean(const Eigen::MatrixXd &points)
  {
    const auto problem =
      make_fit_problem(points,
                       CellKind::hexahedron,
                       Eigen::MatrixXd::Zero(points.size(), points.size()),
                       {modulus, 0.3, 1.});
    return fit_stable_neo_hookean_volume(problem, VolumeLaw::quadratic)
      .families;
  }


  /** Nodes, masses and supports of n^3 cells. */
  struct Cube
  {
    SpringNetwork network;
    std::vector<bool> held;     // by unknown
    Eigen::VectorXd face_share; // of the loaded face's area, by node, m^2
  };

  inline Cube
  make(const unsigned int n, const CellModel &model)
  {
    const unsigned int m = n + 1;
    const double h       = edge / n;
    Eigen::MatrixXd nodes(3, m * m * m);
    for (unsigned int v = 0; v < nodes.cols(); ++v)
      nodes.col(v) << h * (v % m), h * (v / m % m), h * (v / m / m);

    Cube cube;
    cube.face_share = Eigen::VectorXd::Zero(nodes.cols());
    NetworkBuilder builder(nodes);
    const Eigen::VectorXd masses =
      Eigen::VectorXd::Constant(8, density * h * h * h / 8.);
    Families of_cell; // all cells are alike
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            std::vector<unsigned int> cell;
            for (unsigned int c = 0; c < 8; ++c)
              cell.push_back(i + (c & 1) + m * (j + (c >> 1 & 1)) +
                             m * m * (k + (c >> 2 & 1)));
            if (of_cell.empty())
              of_cell = model(nodes(Eigen::all, cell));
            for (const Family &family : of_cell)
              builder.add(family, cell);
            builder.add_masses(cell, masses);
            if (k + 1 == n)
              for (unsigned int c = 4; c < 8; ++c)
                cube.face_share[cell[c]] += h * h / 4.;
          }
    cube.network = builder.build();
    cube.held.assign(nodes.size(), false);
    std::fill_n(cube.held.begin(), 3 * m * m, true);
    return cube;
  }

  /** Pa */
  inline double
  traction(const double time)
  {
    constexpr double pi = 3.14159265358979323846;
    return 0.5 * pull * (1. - std::cos(2. * pi * time / period));
  }

  /**
   * Of every spring where a program has one stiffness for all, N/m: the loaded
   * face goes nearly as far as with plain_springs().
   */
  inline double
  stiffness_of_peers(const unsigned int n)
  {
    return 0.277 * modulus * edge / n;
  }

  /** The mean displacement of the loaded face along the pull, m. */
  inline double
  face_displacement(const Cube &cube, const Eigen::MatrixXd &displacement)
  {
    return displacement.row(2).dot(cube.face_share) / cube.face_share.sum();
  }
} // namespace springfit::pulled_cube

#endif
