#include <springfit/comparison/errors.h>
#include <springfit/core/error.h>
#include <springfit/core/progress.h>
#include <springfit/reference/material_law.h>
#include <springfit/response/discretization.h>
#include <springfit/studies/responses.h>

#include <cmath>
#include <memory>
#include <string>

namespace springfit
{
  namespace
  {
    /** All cases scaled, with the response of the linear finite elements. */
    template <int dim, int spacedim>
    std::vector<CaseResult>
    scale_cases(const Scene<spacedim> &scene,
                const Discretization<spacedim> &discretization,
                const CalibratedScene<dim, spacedim> &calibrated,
                const Loading &loading)
    {
      const auto model = scene.statics.finite_elements_of(MaterialLaw::linear,
                                                          discretization,
                                                          *calibrated.mesh,
                                                          calibrated.element,
                                                          calibrated.materials);
      std::vector<CaseResult> results;
      for (const auto &load_case : loading.cases)
        {
          CaseResult result{load_case, {}, model->respond(load_case.load), {}};
          const double scale =
            scale_of(load_case, loading, result.reference.displacement);
          result.load_case.load.forces *= scale;
          result.reference.displacement *= scale;
          result.reference.reactions *= scale;
          result.linear_displacement = result.reference.displacement;
          results.push_back(result);
        }
      return results;
    }

    void
    warn_of_failure(const CaseResult &result,
                    const Equilibrium &equilibrium,
                    Session &session)
    {
      if (!is_complete(equilibrium))
        session.warn("Load case " + result.load_case.name + ": " +
                     equilibrium.failure);
    }

    template <int dim, int spacedim>
    void
    solve_reference(const Scene<spacedim> &scene,
                    const Discretization<spacedim> &discretization,
                    const CalibratedScene<dim, spacedim> &calibrated,
                    Session &session,
                    std::vector<CaseResult> &results)
    {
      const auto model = scene.statics.finite_elements(discretization,
                                                       *calibrated.mesh,
                                                       calibrated.element,
                                                       calibrated.materials);
      Progress progress("Responses of the finite elements",
                        results.size(),
                        session.is_root());
      for (auto &result : results)
        {
          result.reference = model->respond(result.load_case.load);
          warn_of_failure(result, result.reference, session);
          progress.step();
        }
    }

    /** What is left of a response that threw, the same on all ranks. */
    Equilibrium
    nothing_found(const LoadCase &load_case, const RunError &error)
    {
      const Eigen::MatrixXd nothing =
        Eigen::MatrixXd::Zero(load_case.load.forces.rows(),
                              load_case.load.forces.cols());
      return {nothing, 0., nothing, 0., error.what()};
    }

    /** A failure of one network leaves the results of the others. */
    template <int dim, int spacedim>
    void
    solve_network(const Scene<spacedim> &scene,
                  const Discretization<spacedim> &discretization,
                  const CalibratedScene<dim, spacedim> &calibrated,
                  const std::size_t number,
                  const Kinematics kinematics,
                  Session &session,
                  std::vector<CaseResult> &results)
    {
      const auto &network = calibrated.networks[number];
      std::unique_ptr<Model> model;
      const auto respond = [&](const LoadCase &load_case) {
        try
          {
            if (!model)
              model = scene.statics.springs(discretization,
                                            *calibrated.mesh,
                                            calibrated.element,
                                            network.network,
                                            network.name,
                                            kinematics);
            return model->respond(load_case.load);
          }
        catch (const RunError &error)
          {
            return nothing_found(load_case, error);
          }
      };
      for (auto &result : results)
        if (is_complete(result.reference))
          {
            result.networks.push_back(
              {number, kinematics, respond(result.load_case)});
            warn_of_failure(result,
                            result.networks.back().equilibrium,
                            session);
          }
    }

    template <int dim, int spacedim>
    void
    solve_networks(const Scene<spacedim> &scene,
                   const Discretization<spacedim> &discretization,
                   const CalibratedScene<dim, spacedim> &calibrated,
                   Session &session,
                   std::vector<CaseResult> &results)
    {
      const auto all_kinematics = scene.statics.kinematics();
      Progress progress("Responses of the springs",
                        calibrated.networks.size() * all_kinematics.size(),
                        session.is_root());
      for (std::size_t n = 0; n < calibrated.networks.size(); ++n)
        {
          dealii::TimerOutput::Scope scope(session.timer(),
                                           "Springs, " +
                                             calibrated.networks[n].name);
          for (const Kinematics kinematics : all_kinematics)
            {
              solve_network(scene,
                            discretization,
                            calibrated,
                            n,
                            kinematics,
                            session,
                            results);
              progress.step();
            }
        }
    }
  } // namespace

