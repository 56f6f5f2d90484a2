#include <springfit/motion/energy_account.h>

namespace springfit
{
  Eigen::MatrixXd
  damping_forces(const MovingBody &body, const MotionState &state)
  {
    Eigen::MatrixXd forces =
      body.damping.mass_factor * mass_product(body, state.velocity) +
      damper_product(body.dampers, state.displacement, state.velocity);
    if (body.damping.stiffness_factor != 0.)
      body.elastic->add_tangent_product(state.displacement,
                                        body.damping.stiffness_factor *
                                          state.velocity,
                                        forces);
    return forces;
  }

  Eigen::MatrixXd
  reactions_in_motion(const MovingBody &body,
                      const MotionState &state,
                      const Eigen::MatrixXd &acceleration)
  {
    const Eigen::MatrixXd all = mass_product(body, acceleration) +
                                damping_forces(body, state) -
                                driving_forces(body, state);
    Eigen::MatrixXd reactions = Eigen::MatrixXd::Zero(all.rows(), all.cols());
    copy_held(body, all, reactions);
    return reactions;
  }

  void
  add_step(const MotionState &before,
           const ForcesInMotion &forces_before,
           const MotionState &after,
           const ForcesInMotion &forces_after,
           EnergyAccount &account)
  {
    const Eigen::MatrixXd way = after.displacement - before.displacement;
    const auto work           = [&](const Eigen::MatrixXd &f_before,
                          const Eigen::MatrixXd &f_after) {
      return 0.5 * way.cwiseProduct(f_before + f_after).sum();
    };
    account.work_of_loads += work(forces_before.loads, forces_after.loads);
    account.work_of_contact +=
      work(forces_before.contact, forces_after.contact);
    account.work_of_supports +=
      work(forces_before.reactions, forces_after.reactions);
    account.dissipated += work(forces_before.damping, forces_after.damping);
  }
} // namespace springfit
