#include <springfit/core/atomic_file.h>
#include <springfit/exports/sofa.h>
#include <springfit/exports/written_text.h>
#include <springfit/springs/volumes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <ostream>

namespace springfit
{
  namespace
  {
    bool
    is_of_volumes_of_tetrahedra(const SpringKind &kind)
    {
      return &kind == &springfit::volumes(CellKind::tetrahedron);
    }

    std::vector<const Family *>
    volumes(const ExportedScene &scene)
    {
      std::vector<const Family *> families;
      for (const auto &family : scene.families)
        if (family.size() > 0 && is_of_volumes_of_tetrahedra(*family.kind))
          families.push_back(&family);
      return families;
    }

    void
    write_plugins(const bool has_volumes, std::ostream &file)
    {
      std::vector<std::string> plugins = {"Constraint.Projective",
                                          "LinearSolver.Direct",
                                          "Mass",
                                          "MechanicalLoad",
                                          "ODESolver.Backward",
                                          "SolidMechanics.Spring",
                                          "StateContainer",
                                          "Visual"};
      if (has_volumes)
        for (const char *plugin :
             {"Mapping.NonLinear", "Topology.Container.Constant"})
          plugins.push_back(plugin);
      for (const auto &plugin : plugins)
        file << "  <RequiredPlugin pluginName=\"Sofa.Component." << plugin
             << "\"/>\n";
    }

    void
    write_list(const std::vector<unsigned int> &nodes, std::ostream &file)
    {
      for (std::size_t n = 0; n < nodes.size(); ++n)
        file << (n > 0 ? " " : "") << nodes[n];
    }

    void
    write_places(const Eigen::Matrix3Xd &places, std::ostream &file)
    {
      for (Eigen::Index node = 0; node < places.cols(); ++node)
        file << (node > 0 ? "  " : "")
             << exact(Eigen::Vector3d(places.col(node)));
    }

    void
    write_supports(const ExportedScene &scene,
                   const SofaVersion version,
                   std::ostream &file)
    {
      const std::string constraint = version == SofaVersion::v23_12
                                       ? "FixedConstraint"
                                       : "FixedProjectiveConstraint";
      const auto whole             = nodes_held_at_all(scene);
      if (!whole.empty())
        {
          file << "    <" << constraint << " indices=\"";
          write_list(whole, file);
          file << "\"/>\n";
        }
      std::map<std::array<bool, 3>, std::vector<unsigned int>> groups;
      for (const unsigned int node : nodes_held_in_part(scene))
        groups[scene.held[node]].push_back(node);
      for (const auto &[components, nodes] : groups)
        {
          file << "    <Partial" << constraint << " indices=\"";
          write_list(nodes, file);
          file << "\" fixedDirections=\"" << components[0] << ' '
               << components[1] << ' ' << components[2] << "\"/>\n";
        }
    }

    void
    write_springs(const ExportedScene &scene,
                  const SofaVersion version,
                  std::ostream &file)
    {
      const double damper = scene.motion ? scene.motion->spring_damper : 0.;
      file << "    <!-- i j stiffness damping rest_length -->\n    <"
           << (version == SofaVersion::v23_12 ? "StiffSpringForceField"
                                              : "SpringForceField")
           << " name=\"springs\" spring=\"";
      for (const auto &spring : hookean_springs(scene))
        file << spring.i << ' ' << spring.j << ' ' << exact(spring.k) << ' '
             << exact(damper) << ' ' << exact(spring.rest_length) << "  ";
      file << "\"/>\n";
    }

    void
    write_forces(const ExportedScene &scene, std::ostream &file)
    {
      const auto nodes = nodes_with_forces(scene);
      if (nodes.empty())
        return;
      file << "    <ConstantForceField indices=\"";
      write_list(nodes, file);
      file << "\" forces=\"";
      for (const unsigned int node : nodes)
        file << exact(Eigen::Vector3d(scene.forces.col(node))) << "  ";
      file << "\"/>\n";
    }

