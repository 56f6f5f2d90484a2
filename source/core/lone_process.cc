#include <springfit/core/lone_process.h>

#include <cstdlib>
#include <initializer_list>

namespace springfit
{
  void
  prepare_for_lone_process()
  {
    for (const char *launcher :
         {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
      if (std::getenv(launcher) != nullptr)
        return;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", false);
    setenv("OMPI_MCA_orte_create_session_dirs", "0", false);
  }
} // namespace springfit
