#ifndef springfit_response_model_h
#define springfit_response_model_h

#include <springfit/response/load_case.h>

#include <Eigen/Core>

#include <string>

namespace springfit
{
  /**
   * Where a model comes to rest, and what it costs to find out: the wall time
   * of all that this load takes (assembly, factors or hierarchy, solution), as
   * if it were the only one.
   */
  struct Equilibrium
  {
    Eigen::MatrixXd displacement; // m, dim x n_nodes
    double seconds;

    /**
     * The forces of the supports on the body, N, dim x n_nodes; 0 where it is
     * free.
     */
    Eigen::MatrixXd reactions;

    /**
     * The part of the load that it holds: 1, or less where no equilibrium was
     * found beyond it; then @p failure says why, in a full sentence.
     */
    double load_fraction = 1.;
    std::string failure;
  };


  /** How an error speaks of a model, and what it advises. */
  struct ModelWords
  {
    std::string name;
    std::string advice;
  };


  /** A held body that answers forces on its nodes. */
  class Model
  {
  public:
    virtual ~Model() = default;

    /**
     * The equilibrium under a load. Collective.
     *
     * @throws RunError when a model that cannot follow a load has none.
     */
    virtual Equilibrium
    respond(const NodalLoad &load) const = 0;
  };
} // namespace springfit

#endif
