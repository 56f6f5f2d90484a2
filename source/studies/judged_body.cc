#include <springfit/core/error.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/response/network_body.h>
#include <springfit/studies/judged_body.h>
#include <springfit/studies/openings.h>
#include <springfit/studies/responses.h>
#include <springfit/studies/varied_scene.h>

namespace springfit
{
  namespace
  {
    template <int spacedim>
    Eigen::MatrixXd
    nodes_of(const Nodes<spacedim> &nodes)
    {
      Eigen::MatrixXd places(spacedim, nodes.size());
      for (std::size_t v = 0; v < nodes.size(); ++v)
        for (int d = 0; d < spacedim; ++d)
          places(d, v) = nodes.places[v][d];
      return places;
    }

    /** Both finite elements; an error that is thrown is a failure. */
    template <int dim, int spacedim>
    void
    find_references(const Scene<spacedim> &scene,
                    StabilitySetting<dim, spacedim> &setting)
    {
      const auto &varied  = setting.varied;
      const auto model_of = [&](const MaterialLaw law) {
        return scene.statics.finite_elements_of(law,
                                                *setting.discretization,
                                                *varied.mesh,
                                                varied.element,
                                                varied.materials);
      };
      const auto law    = scene.statics.material_law();
      const auto linear = model_of(MaterialLaw::linear);
      for (auto &load_case : setting.loading.cases)
        {
          setting.reference.push_back(linear->respond(load_case.load));
          auto &found = setting.reference.back();
          const double scale =
            scale_of(load_case, setting.loading, found.displacement);
          load_case.load.forces *= scale;
          found.displacement *= scale;
        }
      setting.is_scaled = true;
      if (law == MaterialLaw::linear)
        return;
      const auto model = model_of(law);
      for (std::size_t i = 0; i < setting.reference.size(); ++i)
        {
          setting.reference[i] = model->respond(setting.loading.cases[i].load);
          if (!is_complete(setting.reference[i]))
            setting.failure_of_reference = setting.reference[i].failure;
        }
    }
  } // namespace

  template <int dim, int spacedim>
  std::unique_ptr<StabilitySetting<dim, spacedim>>
  make_stability_setting(const Scene<spacedim> &scene,
                         const Variation &body,
                         Session &session)
  {
    auto setting       = std::make_unique<StabilitySetting<dim, spacedim>>();
    setting->body      = body;
    setting->is_scaled = false;
    setting->varied    = varied_scene<dim>(scene, body, session.communicator());
    const auto &varied = setting->varied;
    setting->nodes     = nodes_of(varied.mesh->nodes);
    scene.fit.check_cells(varied.mesh->cell_kind);
    setting->loading =
      scene.loads.resolve(*varied.mesh, varied.element, varied.materials);
    scene.loads.check_supports(*varied.mesh, setting->loading);
    setting->discretization =
      std::make_unique<const Discretization<spacedim>>(*varied.mesh,
                                                       setting->loading.held,
                                                       session.communicator());
    try
      {
        find_references(scene, *setting);
      }
    catch (const RunError &error)
      {
        setting->failure_of_reference = error.what();
      }
    return setting;
  }

  template <int dim, int spacedim>
  std::unique_ptr<BodyOfMembers>
  members_of(const JudgedBody<dim, spacedim> &body)
  {
    if (body.network != nullptr)
      return std::make_unique<NetworkBody>(body.network->network);
    const auto &varied = body.setting.varied;
    return std::make_unique<FiniteElementBody<dim, spacedim>>(
      *varied.mesh,
      varied.element,
      varied.materials,
      body.scene.statics.material_law());
  }

  template <int dim, int spacedim>
  std::unique_ptr<Model>
  statics_of(const JudgedBody<dim, spacedim> &body,
             const Discretization<spacedim> &discretization)
  {
    const auto &varied = body.setting.varied;
    if (body.network == nullptr)
      return body.scene.statics.finite_elements(discretization,
                                                *varied.mesh,
                                                varied.element,
                                                varied.materials);
    return body.scene.statics.springs(discretization,
                                      *varied.mesh,
                                      varied.element,
                                      body.network->network,
                                      body.network->name,
                                      body.kinematics);
  }

  template <int dim, int spacedim>
  Excitation
  steady(const JudgedBody<dim, spacedim> &body, const NodalLoad &load)
  {
    return {body.setting.nodes,
            body.setting.loading.held,
            [load](double) { return load; },
            {},
            {}};
  }

  template <int dim, int spacedim>
  std::unique_ptr<MovingModel>
  moving(const JudgedBody<dim, spacedim> &body,
         const DynamicsSettings<spacedim> &settings,
         Excitation &excitation)
  {
    auto model =
      body.network != nullptr
        ? network_in_motion(*body.network,
                            body.network->network,
                            body.kinematics,
                            settings.spring_damper)
        : finite_elements_in_motion(body.scene.statics.material_law(),
                                    body.setting.varied,
                                    excitation.nodes,
                                    everything(*body.setting.varied.mesh));
    set_in_motion(settings, excitation, *model);
    return model;
  }

  void
  refuse(const std::string &why, StabilityRow &row)
  {
    row.verdict = "refused";
    row.reason  = why;
  }

  template std::unique_ptr<StabilitySetting<2, 2>>
  make_stability_setting<2, 2>(const Scene<2> &, const Variation &, Session &);
  template std::unique_ptr<BodyOfMembers>
  members_of(const JudgedBody<2, 2> &);
  template std::unique_ptr<Model>
  statics_of(const JudgedBody<2, 2> &, const Discretization<2> &);
  template Excitation
  steady(const JudgedBody<2, 2> &, const NodalLoad &);
  template std::unique_ptr<MovingModel>
  moving(const JudgedBody<2, 2> &, const DynamicsSettings<2> &, Excitation &);
  template std::unique_ptr<StabilitySetting<2, 3>>
  make_stability_setting<2, 3>(const Scene<3> &, const Variation &, Session &);
  template std::unique_ptr<BodyOfMembers>
  members_of(const JudgedBody<2, 3> &);
  template std::unique_ptr<Model>
  statics_of(const JudgedBody<2, 3> &, const Discretization<3> &);
  template Excitation
  steady(const JudgedBody<2, 3> &, const NodalLoad &);
  template std::unique_ptr<MovingModel>
  moving(const JudgedBody<2, 3> &, const DynamicsSettings<3> &, Excitation &);
  template std::unique_ptr<StabilitySetting<3, 3>>
  make_stability_setting<3, 3>(const Scene<3> &, const Variation &, Session &);
  template std::unique_ptr<BodyOfMembers>
  members_of(const JudgedBody<3, 3> &);
  template std::unique_ptr<Model>
  statics_of(const JudgedBody<3, 3> &, const Discretization<3> &);
  template Excitation
  steady(const JudgedBody<3, 3> &, const NodalLoad &);
  template std::unique_ptr<MovingModel>
  moving(const JudgedBody<3, 3> &, const DynamicsSettings<3> &, Excitation &);
} // namespace springfit
