#include <springfit/fit/cell_model.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace springfit
{
  bool
  all_finite(const CellModel &model)
  {
    return model.k.allFinite() && model.angle_stiffness.allFinite() &&
           std::all_of(model.couplings.begin(),
                       model.couplings.end(),
                       [](const LengthCoupling &coupling) {
                         return std::isfinite(coupling.stiffness);
                       }) &&
           std::isfinite(model.volume_stiffness.value_or(0.));
  }


  CellModel
  between(const CellModel &a, const CellModel &b, const double t)
  {
    CellModel model;
    model.k = (1. - t) * a.k + t * b.k;
    model.angle_stiffness =
      (1. - t) * a.angle_stiffness + t * b.angle_stiffness;
    if (a.volume_stiffness)
      model.volume_stiffness =
        (1. - t) * *a.volume_stiffness + t * b.volume_stiffness.value();
    std::map<std::pair<unsigned int, unsigned int>, double> couplings;
    for (const auto &coupling : a.couplings)
      couplings[{coupling.a, coupling.b}] += (1. - t) * coupling.stiffness;
    for (const auto &coupling : b.couplings)
      couplings[{coupling.a, coupling.b}] += t * coupling.stiffness;
    for (const auto &[springs, stiffness] : couplings)
      model.couplings.push_back({springs.first, springs.second, stiffness});
    return model;
  }
} // namespace springfit
