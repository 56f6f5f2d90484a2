#ifndef springfit_exports_formats_h
#define springfit_exports_formats_h

#include <springfit/core/words.h>

namespace springfit
{
  /** A program into which networks go, by its files. */
  enum class ExportFormat
  {
    sofa,
    lammps,
    lammps_library,
    calculix,
    febio,
    gipsi,
    mujoco,
    numpy
  };

  const WordTable<ExportFormat> &
  export_format_words();


  /** The first SOFA that a scene is for: components got new names. */
  enum class SofaVersion
  {
    v23_12,
    v24_06,
    v24_12
  };

  const WordTable<SofaVersion> &
  sofa_version_words();
} // namespace springfit

#endif