  double
  scale_of(const LoadCase &load_case,
           const Loading &loading,
           const Eigen::MatrixXd &displacement)
  {
    const double largest = largest_displacement(displacement);
    if (!(largest > 0.))
      throw EntryError("Loads/Cases",
                       "the load '" + load_case.name + "' moves nothing.",
                       load_case.canned
                         ? "Load another boundary."
                         : "Load something that is not held; where loads "
                           "depend on t, set 'Time' in section Loads.");
    return load_case.canned
             ? loading.pull->deformation * loading.pull->extent / largest
             : 1.;
  }

  template <int dim, int spacedim>
  std::vector<CaseResult>
  find_references(const Scene<spacedim> &scene,
                  const CalibratedScene<dim, spacedim> &calibrated,
                  const Loading &loading,
                  Session &session)
  {
    const Discretization<spacedim> discretization(*calibrated.mesh,
                                                  loading.held,
                                                  session.communicator());
    if (loading.pull && loading.pull->deformation > 1.)
      session.warn(
        "The loads shall deform the object by " +
        std::to_string(std::lround(100. * loading.pull->deformation)) +
        " % of its extent: 'Deformation' in section Loads is a "
        "fraction, 0.1 means 10 %.");
    dealii::TimerOutput::Scope scope(session.timer(), "Finite elements");
    auto results = scale_cases(scene, discretization, calibrated, loading);
    if (scene.statics.material_law() != MaterialLaw::linear)
      solve_reference(scene, discretization, calibrated, session, results);
    return results;
  }

  template <int dim, int spacedim>
  void
  scale_canned_cases(const Scene<spacedim> &scene,
                     const CalibratedScene<dim, spacedim> &calibrated,
                     Session &session,
                     Loading &loading)
  {
    const Discretization<spacedim> discretization(*calibrated.mesh,
                                                  loading.held,
                                                  session.communicator());
    const auto model = scene.statics.finite_elements_of(MaterialLaw::linear,
                                                        discretization,
                                                        *calibrated.mesh,
                                                        calibrated.element,
                                                        calibrated.materials);
    for (auto &load_case : loading.cases)
      if (load_case.canned)
        load_case.load.forces *=
          scale_of(load_case,
                   loading,
                   model->respond(load_case.load).displacement);
  }

  template <int dim, int spacedim>
  void
  find_responses(const Scene<spacedim> &scene,
                 const CalibratedScene<dim, spacedim> &calibrated,
                 const Loading &loading,
                 std::vector<CaseResult> &results,
                 Session &session)
  {
    const Discretization<spacedim> discretization(*calibrated.mesh,
                                                  loading.held,
                                                  session.communicator());
    solve_networks(scene, discretization, calibrated, session, results);
  }

  template std::vector<CaseResult>
  find_references<2>(const Scene<2> &,
                     const CalibratedScene<2> &,
                     const Loading &,
                     Session &);
  template std::vector<CaseResult>
  find_references<2, 3>(const Scene<3> &,
                        const CalibratedScene<2, 3> &,
                        const Loading &,
                        Session &);
  template std::vector<CaseResult>
  find_references<3>(const Scene<3> &,
                     const CalibratedScene<3> &,
                     const Loading &,
                     Session &);
  template void
  scale_canned_cases<2>(const Scene<2> &,
                        const CalibratedScene<2> &,
                        Session &,
                        Loading &);
  template void
  scale_canned_cases<2, 3>(const Scene<3> &,
                           const CalibratedScene<2, 3> &,
                           Session &,
                           Loading &);
  template void
  scale_canned_cases<3>(const Scene<3> &,
                        const CalibratedScene<3> &,
                        Session &,
                        Loading &);
  template void
  find_responses<2>(const Scene<2> &,
                    const CalibratedScene<2> &,
                    const Loading &,
                    std::vector<CaseResult> &,
                    Session &);
  template void
  find_responses<2, 3>(const Scene<3> &,
                       const CalibratedScene<2, 3> &,
                       const Loading &,
                       std::vector<CaseResult> &,
                       Session &);
  template void
  find_responses<3>(const Scene<3> &,
                    const CalibratedScene<3> &,
                    const Loading &,
                    std::vector<CaseResult> &,
                    Session &);
} // namespace springfit
