// Whatever links libspringfit compiles this with its own flags: what the
// library allocates its user may free, and for wide registers Eigen does both
// in another way.
#include <Eigen/Core>

static_assert(EIGEN_DEFAULT_ALIGN_BYTES == 16,
              "libspringfit is for registers that every processor has: compile "
              "what links it without -march=native, -mavx and the like.");
