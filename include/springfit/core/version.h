#ifndef springfit_core_version_h
#define springfit_core_version_h

#include <string>

namespace springfit
{
  /** "springfit 0.1.0 (git 1a2b3c4)" */
  std::string
  version();

  /** The versions of the libraries this program was compiled with. */
  std::string
  library_versions();
} // namespace springfit

#endif
