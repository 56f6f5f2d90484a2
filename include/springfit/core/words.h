#ifndef springfit_core_words_h
#define springfit_core_words_h

#include <springfit/core/error.h>

#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  /**
   * The words by which a user names the values of an enumeration, in the
   * order in which they are offered.
   */
  template <typename Enum>
  using WordTable = std::vector<std::pair<Enum, std::string>>;

  /**
   * The candidate nearest to @p word by edit distance (insertions, deletions,
   * substitutions, swaps of neighbours, case ignored), or an empty string when none is near: more
   * than a third of the letters, and at least two, would have to change.
   */
  std::string
  nearest_word(const std::string              &word,
               const std::vector<std::string> &candidates);

  /**
   * " Did you mean 'x'?" for the nearest candidate, or an empty string.
   */
  std::string
  did_you_mean(const std::string              &word,
               const std::vector<std::string> &candidates);

  /** "a, b, c" */
  std::string
  join(const std::vector<std::string> &words,
       const std::string              &separator = ", ");

  /** The pieces of @p text between commas, blanks at both ends removed. */
  std::vector<std::string>
  split_at_commas(const std::string &text);

  template <typename Enum>
  std::vector<std::string>
  words_of(const WordTable<Enum> &table)
  {
    std::vector<std::string> words;
    for (const auto &entry : table)
      words.push_back(entry.second);
    return words;
  }

  /** The word of @p value, which must be in the table. */
  template <typename Enum>
  std::string
  word_of(const WordTable<Enum> &table, const Enum value)
  {
    for (const auto &entry : table)
      if (entry.first == value)
        return entry.second;
    throw std::logic_error("a value of an enumeration has no word");
  }

  /**
   * The value of @p word. @p entry names the parameter in the error.
   *
   * @throws EntryError with the nearest known word when there is none such.
   */
  template <typename Enum>
  Enum
  value_of(const WordTable<Enum> &table,
           const std::string     &word,
           const std::string     &entry)
  {
    for (const auto &known : table)
      if (known.second == word)
        return known.first;
    const auto known = words_of(table);
    throw EntryError(entry,
                     "'" + word + "' is not known." +
                       did_you_mean(word, known),
                     "Known are: " + join(known) + ".");
  }
} // namespace springfit

#endif
