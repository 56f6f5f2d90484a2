#include <springfit/springs/negative.h>

namespace springfit
{
  unsigned int
  n_negative(const Eigen::Ref<const Eigen::VectorXd> &k)
  {
    if (k.size() == 0)
      return 0;
    const double rounding = 1e-12 * k.cwiseAbs().maxCoeff();
    return (k.array() < -rounding).count();
  }
} // namespace springfit
