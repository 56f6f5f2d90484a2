#ifndef springfit_studies_adaptation_h
#define springfit_studies_adaptation_h

#include <springfit/response/discretization.h>
#include <springfit/response/load_case.h>
#include <springfit/response/model.h>
#include <springfit/studies/adapt_section.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/mixed_body.h>
#include <springfit/studies/quantity.h>
#include <springfit/studies/scene.h>

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <vector>

namespace springfit
{
  /** All that a load case tells of a mixed body. */
  struct JudgedCase
  {
    Equilibrium found;
    Eigen::MatrixXd contributions; // n_cells x n_models, per cent, signed
    double estimate;               // per cent, signed
  };


  /**
   * Equilibria of mixed bodies of one scene, and how far they are from that of
   * the exact body: weighted by the adjoint of what the error is of (R. Becker,
   * R. Rannacher, Acta Numerica 10 (2001) 1-102).
   */
  template <int dim, int spacedim>
  class Adaptation
  {
  public:
    /**
     * All but the settings must outlive the object.
     *
     * @throws EntryError when the quantity is none of the mesh.
     */
    Adaptation(const Scene<spacedim> &scene,
               const CalibratedScene<dim, spacedim> &calibrated,
               const Loading &loading,
               const AdaptSettings &settings,
               MPI_Comm communicator);

    const MixedBody<dim, spacedim> &
    mixed() const;

    Kinematics
    kinematics() const;

    /** That a cell may have: without finite elements unless they are wanted. */
    unsigned int
    n_models() const;

    /**
     * Under each of the load cases.
     *
     * @throws RunError when there is no equilibrium, or nothing moves.
     */
    std::vector<Equilibrium>
    respond(std::unique_ptr<const BodyOfMembers> body) const;

    /**
     * That of the quantity in all load cases, m or N: symmetry may forbid it
     * in some. 1 without a quantity.
     *
     * @throws EntryError when it is 0.
     */
    double
    largest_quantity(const std::vector<Equilibrium> &found) const;

    /** The error between two equilibria of a load case, per cent. */
    double
    error(const Equilibrium &exact,
          const Equilibrium &found,
          double largest) const;

    /**
     * The estimate by one step of Newton's method for the exact body.
     *
     * @param models by cell
     * @param largest see largest_quantity()
     *
     * @throws RunError when the exact body has no energy at the state found, or
     * the estimate is not finite.
     */
    JudgedCase
    judge(const Equilibrium &found,
          const std::vector<unsigned int> &models,
          double largest) const;

  private:
    /** What the error is of: a linear function of the displacements' error. */
    struct Goal
    {
      Eigen::MatrixXd weights;   // of displacements
      Eigen::MatrixXd of_forces; // of missing forces where it is held
    };

    /** In per cent, of the state that is a @p change away. */
    Goal
    goal(const Equilibrium &found,
         const Eigen::MatrixXd &change,
         double largest_of_quantity) const;

    const Scene<spacedim> &scene_;
    const CalibratedScene<dim, spacedim> &calibrated_;
    const Loading &loading_;
    const AdaptSettings settings_;
    const MaterialLaw law_;
    const Kinematics kinematics_;
    const Discretization<spacedim> discretization_;
    const MixedBody<dim, spacedim> mixed_;
    const std::unique_ptr<const BodyOfMembers> exact_;
    std::optional<Quantity> quantity_;
  };
} // namespace springfit

#endif
