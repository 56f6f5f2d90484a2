// A bar of soft tissue made of 12 cubes as springs and volumes: fitted to
// finite elements, pulled along z until it rests, let go.
#include <springfit/fit/cell/finite_element_stiffness.h>
#include <springfit/fit/fit.h>
#include <springfit/springs/network.h>

#include <algorithm>
#include <iostream>
#include <numeric>

using namespace springfit;

int
main()
{
  const IsotropicMaterial material = {1e4, 0.45, 1.};      // E in Pa, nu
  const double h = 0.005, density = 1000., traction = 2e3; // m, kg/m^3, Pa
  Eigen::MatrixXd nodes(3, 52); // four at each end of a cube, x runs fastest
  for (int i = 0; i < nodes.cols(); ++i)
    nodes.col(i) = h * Eigen::Vector3d(i % 2, i / 2 % 2, i / 4);

  // All cells are equal: one fit does for them. R may come from elsewhere.
  const auto kind            = CellKind::hexahedron;
  const Eigen::MatrixXd cube = nodes.leftCols(8);
  const Eigen::MatrixXd R    = finite_element_stiffness(cube, kind, material);
  FitOptions options;
  options.enrichment = Enrichment::volume;
  const auto fitted  = fit(make_fit_problem(cube, kind, R, material),
                          method_named("stable neo-hookean"),
                          options);
  NetworkBuilder builder(nodes);
  std::vector<unsigned int> cell(8);
  for (int first = 0; first + 8 <= nodes.cols(); first += 4)
    {
      std::iota(cell.begin(), cell.end(), first);
      for (const Family &family : fitted.families)
        builder.add(family, cell);
      builder.add_masses(cell,
                         Eigen::VectorXd::Constant(8, density / 8 * h * h * h));
    }
  const SpringNetwork network = builder.build();

  // Symplectic Euler. Nodes at x = 0, y = 0 or z = 0 slide there.
  const auto mass = Eigen::RowVectorXd::Map(network.mass.data(), nodes.cols());
  const Eigen::ArrayXXd is_free = (nodes.array() > 0.).cast<double>();
  const double dt               = 5e-5; // s
  Eigen::MatrixXd x = nodes, v = 0. * nodes, pull = v;
  pull.rightCols(4).row(2).setConstant(traction * h * h / 4); // N
  const auto step = [&](const Eigen::MatrixXd &load, const double damping) {
    Eigen::MatrixXd force = load - damping * v * mass.asDiagonal(); // 1/s
    add_forces(network.families, x, force);
    v.array() += dt * is_free * (force.array().rowwise() / mass.array());
    x += dt * v;
  };
  for (int i = 0; i < 40000; ++i)
    step(pull, 30.);
  std::cout << "stretch " << x(2, 51) / nodes(2, 51) << "\nacross "
            << x(0, 51) / nodes(0, 51);

  const auto energy_now = [&]() { // J
    return energy(network.families, x) - energy(network.families, nodes) +
           v.colwise().squaredNorm().dot(mass) / 2.;
  };
  const double stored = energy_now();
  double least = stored, most = stored;
  for (int i = 0; i < 40000; ++i)
    {
      step(0. * pull, 0.);
      least = std::min(least, energy_now());
      most  = std::max(most, energy_now());
    }
  std::cout << "\nenergy from " << least / stored << " to " << most / stored
            << " of what was stored" << std::endl;
}
