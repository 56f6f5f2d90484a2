#include <springfit/mesh/abaqus_fields.h>

namespace springfit
{
  std::vector<std::string>
  abaqus_fields(const TextLine &line)
  {
    auto fields = split_fields(line.text, ',');
    while (!fields.empty() && fields.back().empty())
      fields.pop_back();
    return fields;
  }


  std::size_t
  label_or(const std::vector<std::string> &fields,
           const std::size_t i,
           const std::size_t absent,
           const TextPlace &place)
  {
    return i < fields.size() && !fields[i].empty()
             ? read_label(fields[i], place)
             : absent;
  }


  std::size_t
  needed_label(const std::vector<std::string> &fields,
               const std::size_t i,
               const TextPlace &place)
  {
    if (i >= fields.size() || fields[i].empty())
      throw text_error(place,
                       "the line ends before its number " +
                         std::to_string(i + 1));
    return read_label(fields[i], place);
  }


  std::vector<double>
  reals_of(const TextLine &line)
  {
    std::vector<double> values;
    for (const std::string &field : abaqus_fields(line))
      values.push_back(field.empty() ? 0. : read_real(field, line.place));
    return values;
  }


  void
  add_label(AbaqusSet &set, const std::size_t label)
  {
    if (!set.ranges.empty() && set.ranges.back().step == 1 &&
        set.ranges.back().last + 1 == label)
      set.ranges.back().last = label;
    else
      set.ranges.push_back({label, label, 1});
  }

  AbaqusSet &
  set_in(std::map<std::string, AbaqusSet> &sets, const std::string &name)
  {
    AbaqusSet &set = sets[in_capitals(name)];
    if (set.name.empty())
      set.name = name;
    return set;
  }
} // namespace springfit
