#ifndef springfit_response_load_case_h
#define springfit_response_load_case_h

#include <springfit/core/words.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  enum class Load
  {
    tension,
    compression,
    shear,
    torsion
  };

  const WordTable<Load> &
  load_words();


  /** Forces on the nodes of a mesh. */
  struct LoadCase
  {
    Load load;
    Eigen::MatrixXd forces; // N, dim x n_nodes
  };


  /** What holds a body, what pulls at it, and along which axis. */
  struct Loading
  {
    std::vector<bool> fixed;     // per node: all of its components
    Eigen::VectorXd axis;        // unit vector of the pull
    double extent;               // of the body along the axis, m
    double deformation;          // wanted largest displacement / extent
    std::vector<LoadCase> cases; // of a traction of 1 Pa

    /** Those of them that a fit may be made with. */
    std::vector<Load> training;
  };
} // namespace springfit

#endif
