#include <springfit/core/error.h>
#include <springfit/reference/quadratic_nodes.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/fine_reference.h>
#include <springfit/studies/quadratic_response.h>

#include <deal.II/base/timer.h>

namespace springfit
{
  template <int dim, int spacedim>
  std::vector<Equilibrium>
  quadratic_responses(const Scene<spacedim> &scene,
                      const Loading &loading,
                      const std::vector<CaseResult> &results,
                      Session &session)
  {
    dealii::TimerOutput::Scope scope(session.timer(), "Quadratic elements");
    auto elements =
      scene_of<dim>(scene.geometry.template create<dim>(session.communicator(),
                                                        scene.folder),
                    scene);
    auto &mesh       = *elements.mesh;
    mesh.nodes       = quadratic_nodes(mesh);
    elements.element = make_element<dim, spacedim>(mesh.cell_kind, 2);
    const auto of_elements =
      scene.loads.resolve(mesh, elements.element, elements.materials);
    const Discretization<spacedim> discretization(mesh,
                                                  of_elements.held,
                                                  session.communicator());
    const auto model = scene.statics.finite_elements(discretization,
                                                     mesh,
                                                     elements.element,
                                                     elements.materials);
    const unsigned int n_vertices = mesh.triangulation.n_vertices();
    // What fails leaves the results of the other models.
    const auto respond = [&](const NodalLoad &load) {
      try
        {
          return model->respond(load);
        }
      catch (const RunError &error)
        {
          const Eigen::MatrixXd nothing = 0. * load.forces;
          return Equilibrium{nothing, 0., nothing, 0., error.what()};
        }
    };
    std::vector<Equilibrium> responses;
    for (std::size_t i = 0; i < results.size(); ++i)
      {
        const double unit = loading.cases[i].load.forces.norm();
        const double scale =
          unit > 0. ? results[i].load_case.load.forces.norm() / unit : 1.;
        auto found = respond(scaled(of_elements.cases[i].load, scale));
        if (!is_complete(found))
          session.warn("Load case " + results[i].load_case.name +
                       ", elements of degree 2: " + found.failure);
        found.displacement = found.displacement.leftCols(n_vertices).eval();
        found.reactions    = 0. * found.displacement;
        responses.push_back(found);
      }
    return responses;
  }

  template std::vector<Equilibrium>
  quadratic_responses<2>(const Scene<2> &,
                         const Loading &,
                         const std::vector<CaseResult> &,
                         Session &);
  template std::vector<Equilibrium>
  quadratic_responses<2, 3>(const Scene<3> &,
                            const Loading &,
                            const std::vector<CaseResult> &,
                            Session &);
  template std::vector<Equilibrium>
  quadratic_responses<3>(const Scene<3> &,
                         const Loading &,
                         const std::vector<CaseResult> &,
                         Session &);
} // namespace springfit
