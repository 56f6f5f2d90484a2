#include <springfit/core/atomic_file.h>
#include <springfit/core/words.h>
#include <springfit/exports/lammps.h>
#include <springfit/exports/written_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <utility>

namespace springfit
{
  namespace
  {
    bool
    is_of_biquadratic_springs(const SpringKind &kind)
    {
      return kind.word() == "springs" && kind.law() == "biquadratic";
    }

    bool
    is_of_angles(const SpringKind &kind)
    {
      return kind.word() == "angles";
    }

    bool
    is_in_lammps(const SpringKind &kind)
    {
      return is_of_hookean_springs(kind) || is_of_biquadratic_springs(kind) ||
             is_of_angles(kind);
    }

    /** Members that share their coefficients have a type, counted from 1. */
    struct Bonded
    {
      std::vector<std::string> coefficients; // of each type
      std::vector<unsigned int> types;       // of each member
      std::vector<unsigned int> nodes;       // of all members, from 0

      void
      add(const std::string &of_member)
      {
        const auto [found, is_new] =
          numbers_.emplace(of_member, coefficients.size() + 1);
        if (is_new)
          coefficients.push_back(of_member);
        types.push_back(found->second);
      }

    private:
      std::map<std::string, unsigned int> numbers_;
    };

    bool
    has_biquadratic_springs(const ExportedScene &scene)
    {
      return std::any_of(scene.families.begin(),
                         scene.families.end(),
                         [](const Family &family) {
                           return is_of_biquadratic_springs(*family.kind);
                         });
    }

    /**
     * E = K (l - L)^2, and in class2 besides K3 (l - L)^3 + K4 (l - L)^4: with
     * d = l - L the biquadratic k q^2 / 2 of q = d + d^2 / (2 L).
     */
    Bonded
    bonds(const ExportedScene &scene)
    {
      const bool is_class2 = has_biquadratic_springs(scene);
      Bonded bonds;
      for (const auto &family : scene.families)
        {
          const bool is_biquadratic = is_of_biquadratic_springs(*family.kind);
          if (!is_biquadratic && !is_of_hookean_springs(*family.kind))
            continue;
          for (std::size_t m = 0; m < family.size(); ++m)
            {
              const double k = family.members.columns[0][m];
              const double L = family.members.columns[1][m];
              std::string coefficients;
              if (!is_class2)
                coefficients = exact(0.5 * k) + ' ' + exact(L);
              else if (!is_biquadratic)
                coefficients = exact(L) + ' ' + exact(0.5 * k) + " 0 0";
              else
                coefficients = exact(L) + ' ' + exact(0.5 * k) + ' ' +
                               exact(0.5 * k / L) + ' ' +
                               exact(0.125 * k / (L * L));
              bonds.add(coefficients);
              bonds.nodes.insert(bonds.nodes.end(),
                                 family.nodes(m),
                                 family.nodes(m) + 2);
            }
        }
      return bonds;
    }

    /** E = K (theta - theta_0)^2 with theta_0 in degrees. */
    Bonded
    angles(const ExportedScene &scene)
    {
      Bonded angles;
      for (const auto &family : scene.families)
        if (is_of_angles(*family.kind))
          for (std::size_t m = 0; m < family.size(); ++m)
            {
              angles.add(exact(0.5 * family.members.columns[0][m]) + ' ' +
                         exact(family.members.columns[1][m] * 180. / M_PI));
              angles.nodes.insert(angles.nodes.end(),
                                  family.nodes(m),
                                  family.nodes(m) + 3);
            }
      return angles;
    }

    void
    write_coefficients(const std::string &title,
                       const Bonded &bonded,
                       std::ostream &file)
    {
      if (bonded.types.empty())
        return;
      file << '\n' << title << " Coeffs\n\n";
      for (std::size_t t = 0; t < bonded.coefficients.size(); ++t)
        file << t + 1 << ' ' << bonded.coefficients[t] << '\n';
    }

    void
    write_members(const std::string &title,
                  const unsigned int n_nodes,
                  const Bonded &bonded,
                  std::ostream &file)
    {
      if (bonded.types.empty())
        return;
      file << '\n' << title << "\n\n";
      for (std::size_t m = 0; m < bonded.types.size(); ++m)
        {
          file << m + 1 << ' ' << bonded.types[m];
          for (unsigned int a = 0; a < n_nodes; ++a)
            file << ' ' << bonded.nodes[n_nodes * m + a] + 1;
          file << '\n';
        }
    }

