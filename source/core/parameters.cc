#include <springfit/core/example_scene.h>
#include <springfit/core/parameter_text.h>
#include <springfit/core/parameters.h>
#include <springfit/core/trimmed.h>
#include <springfit/core/unexpected.h>
#include <springfit/core/words.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

namespace springfit
{
  namespace
  {
    std::vector<std::string>
    split(const std::string &text, const char separator)
    {
      std::vector<std::string> pieces;
      std::istringstream stream(text);
      for (std::string piece; std::getline(stream, piece, separator);)
        pieces.push_back(trimmed(piece));
      return pieces;
    }

    /** The entries that @p prm declares, with their sections. */
    std::vector<std::string>
    declared_entries(const dealii::ParameterHandler &prm)
    {
      std::stringstream text;
      prm.print_parameters(text, dealii::ParameterHandler::ShortText);
      std::vector<std::string> entries;
      for (const auto &line : scan_parameters(text))
        entries.push_back(line.entry);
      return entries;
    }

    /** The name of an entry without its sections. */
    std::string
    name_of(const std::string &path)
    {
      return path.substr(path.rfind('/') + 1);
    }

    /** The sections of an entry without its name: "Geometry/". */
    std::string
    section_of(const std::string &path)
    {
      return path.substr(0, path.size() - name_of(path).size());
    }

    /** What a misspelt entry may mean: one of its section, or else another. */
    std::string
    did_you_mean_entry(const std::string &path,
                       const std::vector<std::string> &declared)
    {
      for (const bool same_section : {true, false})
        {
          std::vector<std::string> names, paths;
          for (const auto &entry : declared)
            if (!same_section || section_of(entry) == section_of(path))
              {
                names.push_back(name_of(entry));
                paths.push_back(entry);
              }
          const auto nearest = nearest_word(name_of(path), names);
          if (!nearest.empty())
            return " Did you mean '" +
                   paths[std::find(names.begin(), names.end(), nearest) -
                         names.begin()] +
                   "'?";
        }
      return "";
    }

    std::vector<std::string>
    section_names(const std::vector<std::string> &paths)
    {
      std::vector<std::string> names;
      for (const auto &path : paths)
        {
          auto pieces = split(path, '/');
          pieces.pop_back();
          names.insert(names.end(), pieces.begin(), pieces.end());
        }
      return names;
    }

    /** How to mend a value that does not match deal.II's @p pattern. */
    std::string
    form_of(const std::string &pattern)
    {
      const auto begins_with = [&](const std::string &text) {
        return pattern.compare(0, text.size(), text) == 0;
      };
      if (begins_with("[List of <[Double"))
        return "Give finite numbers, separated by commas.";
      if (begins_with("[Double"))
        return "Give a finite number.";
      if (begins_with("[Integer range 0"))
        return "Give a whole number that is not negative.";
      if (begins_with("[Integer"))
        return "Give a whole number.";
      if (begins_with("[Bool"))
        return "Give true or false.";
      return "Give a value of the form " + pattern + '.';
    }

    /** The entry that is set in a line of a file, or else an empty string. */
    std::string
    entry_in_line(const std::string &file_name, const unsigned int number)
    {
      std::ifstream file(file_name);
      for (const auto &line : scan_parameters(file))
        if (line.line == number)
          return line.entry;
      return "";
    }

    /** deal.II's complaint about a parameter file, in this program's words. */
    InputError
    explained(const dealii::ExceptionBase &exception,
              const std::vector<std::string> &declared)
    {
      const std::string list = "'springfit --defaults 2' or '3' lists every ";
      std::string what       = message_of(exception);
      std::string place = "", entry = "";
      std::smatch match;
      if (std::regex_match(what,
                           match,
                           std::regex("Line <(\\d+)> of file <(.*?)>?: (.*)")))
        {
          entry = entry_in_line(match[2], std::stoul(match[1]));
          place = match[2].str() + ", line " + match[1].str() + ": ";
          what  = std::string(match[3]);
        }

      if (std::regex_search(what,
                            match,
                            std::regex("No entry with name <(.*?)>")))
        {
          if (entry.empty())
            entry = match[1];
          return InputError(place + "there is no entry '" + entry + "'." +
                              did_you_mean_entry(entry, declared),
                            list + "entry.");
        }
      if (std::regex_search(
            what, match, std::regex("no such subsection to be entered: (.*)")))
        return InputError(place + "there is no section '" + match[1].str() +
                            "'." +
                            did_you_mean(match[1], section_names(declared)),
                          list + "section.");
      if (std::regex_search(what,
                            match,
                            std::regex("The entry value (.*) for the entry "
                                       "named (.*) does not match the given "
                                       "pattern: (.*)")))
        return InputError(place + (entry.empty() ? match[2].str() : entry) +
                            ": '" + match[1].str() + "' cannot be read.",
                          form_of(match[3]));
      return InputError(place + what + (what.back() == '.' ? "" : "."),
                        "Correct the parameter file; " + list +
                          "entry in its section.");
    }

    struct Override
    {
      std::string entry, value;
    };

    Override
    parse_override(const std::string &text)
    {
      const auto equals = text.find('=');
      if (equals == std::string::npos)
        throw InputError("--set \"" + text + "\" has no equals sign.",
                         "Write --set \"Section/Entry=value\", for example "
                         "--set \"Geometry/Cell size=0.005\".");
      return {trimmed(text.substr(0, equals)),
              trimmed(text.substr(equals + 1))};
    }

