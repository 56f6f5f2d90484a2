#ifndef springfit_core_words_h
#define springfit_core_words_h

#include <springfit/core/error.h>

#include <algorithm>
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
   * substitutions, swaps of neighbours, case ignored), or an empty string when
   * none is near: more than a third of the letters, and at least two, would
   * have to change.
   */
  std::string
  nearest_word(const std::string &word,
               const std::vector<std::string> &candidates);

  /**
   * " Did you mean 'x'?" for the nearest candidate, or an empty string.
   */
  std::string
  did_you_mean(const std::string &word,
               const std::vector<std::string> &candidates);

  /** "a, b, c" */
  std::string
  join(const std::vector<std::string> &words,
       const std::string &separator = ", ");

  /**
   * The pieces of @p text between commas, blanks at both ends removed. A comma
   * within double quotes does not separate; the quotes stay.
   */
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
           const std::string &word,
           const std::string &entry)
  {
    for (const auto &known : table)
      if (known.second == word)
        return known.first;
    const auto known = words_of(table);
    throw EntryError(entry,
                     "'" + word + "' is not known." + did_you_mean(word, known),
                     "Known are: " + join(known) + ".");
  }

  /**
   * The values of a list of words between commas, in the user's order.
   *
   * @throws EntryError when the list is empty, or names a value twice or one
   * that is not known.
   */
  template <typename Enum>
  std::vector<Enum>
  values_of(const WordTable<Enum> &table,
            const std::string &list,
            const std::string &entry)
  {
    std::vector<Enum> values;
    for (const auto &word : split_at_commas(list))
      {
        const Enum value = value_of(table, word, entry);
        if (std::find(values.begin(), values.end(), value) != values.end())
          throw EntryError(entry,
                           "'" + word + "' is given twice.",
                           "Give it once.");
        values.push_back(value);
      }
    if (values.empty())
      throw EntryError(entry,
                       "the list is empty.",
                       "Give at least one of " + join(words_of(table)) + ".");
    return values;
  }
} // namespace springfit

#endif
