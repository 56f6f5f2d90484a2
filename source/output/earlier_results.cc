#include <springfit/core/error.h>
#include <springfit/output/earlier_results.h>
#include <springfit/response/load_case.h>
#include <springfit/springs/spring_kinds.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    /** "springs|angles|...", for a regular expression. */
    std::string
    words_of_kinds()
    {
      std::set<std::string> words;
      for (const SpringKind *kind : spring_kinds())
        words.insert(kind->word());
      std::string all;
      for (const auto &word : words)
        all += (all.empty() ? "" : "|") + word;
      return all;
    }

    /** "tension|compression|...", for a regular expression. */
    std::string
    words_of_loads()
    {
      std::string all;
      for (const auto &[load, word] : load_words())
        all += (all.empty() ? "" : "|") + word;
      return all;
    }
  } // namespace

  void
  remove_earlier_results(const std::filesystem::path &folder)
  {
    if (!std::filesystem::exists(folder / "used.prm"))
      return;
    const std::regex results("(comparison|fit|nodes|cells|sweep|(" +
                             words_of_kinds() + ")_.*|(" + words_of_loads() +
                             ")_.*)\\.csv|.*\\.vtu|.*\\.pvd");
    std::vector<std::filesystem::path> files;
    for (const auto &entry : std::filesystem::directory_iterator(folder))
      if (entry.is_regular_file() &&
          std::regex_match(entry.path().filename().string(), results))
        files.push_back(entry.path());
    for (const auto &file : files)
      {
        std::error_code error;
        std::filesystem::remove(file, error);
        if (error)
          throw RunError("The result of an earlier run, '" + file.string() +
                           "', cannot be removed: " + error.message() + '.',
                         "Choose another 'Output directory'.");
      }
  }
} // namespace springfit
