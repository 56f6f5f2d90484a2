#include <springfit/core/atomic_file.h>
#include <springfit/exports/mujoco.h>
#include <springfit/exports/written_text.h>

#include <algorithm>
#include <array>
#include <ostream>

namespace springfit
{
  namespace
  {
    constexpr std::array<char, 3> axes = {'x', 'y', 'z'};

    /** mjMINVAL: no mass and no inertia may be smaller. */
    constexpr double least_mass = 1e-15;

    void
    write_node(const ExportedScene &scene,
               const Eigen::Index node,
               std::ostream &file)
    {
      const auto &held = scene.held[node];
      const std::string place =
        exact(Eigen::Vector3d(scene.nodes.col(node) + scene.support.col(node)));
      if (held[0] && held[1] && held[2])
        {
          file << "    <site name=\"" << node << "\" pos=\"" << place
               << "\"/>\n";
          return;
        }
      // Bodies that slide do not turn: any inertia will do.
      file << "    <body name=\"" << node << "\" pos=\"" << place
           << "\"><inertial pos=\"0 0 0\" mass=\"" << exact(scene.mass[node])
           << "\" diaginertia=\"1 1 1\"/>";
      const double damping =
        scene.motion ? scene.motion->mass_damping * scene.mass[node] : 0.;
      for (int d = 0; d < 3; ++d)
        if (!held[d])
          {
            file << "<joint name=\"" << node << axes[d]
                 << "\" type=\"slide\" axis=\"" << (d == 0) << ' ' << (d == 1)
                 << ' ' << (d == 2) << '"';
            if (damping > 0.)
              file << " damping=\"" << exact(damping) << '"';
            file << "/>";
          }
      file << "<site name=\"" << node << "\"/></body>\n";
    }

    void
    write_springs(const ExportedScene &scene, std::ostream &file)
    {
      const double damper = scene.motion ? scene.motion->spring_damper : 0.;
      file << "  <tendon>\n";
      for (const auto &spring : hookean_springs(scene))
        {
          file << "    <spatial stiffness=\"" << exact(spring.k)
               << "\" springlength=\"" << exact(spring.rest_length) << '"';
          if (damper > 0.)
            file << " damping=\"" << exact(damper) << '"';
          file << "><site site=\"" << spring.i << "\"/><site site=\""
               << spring.j << "\"/></spatial>\n";
        }
      file << "  </tendon>\n";
    }

    void
    write_forces(const ExportedScene &scene, std::ostream &file)
    {
      file << "  <!-- Constant forces, N: they do not heed their control. "
              "-->\n  <actuator>\n";
      for (const unsigned int node : nodes_with_forces(scene))
        for (int d = 0; d < 3; ++d)
          if (scene.forces(d, node) != 0.)
            file << "    <general joint=\"" << node << axes[d]
                 << "\" gainprm=\"0\" biastype=\"affine\" biasprm=\""
                 << exact(scene.forces(d, node)) << " 0 0\"/>\n";
      file << "  </actuator>\n";
    }
  } // namespace

  std::vector<std::string>
  not_in_mujoco(const ExportedScene &scene)
  {
    auto missing = families_but(is_of_hookean_springs, scene);
    if (scene.motion && scene.motion->stiffness_damping > 0.)
      missing.push_back("damping by the stiffness");
    if (*std::min_element(scene.mass.begin(), scene.mass.end()) < least_mass)
      missing.push_back("masses below 1e-15 kg");
    // A Jacobian of tendons has a place for every product of them (2.2.2).
    const double n_entries =
      3. * hookean_springs(scene).size() * scene.mass.size();
    if (n_entries > 1.5e8)
      missing.push_back("springs times coordinates, more than 1.5e8,");
    return missing;
  }

  std::vector<std::string>
  left_out_of_mujoco(const ExportedScene &scene)
  {
    auto left_out = way_of_supports(scene);
    if (scene.motion && explicit_step(scene) < scene.motion->step)
      left_out.push_back(
        "time step, which is too large for symplectic Euler's method");
    return left_out;
  }

  void
  write_mujoco(const std::filesystem::path &folder, const ExportedScene &scene)
  {
    const double step = explicit_step(scene);
    write_file(folder / (scene.name + ".xml"), [&](std::ostream &file) {
      file << "<!-- " << in_comment(scene.title) << "; m, kg, s, N -->\n";
      if (!scene.motion)
        file << "<!-- Nothing damps it: it swings about its equilibrium. Give "
                "the tendons damping (N s/m) to let it come to rest. -->\n";
      if (scene.motion && scene.motion->mass_damping > 0.)
        file << "<!-- Damped by " << exact(scene.motion->mass_damping)
             << " / s times the mass at each joint. -->\n";
      file << "<mujoco model=\"" << scene.name
           << "\">\n"
              "  <compiler angle=\"radian\"/>\n"
              "  <option timestep=\""
           << exact(step)
           << "\" gravity=\"0 0 0\" integrator=\"Euler\"><flag "
              "contact=\"disable\" constraint=\"disable\"/></option>\n"
              "  <worldbody>\n";
      for (Eigen::Index node = 0; node < scene.nodes.cols(); ++node)
        write_node(scene, node, file);
      file << "  </worldbody>\n";
      write_springs(scene, file);
      if (!nodes_with_forces(scene).empty())
        write_forces(scene, file);
      file << "</mujoco>\n";
    });
  }
} // namespace springfit
