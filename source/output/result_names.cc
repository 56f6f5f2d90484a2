#include <springfit/output/result_names.h>
#include <springfit/springs/spring_kinds.h>

#include <regex>
#include <set>
#include <string>

namespace springfit
{
  namespace
  {
    /** "fem|block|..." */
    std::string
    alternatives(const std::vector<std::string> &words)
    {
      std::string all;
      for (const auto &word : words)
        all += (all.empty() ? "" : "|") + word;
      return all;
    }

    /** "springs|angles|...", for a regular expression. */
    std::string
    words_of_kinds()
    {
      std::set<std::string> words;
      for (const SpringKind *kind : spring_kinds())
        words.insert(kind->word());
      return alternatives({words.begin(), words.end()});
    }
  } // namespace

  bool
  is_result(const std::string &name, const std::vector<std::string> &models)
  {
    const std::regex results(
      "checkpoint\\.bin|recommended\\.prm|tradeoff\\.(csv|md|gp|svg|png)|stability(_boundaries)?\\.(csv|md|gp)|stability_[A-Za-z_]+\\.svg|stability\\.unfinished|(stable_steps|comparison|dynamics|adapt|models_of_cells|reactions|fit|families|sets|nodes|cells|sweep|(" +
      words_of_kinds() + ")_.*|.+_(" + alternatives(models) +
      ")(_.*)?)\\.csv|export_.+\\.(scn|lmp|data|inp|feb|msd|xml|npz)|.*\\.vtu|.*\\.pvd");
    return std::regex_match(name, results);
  }
} // namespace springfit