    void
    write_data(const ExportedScene &scene,
               const Bonded &bonds,
               const Bonded &angles,
               std::ostream &file)
    {
      const Eigen::Matrix3Xd places = scene.nodes + scene.support;
      const Eigen::Vector3d low     = places.rowwise().minCoeff();
      const Eigen::Vector3d high    = places.rowwise().maxCoeff();
      const double margin           = 0.5 * (high - low).maxCoeff();
      file << "# " << scene.title << "; m, kg, N\n\n"
           << places.cols() << " atoms\n1 atom types\n"
           << bonds.types.size() << " bonds\n"
           << bonds.coefficients.size() << " bond types\n"
           << angles.types.size() << " angles\n"
           << angles.coefficients.size() << " angle types\n";
      const std::array<std::string, 3> axes = {"x", "y", "z"};
      for (int d = 0; d < 3; ++d)
        file << exact(low[d] - margin) << ' ' << exact(high[d] + margin) << ' '
             << axes[d] << "lo " << axes[d] << "hi\n";
      // Those of the nodes are given below, and take precedence.
      file << "\nMasses\n\n1 1\n";
      write_coefficients("Bond", bonds, file);
      write_coefficients("Angle", angles, file);
      file << "\nAtoms # angle\n\n";
      for (Eigen::Index node = 0; node < places.cols(); ++node)
        file << node + 1 << " 1 1 " << exact(Eigen::Vector3d(places.col(node)))
             << '\n';
      write_members("Bonds", 2, bonds, file);
      write_members("Angles", 3, angles, file);
      file << "\nNodes\n\n";
      for (Eigen::Index node = 0; node < places.cols(); ++node)
        file << node + 1 << ' ' << exact(scene.mass[node]) << ' '
             << exact(Eigen::Vector3d(scene.forces.col(node))) << '\n';
    }

    /** A fix for each combination of components that is held somewhere. */
    void
    write_supports(const ExportedScene &scene, std::ostream &file)
    {
      const std::array<char, 3> axes = {'x', 'y', 'z'};
      std::map<std::array<bool, 3>, std::vector<unsigned int>> groups;
      for (unsigned int node = 0; node < scene.held.size(); ++node)
        if (scene.held[node] != std::array<bool, 3>{false, false, false})
          groups[scene.held[node]].push_back(node + 1);
      for (const auto &[components, nodes] : groups)
        {
          std::string name = "held_", zeros;
          for (int d = 0; d < 3; ++d)
            {
              if (components[d])
                name += axes[d];
              zeros += components[d] ? " 0" : " NULL";
            }
          // By runs of nodes: each is looked for among all of them.
          std::size_t first = 0;
          while (first < nodes.size())
            {
              std::size_t last = first;
              while (last + 1 < nodes.size() &&
                     nodes[last + 1] == nodes[last] + 1)
                ++last;
              file << "group " << name << " id " << nodes[first] << ':'
                   << nodes[last] << '\n';
              first = last + 1;
            }
          file << "fix " << name << ' ' << name << " setforce" << zeros
               << "\nvelocity " << name << " set" << zeros << '\n';
        }
    }

    double
    longest_bond(const ExportedScene &scene, const Bonded &bonds)
    {
      double longest = 0.;
      for (std::size_t m = 0; m < bonds.types.size(); ++m)
        longest = std::max(longest,
                           (scene.nodes.col(bonds.nodes[2 * m + 1]) -
                            scene.nodes.col(bonds.nodes[2 * m]))
                             .norm());
      return longest;
    }

    /** What is small of a force, N, is so beside this one. */
    double
    scale_of_forces(const ExportedScene &scene, const double longest)
    {
      double k = 0.;
      for (const auto &family : scene.families)
        if (family.kind->n_nodes() == 2)
          for (const double of_member : family.members.columns[0])
            k = std::max(k, std::abs(of_member));
      return std::max(
        {scene.forces.norm(), k * scene.support.norm(), 1e-6 * k * longest});
    }

