#ifndef springfit_core_example_scene_h
#define springfit_core_example_scene_h

#include <string>

namespace springfit
{
  /**
   * A parameter file that the user may try: of an installed program where it
   * was installed, otherwise as seen from the top of the source tree.
   */
  std::string
  example_scene();
} // namespace springfit

#endif
