#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/mesh/name_lookup.h>

#include <algorithm>
#include <sstream>

namespace springfit
{
  std::vector<unsigned int>
  find_ids(const std::vector<IdAndName> &known,
           const std::string &word,
           const std::string &what,
           const std::string &entry)
  {
    std::vector<unsigned int> ids;
    std::vector<std::string> names, listed;
    for (const IdAndName &candidate : known)
      {
        const std::string id = std::to_string(candidate.id);
        if (word == id || (!word.empty() && word == candidate.name))
          ids.push_back(candidate.id);
        if (!candidate.name.empty())
          names.push_back(candidate.name);
        listed.push_back(
          candidate.name.empty() ? id : id + " '" + candidate.name + "'");
      }
    if (ids.empty())
      throw EntryError(entry,
                       "the mesh has no " + what + " '" + word + "'." +
                         did_you_mean(word, names),
                       "It has: " + join(listed) + ".");
    return ids;
  }


  std::string
  format_table(const std::vector<std::string> &headlines,
               const std::vector<TableLine> &lines)
  {
    std::vector<std::vector<std::string>> rows = {headlines};
    for (const TableLine &line : lines)
      {
        std::ostringstream measure;
        measure.precision(4);
        measure << line.measure;
        rows.push_back({std::to_string(line.id),
                        line.name.empty() ? "-" : line.name,
                        std::to_string(line.count),
                        measure.str()});
      }

    std::string text;
    for (const auto &row : rows)
      for (unsigned int column = 0; column < row.size(); ++column)
        {
          std::size_t width = 0;
          for (const auto &other : rows)
            width = std::max(width, other[column].size());
          const bool is_last = column + 1 == row.size();
          text += row[column];
          if (is_last)
            text += '\n';
          else
            text += std::string(width - row[column].size(), ' ') + " : ";
        }
    return text;
  }
} // namespace springfit
