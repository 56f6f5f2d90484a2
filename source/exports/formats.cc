#include <springfit/exports/formats.h>

namespace springfit
{
  const WordTable<ExportFormat> &
  export_format_words()
  {
    static const WordTable<ExportFormat> table = {
      {ExportFormat::sofa, "sofa"},
      {ExportFormat::lammps, "lammps"},
      {ExportFormat::lammps_library, "lammps library"},
      {ExportFormat::calculix, "calculix"},
      {ExportFormat::febio, "febio"},
      {ExportFormat::gipsi, "gipsi"},
      {ExportFormat::mujoco, "mujoco"},
      {ExportFormat::numpy, "numpy"}};
    return table;
  }

  const WordTable<SofaVersion> &
  sofa_version_words()
  {
    static const WordTable<SofaVersion> table = {{SofaVersion::v23_12, "23.12"},
                                                 {SofaVersion::v24_06, "24.06"},
                                                 {SofaVersion::v24_12,
                                                  "24.12"}};
    return table;
  }
} // namespace springfit
