#include <springfit/exports/calculix.h>
#include <springfit/exports/exporters.h>
#include <springfit/exports/febio.h>
#include <springfit/exports/gipsi.h>
#include <springfit/exports/lammps.h>
#include <springfit/exports/mujoco.h>
#include <springfit/exports/numpy.h>
#include <springfit/exports/sofa.h>

#include <stdexcept>
#include <string>

namespace springfit
{
  namespace
  {
    const std::string springs_alone =
      "'Methods = frobenius' with 'Enrichment = none'";

    std::vector<std::string>
    nothing(const ExportedScene &)
    {
      return {};
    }
  } // namespace

  Exporter
  exporter_of(const ExportFormat format, const SofaVersion sofa_version)
  {
    switch (format)
      {
        case ExportFormat::sofa:
          return {
            format,
            sofa_version == SofaVersion::v24_12
              ? "springs, also under tension, and quadratic volumes of "
                "tetrahedra"
              : "springs, also under tension",
            sofa_version == SofaVersion::v24_12
              ? "on tetrahedra 'Methods = stable neo-hookean' with "
                "'Enrichment = volume' and 'Volume law = quadratic', else " +
                  springs_alone
              : springs_alone,
            false,
            [sofa_version](const ExportedScene &scene) {
              return not_in_sofa(scene, sofa_version);
            },
            way_of_supports,
            [sofa_version](const std::filesystem::path &folder,
                           const ExportedScene &scene) {
              write_sofa(folder, scene, sofa_version);
            }};
        case ExportFormat::lammps:
          return {format,
                  "springs and angles",
                  "'Methods = frobenius' with 'Enrichment = angles', export "
                  "to 'lammps library'",
                  false,
                  not_in_lammps,
                  left_out_of_lammps,
                  write_lammps};
        case ExportFormat::lammps_library:
          return {format,
                  "everything",
                  "any of them",
                  false,
                  nothing,
                  left_out_of_lammps,
                  write_lammps_library};
        case ExportFormat::calculix:
          return {format,
                  "springs of the law quadratic",
                  springs_alone,
                  true,
                  not_in_calculix,
                  left_out_of_calculix,
                  write_calculix};
        case ExportFormat::febio:
          return {format,
                  "springs of the law quadratic and positive stiffness, in "
                  "equilibrium",
                  springs_alone + " and 'Nonnegative = true'",
                  false,
                  not_in_febio,
                  nothing,
                  write_febio};
        case ExportFormat::gipsi:
          return {format,
                  "springs of the law quadratic and nodes held whole",
                  springs_alone,
                  false,
                  not_in_gipsi,
                  left_out_of_gipsi,
                  write_gipsi};
        case ExportFormat::mujoco:
          return {format,
                  "springs of the law quadratic",
                  springs_alone,
                  false,
                  not_in_mujoco,
                  left_out_of_mujoco,
                  write_mujoco};
        case ExportFormat::numpy:
          return {format,
                  "everything",
                  "any of them",
                  false,
                  nothing,
                  nothing,
                  write_numpy};
      }
    throw std::logic_error("a format without an exporter");
  }
} // namespace springfit
