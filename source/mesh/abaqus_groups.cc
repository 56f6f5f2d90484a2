#include <springfit/mesh/abaqus_fields.h>
#include <springfit/mesh/abaqus_groups.h>

#include <cctype>
#include <map>
#include <string>

namespace springfit
{
  namespace
  {
    AbaqusSet &
    begin_set(const AbaqusBlock &block,
              std::map<std::string, AbaqusSet> &sets,
              const std::string &key)
    {
      const std::string name = block.setting(key);
      if (name.empty())
        throw text_error(block.place, "a set has no name");
      AbaqusSet &set  = set_in(sets, name);
      set.is_internal = block.settings.count("INTERNAL") > 0;
      return set;
    }

    void
    read_members(const AbaqusBlock &block, AbaqusSet &set)
    {
      for (const TextLine &line : block.lines)
        if (block.settings.count("GENERATE") > 0)
          {
            const auto fields = abaqus_fields(line);
            const auto first  = needed_label(fields, 0, line.place);
            const auto last   = label_or(fields, 1, first, line.place);
            const auto step   = label_or(fields, 2, 1, line.place);
            if (last < first)
              throw text_error(line.place,
                               "the set goes from " + std::to_string(first) +
                                 " to " + std::to_string(last));
            set.ranges.push_back({first, last, step});
          }
        else
          for (const std::string &field : abaqus_fields(line))
            if (std::isdigit(static_cast<unsigned char>(field[0])) ||
                field[0] == '-')
              add_label(set, read_label(field, line.place));
            else if (!field.empty())
              set.sets.push_back({field, line.place});
    }
  } // namespace


  void
  define_node_set(const AbaqusBlock &block, AbaqusInstance &home)
  {
    AbaqusSet &set = begin_set(block, home.node_sets, "NSET");
    if (block.settings.count("ELSET") > 0)
      set.element_sets.push_back({block.setting("ELSET"), block.place});
    read_members(block, set);
  }


  void
  define_element_set(const AbaqusBlock &block, AbaqusInstance &home)
  {
    read_members(block, begin_set(block, home.element_sets, "ELSET"));
  }


  bool
  define_surface(const AbaqusBlock &block, AbaqusInstance &home)
  {
    const std::string type = in_capitals(block.setting("TYPE"));
    const std::string name = block.setting("NAME");
    if (name.empty())
      throw text_error(block.place, "a surface has no name");
    if (!(type.empty() || type == "ELEMENT" || type == "NODE") ||
        block.settings.count("COMBINE") > 0)
      return false;
    AbaqusSurface surface{name,
                          block.settings.count("INTERNAL") > 0,
                          type == "NODE",
                          {}};
    for (const TextLine &line : block.lines)
      {
        const auto fields = abaqus_fields(line);
        if (fields.empty() || fields[0].empty())
          throw text_error(line.place, "a surface names no set");
        surface.items.push_back(
          {fields[0],
           fields.size() > 1 && type != "NODE" ? in_capitals(fields[1]) : "",
           line.place});
      }
    home.surfaces.push_back(surface);
    return true;
  }
} // namespace springfit
