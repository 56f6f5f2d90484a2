#include <springfit/core/cell_kind.h>
#include <springfit/springs/angles.h>
#include <springfit/springs/couplings.h>
#include <springfit/springs/lengths.h>
#include <springfit/springs/point_volumes.h>
#include <springfit/springs/spring_kinds.h>
#include <springfit/springs/surface_areas.h>
#include <springfit/springs/volumes.h>
#include <springfit/springs/zero_lengths.h>

#include <algorithm>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    std::vector<const SpringKind *>
    all_kinds()
    {
      std::vector<const SpringKind *> all;
      for (const int dim : {2, 3})
        {
          for (const auto &law : spring_law_words())
            {
              all.push_back(&lengths(dim, law.first));
              all.push_back(&couplings(dim, law.first));
            }
          all.push_back(&zero_lengths(dim));
          all.push_back(&angles(dim));
        }
      for (const auto &[cell, word] : cell_kind_words())
        {
          all.push_back(&volumes(cell));
          all.push_back(&logarithmic_volumes(cell));
          if (dimension(cell) == 2)
            all.push_back(&logarithmic_areas_in_plane_stress(cell));
          if (is_simplex(cell))
            continue;
          all.push_back(&point_volumes(cell));
          all.push_back(&logarithmic_point_volumes(cell));
          if (dimension(cell) == 2)
            all.push_back(&logarithmic_point_areas_in_plane_stress(cell));
        }
      all.push_back(&surface_areas());
      all.push_back(&logarithmic_surface_areas());
      all.push_back(&logarithmic_surface_areas_in_plane_stress());
      return all;
    }
  } // namespace

  const std::vector<const SpringKind *> &
  spring_kinds()
  {
    static const std::vector<const SpringKind *> all = all_kinds();
    return all;
  }

  std::size_t
  number_of(const SpringKind &kind)
  {
    const auto &all  = spring_kinds();
    const auto found = std::find(all.begin(), all.end(), &kind);
    if (found == all.end())
      throw std::logic_error("a kind of spring is not in the list of all");
    return found - all.begin();
  }
} // namespace springfit
