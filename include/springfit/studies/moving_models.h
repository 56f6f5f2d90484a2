#ifndef springfit_studies_moving_models_h
#define springfit_studies_moving_models_h

#include <springfit/response/expression.h>
#include <springfit/response/load_case.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/moving_model.h>
#include <springfit/studies/openings.h>
#include <springfit/studies/scene.h>

#include <memory>
#include <vector>

namespace springfit
{
  /**
   * What a load case does over time: its own loads, or a canned one's times the
   * load factor, and all obstacles.
   *
   * @throws EntryError when something is wrong at the beginning.
   */
  template <int dim, int spacedim>
  Excitation
  make_excitation(const Scene<spacedim> &scene,
                  const CalibratedScene<dim, spacedim> &calibrated,
                  const Loading &loading,
                  const LoadCase &load_case,
                  const DynamicsSettings<spacedim> &settings);

  /**
   * What the settings make of canned cases over time.
   *
   * @throws EntryError when the expression cannot be understood.
   */
  template <int dim>
  Expression<dim>
  load_factor(const DynamicsSettings<dim> &settings);

  /**
   * The finite elements of a law with lumped masses, without a system of
   * equations; @p calibrated must outlive them.
   *
   * @param nodes spacedim x n_nodes, m
   */
  template <int dim, int spacedim>
  std::unique_ptr<MovingModel>
  finite_elements_in_motion(MaterialLaw law,
                            const CalibratedScene<dim, spacedim> &calibrated,
                            const Eigen::MatrixXd &nodes,
                            const Remains &remains);

  /** A network, of which @p springs are what is left, as well. */
  std::unique_ptr<MovingModel>
  network_in_motion(const CalibratedNetwork &network,
                    const SpringNetwork &springs,
                    Kinematics kinematics,
                    double spring_damper);

  /** Any body with the nodes and the masses of a network. */
  std::unique_ptr<MovingModel>
  body_in_motion(std::unique_ptr<const ElasticBody> body,
                 Kinematics kinematics,
                 const SpringNetwork &network);

  /**
   * Let a model begin at rest under what @p excitation does, which must outlive
   * it, with the system of equations that suits it. Obstacles without a
   * stiffness are given one.
   */
  template <int spacedim>
  void
  set_in_motion(const DynamicsSettings<spacedim> &settings,
                Excitation &excitation,
                MovingModel &model);

  /**
   * All models that move: the finite elements first, where they are wanted,
   * then each network with each kinematics. Obstacles without a stiffness are
   * given one, of the first model. @p excitation must outlive them.
   *
   * @param remains what is left of the mesh
   */
  template <int dim, int spacedim>
  std::vector<std::unique_ptr<MovingModel>>
  make_moving_models(const Scene<spacedim> &scene,
                     const CalibratedScene<dim, spacedim> &calibrated,
                     const DynamicsSettings<spacedim> &settings,
                     Excitation &excitation,
                     const Remains &remains);
} // namespace springfit

#endif
