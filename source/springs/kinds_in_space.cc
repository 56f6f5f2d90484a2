#include <springfit/springs/angles.h>
#include <springfit/springs/couplings.h>
#include <springfit/springs/kinds_in_space.h>
#include <springfit/springs/lengths.h>
#include <springfit/springs/surface_areas.h>
#include <springfit/springs/volumes.h>
#include <springfit/springs/zero_lengths.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace springfit
{
  namespace
  {
    using Pair = std::pair<const SpringKind *, const SpringKind *>;

    std::vector<Pair>
    plane_and_space()
    {
      const CellKind triangle = CellKind::triangle;
      std::vector<Pair> pairs;
      for (const auto &[law, word] : spring_law_words())
        {
          pairs.emplace_back(&lengths(2, law), &lengths(3, law));
          pairs.emplace_back(&couplings(2, law), &couplings(3, law));
        }
      pairs.emplace_back(&zero_lengths(2), &zero_lengths(3));
      pairs.emplace_back(&angles(2), &angles(3));
      pairs.emplace_back(&volumes(triangle), &surface_areas());
      pairs.emplace_back(&logarithmic_volumes(triangle),
                         &logarithmic_surface_areas());
      pairs.emplace_back(&logarithmic_areas_in_plane_stress(triangle),
                         &logarithmic_surface_areas_in_plane_stress());
      return pairs;
    }
  } // namespace

  const SpringKind &
  in_space(const SpringKind &kind)
  {
    static const std::vector<Pair> pairs = plane_and_space();
    for (const auto &[plane, space] : pairs)
      if (plane == &kind)
        return *space;
    throw std::logic_error("'" + kind.word() + "' are no springs of a surface");
  }

  Family
  in_space(const Family &family)
  {
    Family result(in_space(*family.kind));
    result.members = family.members;
    return result;
  }
} // namespace springfit
