#include <springfit/fit/cell_model.h>

#include <algorithm>
#include <cmath>

namespace springfit
{
  bool
  all_finite(const CellModel &model)
  {
    return model.k.allFinite() &&
           std::all_of(model.couplings.begin(),
                       model.couplings.end(),
                       [](const LengthCoupling &coupling) {
                         return std::isfinite(coupling.stiffness);
                       }) &&
           std::isfinite(model.volume_stiffness.value_or(0.));
  }
} // namespace springfit
