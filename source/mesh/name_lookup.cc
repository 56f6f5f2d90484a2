#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/mesh/mesh_text.h>
#include <springfit/mesh/name_lookup.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace springfit
{
  namespace
  {
    bool
    is_quoted(const std::string &word)
    {
      return word.size() > 1 && word.front() == '"' && word.back() == '"';
    }

    std::set<unsigned int>
    ids_by_number(const std::vector<IdAndName> &known,
                  const std::string &number)
    {
      std::set<unsigned int> ids;
      for (const IdAndName &candidate : known)
        if (std::to_string(candidate.id) == number)
          ids.insert(candidate.id);
      return ids;
    }

    // As it is spelt, or else whatever the case if that leaves one spelling.
    std::set<unsigned int>
    ids_by_name(const std::vector<IdAndName> &known, const std::string &name)
    {
      std::set<unsigned int> exact, similar;
      std::set<std::string> spellings;
      for (const IdAndName &candidate : known)
        {
          if (candidate.name.empty())
            continue;
          if (candidate.name == name)
            exact.insert(candidate.id);
          if (in_capitals(candidate.name) == in_capitals(name))
            {
              similar.insert(candidate.id);
              spellings.insert(candidate.name);
            }
        }
      if (!exact.empty() || spellings.size() > 1)
        return exact;
      return similar;
    }

    constexpr unsigned int n_listed = 12;

    /** "1, 2 'left' and 'all'", not too many. */
    std::string
    listed(const std::vector<IdAndName> &known)
    {
      std::map<unsigned int, std::vector<std::string>> names;
      for (const IdAndName &candidate : known)
        {
          auto &of_id = names[candidate.id];
          if (!candidate.name.empty())
            of_id.push_back('\'' + candidate.name + '\'');
        }
      std::vector<std::string> words;
      for (auto &[id, of_id] : names)
        {
          constexpr unsigned int n_of_id = 4;
          if (of_id.size() > n_of_id)
            {
              const auto n_more = of_id.size() - n_of_id;
              of_id.resize(n_of_id);
              of_id.push_back(std::to_string(n_more) + " more");
            }
          words.push_back(std::to_string(id) + (of_id.empty() ? "" : " ") +
                          join(of_id, " and "));
        }
      return join_some(words, n_listed);
    }

    std::string
    listed(const UnusedNames &unused, const std::string &what)
    {
      std::vector<std::string> words;
      for (const auto &[name, reason] : unused)
        words.push_back('\'' + name + "' (" + reason + ')');
      return words.empty() ? ""
                           : " Names in the file that are no " + what + ": " +
                               join_some(words, n_listed) + '.';
    }

    std::string
    reason_of(const UnusedNames &unused, const std::string &name)
    {
      for (const auto &[other, reason] : unused)
        if (in_capitals(other) == in_capitals(name))
          return '\'' + other + "' is in the file, but it " + reason + '.';
      return "";
    }

    std::vector<std::string>
    names_in(const std::vector<IdAndName> &known)
    {
      std::vector<std::string> names;
      for (const IdAndName &candidate : known)
        if (!candidate.name.empty())
          names.push_back(candidate.name);
      return names;
    }
  } // namespace


  std::vector<IdAndName>
  ids_and_names(const std::set<unsigned int> &ids,
                const std::multimap<unsigned int, std::string> &names)
  {
    std::vector<IdAndName> result;
    for (const unsigned int id : ids)
      {
        const auto [begin, end] = names.equal_range(id);
        if (begin == end)
          result.push_back({id, ""});
        for (auto name = begin; name != end; ++name)
          result.push_back({id, name->second});
      }
    return result;
  }


  std::string
  joined_names(const std::multimap<unsigned int, std::string> &names,
               const unsigned int id)
  {
    std::vector<std::string> of_id;
    const auto [begin, end] = names.equal_range(id);
    for (auto name = begin; name != end; ++name)
      of_id.push_back(name->second);
    return join(of_id);
  }


  std::set<unsigned int>
  find_ids(const std::vector<IdAndName> &known,
           const UnusedNames &unused,
           const std::string &word,
           const std::string &what,
           const std::string &entry)
  {
    const std::string name =
      is_quoted(word) ? word.substr(1, word.size() - 2) : word;
    const auto by_name = ids_by_name(known, name);
    const auto by_number =
      is_quoted(word) ? std::set<unsigned int>() : ids_by_number(known, word);
    const bool is_all_of_that_name = std::includes(by_name.begin(),
                                                   by_name.end(),
                                                   by_number.begin(),
                                                   by_number.end());
    if (!by_name.empty() && !is_all_of_that_name)
      throw EntryError(entry,
                       "'" + word + "' is the number of one " + what +
                         " and the name of another.",
                       "Write \"" + word + "\" in quotes for the name, id " +
                         word + " for the number. There are: " + listed(known) +
                         '.');
    if (!by_name.empty())
      return by_name;
    if (!by_number.empty())
      return by_number;

    const std::string explicit_number = "id ";
    if (word.rfind(explicit_number, 0) == 0)
      {
        const auto ids =
          ids_by_number(known, word.substr(explicit_number.size()));
        if (!ids.empty())
          return ids;
      }
    const std::string reason = reason_of(unused, name);
    throw EntryError(entry,
                     reason.empty()
                       ? "the mesh has no " + what + " '" + name + "'." +
                           did_you_mean(name, names_in(known))
                       : reason,
                     "It has: " + listed(known) + '.' + listed(unused, what));
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
