#include <springfit/core/words.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace springfit
{
  namespace
  {
    std::string
    lower_case(std::string text)
    {
      for (char &c : text)
        c = std::tolower(static_cast<unsigned char>(c));
      return text;
    }

    /** Levenshtein's distance; two neighbours swapped count once. */
    std::size_t
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> before, previous, row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 1; i <= a.size(); ++i)
        {
          before   = previous;
          previous = row;
          row[0]   = i;
          for (std::size_t j = 1; j <= b.size(); ++j)
            {
              const std::size_t substituted =
                previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
              row[j] = std::min({previous[j] + 1, row[j - 1] + 1, substituted});
              if (i > 1 && j > 1 && a[i - 1] == b[j - 2] &&
                  a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
      return row.back();
    }

    /** The next comma outside of quotes, or the end. */
    std::size_t
    end_of_piece(const std::string &text, const std::size_t begin)
    {
      bool is_quoted  = false;
      std::size_t end = begin;
      for (; end < text.size() && (is_quoted || text[end] != ','); ++end)
        if (text[end] == '"')
          is_quoted = !is_quoted;
      return end;
    }
  } // namespace

  std::string
  nearest_word(const std::string &word,
               const std::vector<std::string> &candidates)
  {
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
    for (const auto &candidate : candidates)
      {
        const std::size_t distance =
          edit_distance(lower_case(word), lower_case(candidate));
        if (distance < best_distance && distance < candidate.size())
          {
            best          = candidate;
            best_distance = distance;
          }
      }
    return best;
  }

  std::string
  did_you_mean(const std::string &word,
               const std::vector<std::string> &candidates)
  {
    const std::string nearest = nearest_word(word, candidates);
    return nearest.empty() ? "" : " Did you mean '" + nearest + "'?";
  }

  std::string
  join(const std::vector<std::string> &words, const std::string &separator)
  {
    std::string text;
    for (const auto &word : words)
      text += (text.empty() ? "" : separator) + word;
    return text;
  }

  std::vector<std::string>
  split_at_commas(const std::string &text)
  {
    std::vector<std::string> pieces;
    std::size_t begin = 0;
    while (begin <= text.size())
      {
        const std::size_t end   = end_of_piece(text, begin);
        std::string piece       = text.substr(begin, end - begin);
        const std::size_t first = piece.find_first_not_of(" \t");
        const std::size_t last  = piece.find_last_not_of(" \t");
        if (first != std::string::npos)
          pieces.push_back(piece.substr(first, last - first + 1));
        begin = end + 1;
      }
    return pieces;
  }
} // namespace springfit
