#ifndef springfit_response_load_case_h
#define springfit_response_load_case_h

#include <springfit/core/words.h>

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** The canned load cases. */
  enum class Load
  {
    tension,
    compression,
    shear,
    torsion
  };

  const WordTable<Load> &
  load_words();


  /** What acts on the nodes of a mesh; both dim x n_nodes. */
  struct NodalLoad
  {
    Eigen::MatrixXd forces; // N

    /** The displacements of what is held, m; 0 elsewhere. */
    Eigen::MatrixXd support;
  };

  /** Without any displacement of the supports. */
  NodalLoad
  load_of_forces(const Eigen::MatrixXd &forces);


  struct LoadCase
  {
    std::string name; // in tables and files

    /** Empty: the user's own, in physical units. */
    std::optional<Load> canned;

    /** Of a canned one: the forces of a traction of 1 Pa, to be scaled. */
    NodalLoad load;

    /** The same at any time, s; of the user's own only. */
    std::function<NodalLoad(double time)> at;
  };


  /** A part of the supports. */
  struct Support
  {
    std::string name;       // in tables
    std::vector<bool> held; // a flag per unknown, see Loading
  };


  /** What holds a body, and what acts on it. */
  struct Loading
  {
    /** A flag per unknown, dim * v + d for component d of node v. */
    std::vector<bool> held;

    /** Those that the user names, which may share nodes. */
    std::vector<Support> supports;

    std::vector<LoadCase> cases;

    /** The names of those that a fit may be made with. */
    std::vector<std::string> training;

    /** The pull of the canned cases; empty without them. */
    struct Pull
    {
      Eigen::VectorXd axis; // unit vector
      double extent;        // of the body along the axis, m
      double deformation;   // wanted largest displacement / extent
    };
    std::optional<Pull> pull;
  };


  struct ForceOfSupport
  {
    std::string support;   // its name
    Eigen::VectorXd force; // on the body, N
  };

  /**
   * The force of each support, which those that share nodes all count, and the
   * one of "all" of them.
   *
   * @param reactions N, dim x n_nodes
   */
  std::vector<ForceOfSupport>
  forces_of_supports(const Loading &loading, const Eigen::MatrixXd &reactions);
} // namespace springfit

#endif
