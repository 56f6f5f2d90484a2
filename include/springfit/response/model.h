#ifndef springfit_response_model_h
#define springfit_response_model_h

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
     * The equilibrium under @p forces (N, dim x n_nodes). Collective.
     *
     * @throws RunError when a model that cannot follow a load has none.
     */
    virtual Equilibrium
    respond(const Eigen::MatrixXd &forces) const = 0;
  };
} // namespace springfit

#endif