    void
    apply_override(dealii::ParameterHandler &prm,
                   const std::string &text,
                   const std::vector<std::string> &declared)
    {
      const auto [entry, value] = parse_override(text);
      if (std::find(declared.begin(), declared.end(), entry) == declared.end())
        throw InputError("--set \"" + text + "\": there is no entry '" + entry +
                           "'." + did_you_mean_entry(entry, declared),
                         "Write --set \"Section/Entry=value\"; 'springfit "
                         "--defaults 2' or '3' lists every entry.");

      check_can_be_stored(entry, value);

      auto sections          = split(entry, '/');
      const std::string name = sections.back();
      sections.pop_back();
      for (const auto &section : sections)
        prm.enter_subsection(section);
      try
        {
          prm.set(name, value);
        }
      catch (const dealii::ExceptionBase &exception)
        {
          const std::string what = message_of(exception);
          std::smatch match;
          std::regex_search(what, match, std::regex("given pattern <(.*)>"));
          throw InputError("--set \"" + text + "\": '" + value +
                             "' cannot be read.",
                           form_of(match[1]));
        }
      for (std::size_t s = 0; s < sections.size(); ++s)
        prm.leave_subsection();
    }

    /** The name in a line "include NAME", or else an empty string. */
    std::string
    included_in(const std::string &line)
    {
      const std::string text = trimmed(line.substr(0, line.find('#')));
      std::istringstream words(text);
      std::string first;
      words >> first;
      return first == "include" || first == "INCLUDE"
               ? trimmed(text.substr(first.size()))
               : "";
    }

    /**
     * deal.II reads what @p file includes without end, when it comes back to
     * the file, and waits for the other end of a pipe.
     *
     * @param above the files that lead to this one, with itself
     * @param done files that need not be checked once more
     */
    void
    check_includes(const std::filesystem::path &file,
                   const std::set<std::filesystem::path> &above,
                   std::set<std::filesystem::path> &done)
    {
      std::ifstream stream(file);
      unsigned int number = 0;
      for (std::string line; std::getline(stream, line);)
        {
          ++number;
          const std::filesystem::path name = included_in(line);
          std::error_code error;
          const auto status = std::filesystem::status(name, error);
          // deal.II complains about what is missing.
          if (name.empty() || !std::filesystem::exists(status))
            continue;
          const std::string what = file.string() + ", line " +
                                   std::to_string(number) + ": '" +
                                   name.string() + "'";
          if (!std::filesystem::is_regular_file(status))
            throw InputError(what + " is included and is not a regular file.",
                             "Include a parameter file.");
          const auto place = std::filesystem::canonical(name, error);
          if (above.count(place) > 0)
            throw InputError(what + " is included by itself" +
                               (above.size() > 1
                                  ? ", or by a file that it includes."
                                  : "."),
                             "Remove the line.");
          if (!done.insert(place).second)
            continue;
          auto chain = above;
          chain.insert(place);
          check_includes(name, chain, done);
        }
    }
  } // namespace

  void
  check_parameter_file(const std::filesystem::path &file)
  {
    const std::string mend =
      "Name an existing parameter file, for example " + example_scene() + '.';
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found)
      throw InputError("The parameter file '" + file.string() +
                         "' does not exist.",
                       mend);
    if (error)
      throw InputError("The parameter file '" + file.string() +
                         "' cannot be read: " + error.message() + '.',
                       mend);
    if (std::filesystem::is_directory(status))
      throw InputError("'" + file.string() +
                         "' is a directory, not a parameter file.",
                       mend);
    if (!std::filesystem::is_regular_file(status))
      throw InputError("'" + file.string() + "' is not a regular file.",
                       "Save the parameters in a file: it is read more than "
                       "once.");
    if (!std::ifstream(file))
      throw InputError("The parameter file '" + file.string() +
                         "' cannot be read.",
                       mend);
    std::set<std::filesystem::path> done;
    check_includes(file, {std::filesystem::canonical(file, error)}, done);
  }

  void
  check_can_be_stored(const std::string &entry, const std::string &value)
  {
    std::string what;
    if (value.find('#') != std::string::npos)
      what = "has the sign #, where a comment begins in a parameter file.";
    else if (value.find_first_of("\n\r\t") != std::string::npos)
      what = "has a line break or a tab, which a parameter file cannot keep.";
    else if (!value.empty() && value.back() == '\\')
      what = "ends in a backslash, after which a line of a parameter file goes "
             "on in the next.";
    if (!what.empty())
      throw EntryError(entry,
                       "'" + value + "' " + what,
                       "Write it without; rename a file or a folder.");
  }

  void
  read_parameters(dealii::ParameterHandler &prm, const ParameterSource &source)
  {
    const auto declared = declared_entries(prm);
    try
      {
        std::ifstream file(source.file);
        prm.parse_input(file, source.file.string());
      }
    catch (const dealii::ExceptionBase &exception)
      {
        throw explained(exception, declared);
      }
    for (const auto &text : source.overrides)
      apply_override(prm, text, declared);
  }

  std::string
  read_top_level_entry(const ParameterSource &source, const std::string &entry)
  {
    std::string value;
    std::ifstream file(source.file);
    for (const auto &line : scan_parameters(file))
      if (line.entry == entry)
        value = line.value;
    for (const auto &text : source.overrides)
      if (const auto given = parse_override(text); given.entry == entry)
        value = given.value;
    return value;
  }

  std::string
  locate(const EntryError &error, const ParameterSource &source)
  {
    // The last one is in force.
    for (auto text = source.overrides.rbegin(); text != source.overrides.rend();
         ++text)
      if (parse_override(*text).entry == error.entry)
        return "--set \"" + *text + "\": " + error.what();

    std::optional<unsigned int> number;
    std::ifstream file(source.file);
    for (const auto &line : scan_parameters(file))
      if (line.entry == error.entry)
        number = line.line;
    return source.file.string() +
           (number ? ", line " + std::to_string(*number) : "") + ": " +
           error.what();
  }
} // namespace springfit
