#ifndef springfit_exports_exported_scene_h
#define springfit_exports_exported_scene_h

#include <springfit/response/load_case.h>
#include <springfit/springs/network.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** How a scene moves, where it does. */
  struct ExportedMotion
  {
    double step, duration;                  // s
    double mass_damping, stiffness_damping; // Rayleigh's, 1/s and s
    double spring_damper;                   // of each spring, N s/m
  };


  /**
   * A network under one load, as programs in space want it: in the plane all
   * z are 0 and held.
   */
  struct ExportedScene
  {
    std::string name;    // of its files, without an ending
    std::string title;   // what it is, one line
    std::string network; // what springfit's tables call the network

    Eigen::Matrix3Xd nodes;   // at rest, m
    Eigen::Matrix3Xd forces;  // N
    Eigen::Matrix3Xd support; // displacements of what is held, m

    /** Which components of each node. */
    std::vector<std::array<bool, 3>> held;

    std::vector<double> mass; // per node, kg
    Families families;

    /** Whether forces are those of the deformed springs, or of small ones. */
    bool has_true_forces = true;

    /** With which symplectic Euler's method is stable, s. */
    double stable_step = 0.01;

    /** Empty: an equilibrium is wanted. */
    std::optional<ExportedMotion> motion;
  };

  /** The number of its steps, at least one. */
  unsigned long
  n_steps(const ExportedMotion &motion, double step);

  /** That of the motion, or less, as explicit methods bear it, s. */
  double
  explicit_step(const ExportedScene &scene);

  /**
   * @param name see ExportedScene
   * @param held a flag per unknown, see Loading
   */
  ExportedScene
  exported(const SpringNetwork &network,
           const std::string &name,
           const std::vector<bool> &held,
           const NodalLoad &load);

  /** 0, 1, ... of those all of whose components are held. */
  std::vector<unsigned int>
  nodes_held_at_all(const ExportedScene &scene);

  /** Of which some components are held, but not all. */
  std::vector<unsigned int>
  nodes_held_in_part(const ExportedScene &scene);

  std::vector<unsigned int>
  nodes_with_forces(const ExportedScene &scene);


  /** Energy k (l - rest_length)^2 / 2. */
  struct ExportedSpring
  {
    unsigned int i, j;
    double k, rest_length; // N/m, m
  };

  /** All of Hooke's springs, of every family of them. */
  std::vector<ExportedSpring>
  hookean_springs(const ExportedScene &scene);

  bool
  is_of_hookean_springs(const SpringKind &kind);

  /** m */
  double
  distance_at_rest(const ExportedScene &scene, const ExportedSpring &spring);

  // What a program may not be able to hold, as parts of a sentence.

  /** "couplings", "springs of the law biquadratic", ...: of other kinds. */
  std::vector<std::string>
  families_but(const std::function<bool(const SpringKind &)> &is_held,
               const ExportedScene &scene);

  /** "springs of negative stiffness", if there are any. */
  std::vector<std::string>
  negative_springs(const ExportedScene &scene);

  /** "springs under tension at rest", if rest lengths are not distances. */
  std::vector<std::string>
  springs_under_tension(const ExportedScene &scene);

  /** "nodes held in some of their components", if there are any. */
  std::vector<std::string>
  partly_held_nodes(const ExportedScene &scene);

  // And what it may leave out of a scene that it holds.

  /** "damping of motions", ...: of whatever kind, if there is any. */
  std::vector<std::string>
  damping(const ExportedScene &scene);

  /**
   * Where supports are moved at once, and by more than half of the shortest
   * spring: "the way of supports, ...".
   */
  std::vector<std::string>
  way_of_supports(const ExportedScene &scene);
} // namespace springfit

#endif
