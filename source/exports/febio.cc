#include <springfit/core/atomic_file.h>
#include <springfit/exports/febio.h>
#include <springfit/exports/written_text.h>

#include <array>
#include <cstddef>
#include <map>
#include <ostream>

namespace springfit
{
  namespace
  {
    constexpr std::array<char, 3> axes = {'x', 'y', 'z'};

    void
    write_control(std::ostream &file)
    {
      file
        << "  <Control>\n"
           "    <analysis>STATIC</analysis>\n"
           "    <time_steps>10</time_steps>\n"
           "    <step_size>0.1</step_size>\n"
           "    <solver type=\"solid\">\n"
           "      <symmetric_stiffness>1</symmetric_stiffness>\n"
           "      <dtol>1e-9</dtol>\n"
           "      <etol>1e-12</etol>\n"
           "      <qn_method type=\"BFGS\"><max_ups>0</max_ups></qn_method>\n"
           "    </solver>\n  </Control>\n";
    }

    /** The set of each stiffness, by its text. */
    using Sets = std::map<std::string, std::vector<ExportedSpring>>;

    void
    write_node_set(const std::string &name,
                   const std::vector<unsigned int> &nodes,
                   std::ostream &file)
    {
      if (nodes.empty())
        return;
      file << "    <NodeSet name=\"" << name << "\">";
      for (std::size_t n = 0; n < nodes.size(); ++n)
        file << (n > 0 ? "," : "") << nodes[n] + 1;
      file << "</NodeSet>\n";
    }

    std::vector<unsigned int>
    nodes_held(const ExportedScene &scene, const int component)
    {
      std::vector<unsigned int> nodes;
      for (unsigned int node = 0; node < scene.held.size(); ++node)
        if (scene.held[node][component])
          nodes.push_back(node);
      return nodes;
    }

    void
    write_mesh(const ExportedScene &scene, const Sets &sets, std::ostream &file)
    {
      file << "  <Mesh>\n    <Nodes name=\"nodes\">\n";
      for (Eigen::Index node = 0; node < scene.nodes.cols(); ++node)
        file << "      <node id=\"" << node + 1 << "\">"
             << exact(Eigen::Vector3d(scene.nodes.col(node)), ",")
             << "</node>\n";
      file << "    </Nodes>\n";
      for (int d = 0; d < 3; ++d)
        write_node_set(std::string("held_") + axes[d],
                       nodes_held(scene, d),
                       file);
      write_node_set("loaded", nodes_with_forces(scene), file);
      std::size_t set = 0;
      for (const auto &[k, springs] : sets)
        {
          file << "    <DiscreteSet name=\"s" << ++set << "\">\n";
          for (const auto &spring : springs)
            file << "      <delem>" << spring.i + 1 << ',' << spring.j + 1
                 << "</delem>\n";
          file << "    </DiscreteSet>\n";
        }
      file << "  </Mesh>\n  <MeshDomains/>\n";
    }

    /** A map of one component over a set of nodes. */
    void
    write_map(const std::string &name,
              const std::string &set,
              const std::vector<unsigned int> &nodes,
              const Eigen::Matrix3Xd &field,
              const int component,
              std::ostream &file)
    {
      if (nodes.empty())
        return;
      file << "    <NodeData name=\"" << name << "\" node_set=\"" << set
           << "\" data_type=\"scalar\">\n";
      for (std::size_t n = 0; n < nodes.size(); ++n)
        file << "      <node lid=\"" << n + 1 << "\">"
             << exact(field(component, nodes[n])) << "</node>\n";
      file << "    </NodeData>\n";
    }

    void
    write_loads(const ExportedScene &scene, std::ostream &file)
    {
      const auto loaded = nodes_with_forces(scene);
      file << "  <MeshData>\n";
      for (int d = 0; d < 3; ++d)
        {
          const std::string held = std::string("held_") + axes[d];
          write_map(std::string("force_") + axes[d],
                    "loaded",
                    loaded,
                    scene.forces,
                    d,
                    file);
          write_map(std::string("support_") + axes[d],
                    held,
                    nodes_held(scene, d),
                    scene.support,
                    d,
                    file);
        }
      file << "  </MeshData>\n  <Boundary>\n";
      for (int d = 0; d < 3; ++d)
        if (!nodes_held(scene, d).empty())
          file << "    <bc name=\"support_" << axes[d] << "\" node_set=\"held_"
               << axes[d] << "\" type=\"prescribed displacement\">\n      <dof>"
               << axes[d]
               << "</dof>\n      <value lc=\"1\" type=\"map\">support_"
               << axes[d]
               << "</value>\n      <relative>0</relative>\n    </bc>\n";
      file << "  </Boundary>\n  <Loads>\n";
      for (int d = 0; d < 3 && !loaded.empty(); ++d)
        file << "    <nodal_load name=\"force_" << axes[d]
             << "\" node_set=\"loaded\" type=\"nodal_load\">\n      <dof>"
             << axes[d] << "</dof>\n      <scale lc=\"1\" type=\"map\">force_"
             << axes[d]
             << "</scale>\n      <relative>0</relative>\n    </nodal_load>\n";
      file << "  </Loads>\n";
    }

    void
    write_springs(const Sets &sets, std::ostream &file)
    {
      file << "  <Discrete>\n";
      std::size_t set = 0;
      for (const auto &[k, springs] : sets)
        file << "    <discrete_material id=\"" << ++set
             << "\" type=\"linear spring\"><E>" << k
             << "</E></discrete_material>\n";
      for (std::size_t s = 1; s <= sets.size(); ++s)
        file << "    <discrete dmat=\"" << s << "\" discrete_set=\"s" << s
             << "\"/>\n";
      file << "  </Discrete>\n";
    }
  } // namespace

  std::vector<std::string>
  not_in_febio(const ExportedScene &scene)
  {
    auto missing = families_but(is_of_hookean_springs, scene);
    for (const auto &whats :
         {negative_springs(scene), springs_under_tension(scene)})
      missing.insert(missing.end(), whats.begin(), whats.end());
    if (scene.motion)
      missing.push_back("masses of nodes, which a motion needs");
    return missing;
  }

  void
  write_febio(const std::filesystem::path &folder, const ExportedScene &scene)
  {
    Sets sets;
    for (const auto &spring : hookean_springs(scene))
      if (spring.k > 0.) // none is 0 there
        sets[exact(spring.k)].push_back(spring);
    write_file(folder / (scene.name + ".feb"), [&](std::ostream &file) {
      file << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- "
           << in_comment(scene.title)
           << "; m, kg, s, N. Not run: no FEBio was at hand. The masses of "
              "the nodes have no place in the format. -->\n"
              "<febio_spec version=\"4.0\">\n  <Module type=\"solid\"/>\n";
      write_control(file);
      write_mesh(scene, sets, file);
      write_loads(scene, file);
      write_springs(sets, file);
      file << "  <LoadData>\n    <load_controller id=\"1\" "
              "type=\"loadcurve\">\n      <interpolate>LINEAR</interpolate>\n"
              "      <points><pt>0,0</pt><pt>1,1</pt></points>\n"
              "    </load_controller>\n  </LoadData>\n"
              "  <Output>\n    <plotfile type=\"febio\">\n"
              "      <var type=\"displacement\"/>\n    </plotfile>\n"
              "    <logfile>\n      <node_data data=\"ux;uy;uz\" file=\""
           << scene.name
           << ".displacement.txt\"/>\n"
              "    </logfile>\n  </Output>\n</febio_spec>\n";
    });
  }
} // namespace springfit
