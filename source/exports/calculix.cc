#include <springfit/core/atomic_file.h>
#include <springfit/core/formatted.h>
#include <springfit/exports/calculix.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>

namespace springfit
{
  namespace
  {
    /** Fields are 20 characters wide, and need a decimal point. */
    std::string
    field(const double number)
    {
      return formatted("%.12E", number);
    }

    void
    write_nodes(const ExportedScene &scene, std::ostream &file)
    {
      file << "*NODE, NSET=ALL\n";
      for (Eigen::Index node = 0; node < scene.nodes.cols(); ++node)
        file << node + 1 << ", " << field(scene.nodes(0, node)) << ", "
             << field(scene.nodes(1, node)) << ", "
             << field(scene.nodes(2, node)) << '\n';
    }

    /**
     * What *SPRING says of a spring: k alone where it is at rest, else the
     * force of two elongations, between which it is linear.
     */
    std::string
    law(const ExportedScene &scene, const ExportedSpring &spring)
    {
      const double l       = distance_at_rest(scene, spring);
      const double tension = spring.k * (l - spring.rest_length);
      if (std::abs(l - spring.rest_length) <= 1e-9 * l)
        return "\n\n" + field(spring.k) + '\n';
      return ", NONLINEAR\n" + field(tension - spring.k * l) + ", " +
             field(-l) + '\n' + field(tension + 10. * spring.k * l) + ", " +
             field(10. * l) + '\n';
    }

    /** A set for all springs of one law. */
    void
    write_springs(const ExportedScene &scene, std::ostream &file)
    {
      std::map<std::string, std::vector<ExportedSpring>> sets;
      for (const auto &spring : hookean_springs(scene))
        sets[law(scene, spring)].push_back(spring);
      std::size_t element = 0, set = 0;
      for (const auto &[law, springs] : sets)
        {
          file << "*ELEMENT, TYPE=SPRINGA, ELSET=S" << ++set << '\n';
          for (const auto &spring : springs)
            file << ++element << ", " << spring.i + 1 << ", " << spring.j + 1
                 << '\n';
          file << "*SPRING, ELSET=S" << set << law;
        }
      if (!scene.motion)
        return;
      std::map<std::string, std::vector<Eigen::Index>> masses;
      for (Eigen::Index node = 0; node < scene.nodes.cols(); ++node)
        masses[field(scene.mass[node])].push_back(node + 1);
      set = 0;
      for (const auto &[mass, nodes] : masses)
        {
          file << "*ELEMENT, TYPE=MASS, ELSET=M" << ++set << '\n';
          for (const Eigen::Index node : nodes)
            file << ++element << ", " << node << '\n';
          file << "*MASS, ELSET=M" << set << '\n' << mass << '\n';
        }
    }

    void
    write_supports(const ExportedScene &scene, std::ostream &file)
    {
      bool is_first = true;
      for (Eigen::Index node = 0; node < scene.nodes.cols(); ++node)
        for (int d = 0; d < 3; ++d)
          if (scene.held[node][d])
            {
              if (is_first)
                file << "*BOUNDARY\n";
              is_first = false;
              file << node + 1 << ", " << d + 1 << ", " << d + 1 << ", "
                   << field(scene.support(d, node)) << '\n';
            }
    }

    void
    write_forces(const ExportedScene &scene, std::ostream &file)
    {
      const auto nodes = nodes_with_forces(scene);
      if (!nodes.empty())
        file << "*CLOAD\n";
      for (const unsigned int node : nodes)
        for (int d = 0; d < 3; ++d)
          if (scene.forces(d, node) != 0.)
            file << node + 1 << ", " << d + 1 << ", "
                 << field(scene.forces(d, node)) << '\n';
    }
  } // namespace

  std::vector<std::string>
  not_in_calculix(const ExportedScene &scene)
  {
    auto missing = families_but(is_of_hookean_springs, scene);
    if (scene.has_true_forces)
      return missing;
    // Without NLGEOM their stress stiffness is left out.
    for (const auto &what : springs_under_tension(scene))
      missing.push_back(what + " and small displacements");
    // It takes the forces of springs there by their true lengths.
    if (!scene.support.isZero(0.))
      missing.push_back("moved supports and small displacements");
    // And in a motion.
    if (scene.motion)
      missing.push_back("motions and small displacements");
    return missing;
  }

  std::vector<std::string>
  left_out_of_calculix(const ExportedScene &scene)
  {
    return damping(scene);
  }

  void
  write_calculix(const std::filesystem::path &folder,
                 const ExportedScene &scene)
  {
    write_file(folder / (scene.name + ".inp"), [&](std::ostream &file) {
      file << "** " << scene.title << "\n** ccx " << scene.name
           << "\n** Units: m, kg, s, N. Displacements are printed to "
           << scene.name << ".dat.\n";
      for (const auto &what : left_out_of_calculix(scene))
        file << "** Without the " << what << " of the scene.\n";
      write_nodes(scene, file);
      write_springs(scene, file);
      file << (scene.has_true_forces ? "*STEP, NLGEOM, INC=1000000000\n"
                                     : "*STEP, INC=1000000000\n");
      if (scene.motion)
        // Without the damping that ccx has of its own.
        file << "*DYNAMIC, DIRECT, ALPHA=0.\n"
             << field(scene.motion->step) << ", "
             << field(scene.motion->duration) << '\n';
      else if (scene.has_true_forces)
        file << "*STATIC\n0.1, 1.\n";
      else
        file << "*STATIC\n";
      write_supports(scene, file);
      write_forces(scene, file);
      file << "*NODE FILE\nU\n*NODE PRINT, NSET=ALL, FREQUENCY=1000000000\nU\n"
              "*END STEP\n";
    });
  }
} // namespace springfit
