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

    /** Levenshtein's distance, row by row. */
    std::size_t
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 1; i <= a.size(); ++i)
        {
          std::size_t diagonal = row[0];
          row[0]               = i;
          for (std::size_t j = 1; j <= b.size(); ++j)
            {
              const std::size_t substituted =
                diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
              diagonal = row[j];
              row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
            }
        }
      return row.back();
    }
  } // namespace

  std::string
  nearest_word(const std::string              &word,
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
  did_you_mean(const std::string              &word,
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
    std::size_t              begin = 0;
    while (begin <= text.size())
      {
        const std::size_t end   = std::min(text.find(',', begin), text.size());
        std::string       piece = text.substr(begin, end - begin);
        const std::size_t first = piece.find_first_not_of(" \t");
        const std::size_t last  = piece.find_last_not_of(" \t");
        if (first != std::string::npos)
          pieces.push_back(piece.substr(first, last - first + 1));
        begin = end + 1;
      }
    return pieces;
  }
} // namespace springfit
