#ifndef springfit_motion_dynamics_h
#define springfit_motion_dynamics_h

#include <springfit/core/words.h>
#include <springfit/motion/integrators.h>
#include <springfit/motion/stable_step.h>

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace springfit
{
  enum class Integrator
  {
    implicit_euler,
    generalised_alpha,
    newmark,
    symplectic_euler
  };

  const WordTable<Integrator> &
  integrator_words();

  enum class MassKind
  {
    lumped,
    consistent
  };

  /** A place whose motion goes into the table. */
  template <int dim>
  struct NamedPoint
  {
    std::string name;
    dealii::Point<dim> place; // m
  };


  /** Cells that are taken out of a body, such as by a catheter. */
  struct Opening
  {
    std::string condition; // that all of their vertices meet at rest
    double time;           // s
  };


  /** How a scene moves. */
  template <int dim>
  struct DynamicsSettings
  {
    Integrator integrator;
    double begin, end, step; // s
    NewtonLimits newton;
    GeneralisedAlpha method; // of generalised alpha and Newmark
    RayleighDamping damping;
    double spring_damper; // N s/m
    bool has_finite_elements;
    MassKind mass; // of the finite elements
    double table_interval, frame_interval, checkpoint_interval; // s; 0: none
    unsigned int steps_between_checks; // of the stable step; 0: none
    double time_limit;                 // s of wall time; 0: none
    std::vector<NamedPoint<dim>> points;
    std::vector<std::string> boundaries; // whose mean motion is wanted
    std::string load_factor;             // of canned cases, of t
    std::vector<Opening> openings;       // in the order of their times
  };


  /** The section "Dynamics". */
  template <int dim>
  class Dynamics : public dealii::ParameterAcceptor
  {
  public:
    Dynamics();

    /** @throws EntryError when a value is wrong. */
    DynamicsSettings<dim>
    settings() const;

    /** The same of another method. */
    DynamicsSettings<dim>
    settings(Integrator integrator) const;

    /** Rayleigh's, whatever else the section says. @throws EntryError */
    RayleighDamping
    damping() const;

  private:
    std::string integrator_word_ = "implicit euler";
    double begin_ = 0., end_ = 1., step_ = 0.01;
    unsigned int n_iterations_   = 1;
    double tolerance_            = 1e-6;
    double spectral_radius_      = 0.8;
    std::vector<double> newmark_ = {0.25, 0.5};
    double mass_damping_         = 0.;
    double stiffness_damping_    = 0.;
    double spring_damper_        = 0.;
    bool has_finite_elements_    = true;
    std::string mass_word_       = "lumped";
    double table_interval_       = 0.;
    double frame_interval_       = 0.02;
    double checkpoint_interval_  = 0.;
    unsigned int checks_         = 0;
    double time_limit_           = 0.;
    std::string points_;
    std::string boundaries_;
    std::string load_factor_ = "1";
    std::string openings_;
  };
} // namespace springfit

#endif
