#include <springfit/exports/exported_scene.h>

#include <algorithm>
#include <cmath>

namespace springfit
{
  namespace
  {
    Eigen::Matrix3Xd
    in_space(const Eigen::MatrixXd &field)
    {
      Eigen::Matrix3Xd result      = Eigen::Matrix3Xd::Zero(3, field.cols());
      result.topRows(field.rows()) = field;
      return result;
    }

    template <typename Condition>
    std::vector<unsigned int>
    nodes_where(const ExportedScene &scene, const Condition &condition)
    {
      std::vector<unsigned int> nodes;
      for (unsigned int node = 0; node < scene.held.size(); ++node)
        if (condition(node))
          nodes.push_back(node);
      return nodes;
    }

    long
    n_held(const ExportedScene &scene, const unsigned int node)
    {
      const auto &held = scene.held[node];
      return std::count(held.begin(), held.end(), true);
    }
  } // namespace

  ExportedScene
  exported(const SpringNetwork &network,
           const std::string &name,
           const std::vector<bool> &held,
           const NodalLoad &load)
  {
    const Eigen::Index dim = network.nodes.rows();
    ExportedScene scene;
    scene.name     = name;
    scene.nodes    = in_space(network.nodes);
    scene.forces   = in_space(load.forces);
    scene.support  = in_space(load.support);
    scene.mass     = network.mass;
    scene.families = network.families;
    scene.held.assign(network.nodes.cols(), {false, false, dim == 2});
    for (Eigen::Index node = 0; node < network.nodes.cols(); ++node)
      for (Eigen::Index d = 0; d < dim; ++d)
        if (held[dim * node + d])
          {
            scene.held[node][d] = true;
            // Nobody pushes a support.
            scene.forces(d, node) = 0.;
          }
    return scene;
  }

  unsigned long
  n_steps(const ExportedMotion &motion, const double step)
  {
    return std::max(1L, std::lround(motion.duration / step));
  }

  double
  explicit_step(const ExportedScene &scene)
  {
    // Deformed, it is less than at rest.
    const double stable = 0.5 * scene.stable_step;
    return scene.motion ? std::min(scene.motion->step, stable) : stable;
  }

  std::vector<unsigned int>
  nodes_held_at_all(const ExportedScene &scene)
  {
    return nodes_where(scene, [&](const unsigned int node) {
      return n_held(scene, node) == 3;
    });
  }

  std::vector<unsigned int>
  nodes_held_in_part(const ExportedScene &scene)
  {
    return nodes_where(scene, [&](const unsigned int node) {
      return n_held(scene, node) > 0 && n_held(scene, node) < 3;
    });
  }

  std::vector<unsigned int>
  nodes_with_forces(const ExportedScene &scene)
  {
    return nodes_where(scene, [&](const unsigned int node) {
      return !scene.forces.col(node).isZero(0.);
    });
  }

  bool
  is_of_hookean_springs(const SpringKind &kind)
  {
    return kind.word() == "springs" && kind.law() == "quadratic";
  }

  std::vector<ExportedSpring>
  hookean_springs(const ExportedScene &scene)
  {
    std::vector<ExportedSpring> springs;
    for (const auto &family : scene.families)
      if (is_of_hookean_springs(*family.kind))
        for (std::size_t m = 0; m < family.size(); ++m)
          springs.push_back({family.nodes(m)[0],
                             family.nodes(m)[1],
                             family.members.columns[0][m],
                             family.members.columns[1][m]});
    return springs;
  }

  double
  distance_at_rest(const ExportedScene &scene, const ExportedSpring &spring)
  {
    return (scene.nodes.col(spring.j) - scene.nodes.col(spring.i)).norm();
  }

  std::vector<std::string>
  families_but(const std::function<bool(const SpringKind &)> &is_held,
               const ExportedScene &scene)
  {
    std::vector<std::string> others;
    for (const auto &family : scene.families)
      if (family.size() > 0 && !is_held(*family.kind))
        {
          std::string word = family.kind->word();
          std::replace(word.begin(), word.end(), '_', ' ');
          others.push_back(family.kind->law() == "biquadratic"
                             ? word + " of the law " + family.kind->law()
                             : word);
        }
    return others;
  }

  namespace
  {
    template <typename Condition>
    std::vector<std::string>
    said_if_any(const ExportedScene &scene,
                const std::string &what,
                const Condition &condition)
    {
      for (const auto &spring : hookean_springs(scene))
        if (condition(spring))
          return {what};
      return {};
    }
  } // namespace

  std::vector<std::string>
  negative_springs(const ExportedScene &scene)
  {
    return said_if_any(scene,
                       "springs of negative stiffness",
                       [](const ExportedSpring &spring) {
                         return spring.k < 0.;
                       });
  }

  std::vector<std::string>
  springs_under_tension(const ExportedScene &scene)
  {
    return said_if_any(scene,
                       "springs under tension at rest",
                       [&](const ExportedSpring &spring) {
                         const double l = distance_at_rest(scene, spring);
                         return std::abs(l - spring.rest_length) > 1e-9 * l;
                       });
  }

  std::vector<std::string>
  damping(const ExportedScene &scene)
  {
    if (!scene.motion)
      return {};
    std::vector<std::string> kinds;
    if (scene.motion->mass_damping > 0.)
      kinds.push_back("damping by the masses");
    if (scene.motion->stiffness_damping > 0.)
      kinds.push_back("damping by the stiffness");
    if (scene.motion->spring_damper > 0.)
      kinds.push_back("dampers of springs");
    return kinds;
  }

  std::vector<std::string>
  way_of_supports(const ExportedScene &scene)
  {
    const double way = scene.support.colwise().norm().maxCoeff();
    return said_if_any(scene,
                       "way of supports, which begin where they end: springs "
                       "beside them may turn inside out",
                       [&](const ExportedSpring &spring) {
                         return way > 0.5 * distance_at_rest(scene, spring);
                       });
  }

  std::vector<std::string>
  partly_held_nodes(const ExportedScene &scene)
  {
    if (nodes_held_in_part(scene).empty())
      return {};
    return {"nodes held in some of their components"};
  }
} // namespace springfit
