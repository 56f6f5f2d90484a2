#include <springfit/comparison/errors.h>
#include <springfit/output/mesh_vtu.h>
#include <springfit/output/network_vtu.h>
#include <springfit/output/response_table.h>
#include <springfit/studies/comparison_files.h>

#include <cstddef>
#include <map>
#include <utility>

namespace springfit
{
  namespace
  {
    /** What did not reach the whole load is not to be taken for a result. */
    std::string
    completeness(const Equilibrium &equilibrium)
    {
      return is_complete(equilibrium) ? "" : "_incomplete";
    }
  } // namespace

  std::string
  suffix_of(const Kinematics kinematics)
  {
    return kinematics == Kinematics::nonlinear ? "_nonlinear" : "";
  }

  template <int dim, int spacedim>
  void
  write_pictures(const std::filesystem::path &folder,
                 const CalibratedScene<dim, spacedim> &calibrated,
                 const std::vector<CaseResult> &results)
  {
    // The series by their names, the springs' fields by network.
    std::map<std::string, std::vector<std::pair<double, std::string>>> series;
    std::vector<std::vector<NodalField>> spring_fields(
      calibrated.networks.size());
    const auto write = [&](const std::string &name,
                           const std::size_t number,
                           const std::string &load_case,
                           const Equilibrium &equilibrium,
                           const NodalField &field) {
      if (equilibrium.load_fraction == 0.)
        return; // nothing was found
      const std::string file =
        load_case + '_' + name + completeness(equilibrium) + ".vtu";
      write_mesh_vtu(folder / file,
                     *calibrated.mesh,
                     {{"displacement", equilibrium.displacement}, field});
      if (is_complete(equilibrium))
        series[name].emplace_back(number, file);
    };

    for (std::size_t r = 0; r < results.size(); ++r)
      {
        const auto &result     = results[r];
        const auto &reference  = result.reference;
        const std::string name = result.load_case.name;
        write(
          "fem", r, name, reference, {"force", result.load_case.load.forces});
        for (const auto &response : result.networks)
          {
            const auto &equilibrium = response.equilibrium;
            const auto &network     = calibrated.networks[response.network];
            const std::string kind  = suffix_of(response.kinematics);
            write(network.name + kind,
                  r,
                  name,
                  equilibrium,
                  {"error",
                   nodal_errors(reference.displacement,
                                equilibrium.displacement)
                     .transpose()});
            if (is_complete(equilibrium))
              spring_fields[response.network].push_back(
                {"displacement_" + name + kind, equilibrium.displacement});
          }
      }
    for (const auto &[name, files] : series)
      write_pvd(folder / (name + ".pvd"), files);
    for (std::size_t n = 0; n < calibrated.networks.size(); ++n)
      write_network_vtu(folder,
                        calibrated.networks[n].name,
                        calibrated.networks[n].network,
                        spring_fields[n]);
  }

  template <int dim, int spacedim>
  void
  write_responses(const std::filesystem::path &folder,
                  const CalibratedScene<dim, spacedim> &calibrated,
                  const Loading &loading,
                  const std::vector<CaseResult> &results)
  {
    for (const auto &result : results)
      {
        const auto write = [&](const std::string &name,
                               const Equilibrium &equilibrium) {
          if (is_complete(equilibrium))
            write_response(folder /
                             (result.load_case.name + '_' + name + ".csv"),
                           loading.held,
                           result.load_case.load.forces,
                           equilibrium.displacement,
                           equilibrium.reactions);
        };
        write("fem", result.reference);
        for (const auto &response : result.networks)
          write(calibrated.networks[response.network].name +
                  suffix_of(response.kinematics),
                response.equilibrium);
      }
  }

  template void
  write_pictures(const std::filesystem::path &,
                 const CalibratedScene<2> &,
                 const std::vector<CaseResult> &);
  template void
  write_responses(const std::filesystem::path &,
                  const CalibratedScene<2> &,
                  const Loading &,
                  const std::vector<CaseResult> &);
  template void
  write_pictures(const std::filesystem::path &,
                 const CalibratedScene<2, 3> &,
                 const std::vector<CaseResult> &);
  template void
  write_pictures(const std::filesystem::path &,
                 const CalibratedScene<3> &,
                 const std::vector<CaseResult> &);
  template void
  write_responses(const std::filesystem::path &,
                  const CalibratedScene<2, 3> &,
                  const Loading &,
                  const std::vector<CaseResult> &);
  template void
  write_responses(const std::filesystem::path &,
                  const CalibratedScene<3> &,
                  const Loading &,
                  const std::vector<CaseResult> &);
} // namespace springfit