    template <typename F>
    void
    for_each_volume(const ExportedScene &scene, const F &f)
    {
      for (const Family *family : volumes(scene))
        for (std::size_t m = 0; m < family->size(); ++m)
          f(*family, m);
    }

    void
    write_volumes(const ExportedScene &scene, std::ostream &file)
    {
      file << "    <MeshTopology name=\"cells\" position=\"@nodes.position\" "
              "tetrahedra=\"";
      for_each_volume(scene, [&](const Family &family, const std::size_t m) {
        for (unsigned int a = 0; a < 4; ++a)
          file << family.nodes(m)[a] << ' ';
      });
      const auto write_column = [&](const unsigned int column) {
        for_each_volume(scene, [&](const Family &family, const std::size_t m) {
          file << exact(family.members.columns[column][m]) << ' ';
        });
      };
      file << "\"/>\n"
              "    <!-- Energy stiffness (V - rest_position)^2 / 2 of each "
              "cell. Not tried: whether a SOFA reads one stiffness for each. "
              "-->\n"
              "    <Node name=\"volumes\">\n"
              "      <MechanicalObject template=\"Vec1\" name=\"V\" "
              "rest_position=\"";
      write_column(1);
      file << "\"/>\n"
              "      <VolumeMapping topology=\"@../cells\" "
              "geometricStiffness=\"Exact\" applyRestPosition=\"false\"/>\n"
              "      <RestShapeSpringsForceField template=\"Vec1\" "
              "stiffness=\"";
      write_column(0);
      file << "\"/>\n    </Node>\n";
    }
  } // namespace

  std::vector<std::string>
  not_in_sofa(const ExportedScene &scene, const SofaVersion version)
  {
    return families_but(
      [&](const SpringKind &kind) {
        return is_of_hookean_springs(kind) ||
               (version == SofaVersion::v24_12 &&
                is_of_volumes_of_tetrahedra(kind));
      },
      scene);
  }

  void
  write_sofa(const std::filesystem::path &folder,
             const ExportedScene &scene,
             const SofaVersion version)
  {
    const bool has_volumes = !volumes(scene).empty();
    // Without a motion of its own it comes to rest by damping.
    const ExportedMotion motion =
      scene.motion.value_or(ExportedMotion{0.01, 0., 0.1, 0.1, 0.});
    write_file(folder / (scene.name + ".scn"), [&](std::ostream &file) {
      file << "<?xml version=\"1.0\"?>\n<!-- " << in_comment(scene.title)
           << "; m, kg, s, N. For SOFA "
           << word_of(sofa_version_words(), version)
           << " or later; not run: no SOFA was at hand. -->\n"
              "<Node name=\"root\" gravity=\"0 0 0\" dt=\""
           << exact(motion.step) << "\">\n";
      write_plugins(has_volumes, file);
      file << "  <DefaultAnimationLoop/>\n"
              "  <VisualStyle displayFlags=\"showBehaviorModels "
              "showForceFields\"/>\n"
              "  <Node name=\"network\">\n"
              "    <EulerImplicitSolver rayleighStiffness=\""
           << exact(motion.stiffness_damping) << "\" rayleighMass=\""
           << exact(motion.mass_damping)
           << "\"/>\n"
              "    <SparseLDLSolver "
              "template=\"CompressedRowSparseMatrixMat3x3d\"/>\n"
              "    <MechanicalObject name=\"nodes\" template=\"Vec3\" "
              "position=\"";
      write_places(scene.nodes + scene.support, file);
      if (!scene.support.isZero(0.))
        {
          file << "\" rest_position=\"";
          write_places(scene.nodes, file);
        }
      file << "\"/>\n    <DiagonalMass vertexMass=\"";
      for (std::size_t node = 0; node < scene.mass.size(); ++node)
        file << (node > 0 ? " " : "") << exact(scene.mass[node]);
      file << "\"/>\n";
      write_supports(scene, version, file);
      write_springs(scene, version, file);
      write_forces(scene, file);
      if (has_volumes)
        write_volumes(scene, file);
      file << "  </Node>\n</Node>\n";
    });
  }
} // namespace springfit
