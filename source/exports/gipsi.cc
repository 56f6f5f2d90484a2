#include <springfit/core/atomic_file.h>
#include <springfit/exports/gipsi.h>
#include <springfit/exports/written_text.h>

#include <ostream>

namespace springfit
{
  std::vector<std::string>
  not_in_gipsi(const ExportedScene &scene)
  {
    auto missing = families_but(is_of_hookean_springs, scene);
    for (const auto &what : partly_held_nodes(scene))
      missing.push_back(what);
    return missing;
  }

  std::vector<std::string>
  left_out_of_gipsi(const ExportedScene &scene)
  {
    auto left_out = way_of_supports(scene);
    if (!nodes_with_forces(scene).empty())
      left_out.push_back("forces of the load");
    for (const auto &what : damping(scene))
      if (what != "dampers of springs")
        left_out.push_back(what);
    if (scene.motion)
      left_out.push_back("time step");
    return left_out;
  }

  void
  write_gipsi(const std::filesystem::path &folder, const ExportedScene &scene)
  {
    const auto springs = hookean_springs(scene);
    const auto held    = nodes_held_at_all(scene);
    const double B     = scene.motion ? scene.motion->spring_damper : 0.;
    write_file(folder / (scene.name + ".msd"), [&](std::ostream &file) {
      file << "MSD " << scene.mass.size() << " 0 " << springs.size() << " 0 "
           << held.size()
           << "\n"
              // Comments are for before and within the masses alone.
              "# "
           << scene.title
           << "\n# m mass x y z | s i j K B L | b i (held); m, kg, s, N\n";
      for (const auto &what : left_out_of_gipsi(scene))
        file << "# Without the " << what << ", for which there is no place.\n";
      for (Eigen::Index node = 0; node < scene.nodes.cols(); ++node)
        file << "m " << exact(scene.mass[node]) << ' '
             << exact(Eigen::Vector3d(scene.nodes.col(node) +
                                      scene.support.col(node)))
             << '\n';
      for (const auto &spring : springs)
        file << "s " << spring.i + 1 << ' ' << spring.j + 1 << ' '
             << exact(spring.k) << ' ' << exact(B) << ' '
             << exact(spring.rest_length) << '\n';
      for (const unsigned int node : held)
        file << "b " << node + 1 << '\n';
    });
  }
} // namespace springfit
