#include <springfit/output/result_names.h>
#include <springfit/response/load_case.h>
#include <springfit/springs/spring_kinds.h>

#include <regex>
#include <set>
#include <string>

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

  bool
  is_result(const std::string &name)
  {
    static const std::regex results(
      "(comparison|fit|nodes|cells|sweep|(" + words_of_kinds() + ")_.*|(" +
      words_of_loads() + ")_.*)\\.csv|.*\\.vtu|.*\\.pvd");
    return std::regex_match(name, results);
  }
} // namespace springfit