    void
    write_equilibrium(const double force,
                      const double longest,
                      std::ostream &file)
    {
      file << "min_style cg\n"
              "min_modify dmax "
           << exact(0.1 * longest)
           << " line forcezero\n"
              "thermo 1000\n"
              "# Stops when the norm of all forces, N, is below the second "
              "number.\n"
              "minimize 0 "
           << "$(" << exact(1e-11 * force)
           << "*abs(v_load)) 1000000 10000000\n";
    }

    void
    write_motion(const ExportedScene &scene, std::ostream &file)
    {
      const double step     = explicit_step(scene);
      const unsigned long n = n_steps(*scene.motion, step);
      file << "# Velocity Verlet\nfix motion all nve\ntimestep " << exact(step)
           << "\nthermo " << std::max(1ul, n / 20) << "\nrun " << n << '\n';
    }

    void
    write_script(const ExportedScene &scene,
                 const Bonded &bonds,
                 const Bonded &angles,
                 std::ostream &file)
    {
      const double longest = longest_bond(scene, bonds);
      const auto others    = families_but(is_in_lammps, scene);
      file << "# " << scene.title << "\n# Network: " << scene.network << "\n# "
           << (others.empty() ? "lmp -in " : "examples/run_in_lammps.py ")
           << scene.name
           << ".lmp\n# Units: m, kg, s, N. -var load 0.5 applies half of the "
              "forces.\n";
      for (const auto &what : left_out_of_lammps(scene))
        file << "# Without the " << what << " of the scene.\n";
      file << "variable load index 1\n"
              "units si\n"
              "dimension 3\n"
              "boundary s s s\n"
              "atom_style angle\n"
              "atom_modify map array\n"
              "special_bonds lj/coul 1 1 1\n"
              "pair_style none\n"
              "bond_style "
           << (has_biquadratic_springs(scene) ? "class2" : "harmonic") << '\n';
      if (!angles.types.empty())
        file << "angle_style harmonic\n";
      file << "comm_modify cutoff " << exact(3. * longest) << "\nneighbor "
           << exact(0.3 * longest) << " bin\n"
           << "fix nodes all property/atom rmass d_fx d_fy d_fz ghost yes\n"
              "read_data "
           << scene.name
           << ".data fix nodes NULL Nodes\n"
              "compute forces all property/atom d_fx d_fy d_fz\n"
              "variable fx atom v_load*c_forces[1]\n"
              "variable fy atom v_load*c_forces[2]\n"
              "variable fz atom v_load*c_forces[3]\n"
              "variable work atom -(v_fx*x+v_fy*y+v_fz*z)\n"
              "fix load all addforce v_fx v_fy v_fz energy v_work\n"
              "fix_modify load energy yes\n";
      if (!others.empty())
        file << "# The " << join(others)
             << ": forces of the program that runs this.\n"
                "fix others all external pf/callback 1 1\n"
                "fix_modify others energy yes\n";
      write_supports(scene, file);
      if (scene.motion)
        write_motion(scene, file);
      else
        write_equilibrium(scale_of_forces(scene, longest), longest, file);
      file << "write_dump all custom " << scene.name
           << ".dump id x y z modify sort id format float %.17g\n";
    }
  } // namespace

  std::vector<std::string>
  not_in_lammps(const ExportedScene &scene)
  {
    return families_but(is_in_lammps, scene);
  }

  std::vector<std::string>
  left_out_of_lammps(const ExportedScene &scene)
  {
    auto left_out = damping(scene);
    for (const auto &what : way_of_supports(scene))
      left_out.push_back(what);
    if (scene.motion && explicit_step(scene) < scene.motion->step)
      left_out.push_back("time step, which is too large for Verlet's method");
    return left_out;
  }

  void
  write_lammps(const std::filesystem::path &folder, const ExportedScene &scene)
  {
    const Bonded bonds  = springfit::bonds(scene);
    const Bonded angles = springfit::angles(scene);
    write_file(folder / (scene.name + ".data"), [&](std::ostream &file) {
      write_data(scene, bonds, angles, file);
    });
    write_file(folder / (scene.name + ".lmp"), [&](std::ostream &file) {
      write_script(scene, bonds, angles, file);
    });
  }

  void
  write_lammps_library(const std::filesystem::path &folder,
                       const ExportedScene &scene)
  {
    ExportedScene of_library = scene;
    of_library.name += "_library";
    write_lammps(folder, of_library);
  }
} // namespace springfit
