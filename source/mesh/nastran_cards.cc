#include <springfit/mesh/nastran_cards.h>

#include <algorithm>

namespace springfit
{
  namespace
  {
    std::string
    without_tabs(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        if (c == '\t')
          result.append(8 - result.size() % 8, ' ');
        else
          result += c;
      return result;
    }

    /** The first field of a line, and the others, as many as one holds. */
    struct Row
    {
      std::string head;
      std::vector<std::string> fields; // 8, or 4 if they are large
    };

    Row
    row_of(const std::string &text)
    {
      const bool is_free = text.find(',') != std::string::npos;
      Row row;
      row.head =
        trimmed(is_free ? split_fields(text, ',')[0] : text.substr(0, 8));
      const bool is_large =
        !row.head.empty() && (row.head.back() == '*' || row.head[0] == '*');
      const std::size_t width = is_large ? 16 : 8;
      if (is_free)
        {
          row.fields = split_fields(text, ',');
          row.fields.erase(row.fields.begin());
        }
      else
        for (std::size_t begin = 8; begin < text.size(); begin += width)
          row.fields.push_back(trimmed(text.substr(begin, width)));
      // What is behind marks the line that goes on.
      row.fields.resize(is_large ? 4 : 8);
      return row;
    }

    // A mark of a continuation begins with a sign, or is left out.
    bool
    continues(const std::string &text)
    {
      const char first = text[0];
      if (first == ' ')
        return trimmed(text.substr(0, 8)).empty();
      return first == '+' || first == '*' || first == ',';
    }

    bool
    begins_with(const std::string &text, const std::string &beginning)
    {
      return text.rfind(beginning, 0) == 0;
    }
  } // namespace


  std::string
  NastranCard::field(const std::size_t i) const
  {
    return i < fields.size() ? fields[i] : "";
  }


  NastranBulk
  read_nastran_bulk(const std::filesystem::path &file)
  {
    NastranBulk bulk;
    for (const TextLine &line : read_text_lines(file))
      {
        const std::string text =
          without_tabs(line.text.substr(0, line.text.find('$')));
        if (trimmed(text).empty())
          continue;
        const Row row = row_of(text);
        if (continues(text) && !bulk.cards.empty())
          {
            NastranCard &card = bulk.cards.back();
            card.fields.insert(card.fields.end(),
                               row.fields.begin(),
                               row.fields.end());
            continue;
          }
        const std::string words = in_capitals(trimmed(text));
        if (begins_with(words, "ENDDATA"))
          {
            bulk.has_end = true;
            return bulk;
          }
        if (begins_with(words, "BEGIN BULK") ||
            begins_with(words, "BEGIN,BULK"))
          {
            bulk.cards.clear();
            continue;
          }
        NastranCard card{in_capitals(row.head), row.fields, line.place};
        card.name.erase(std::remove(card.name.begin(), card.name.end(), '*'),
                        card.name.end());
        card.name = trimmed(card.name);
        bulk.cards.push_back(card);
      }
    return bulk;
  }


  double
  read_nastran_real(const std::string &text, const TextPlace &place)
  {
    if (text.empty())
      return 0.;
    std::string number     = text;
    const std::size_t sign = number.find_last_of("+-");
    if (number.find_first_of("eEdD") == std::string::npos &&
        sign != std::string::npos && sign > 0)
      number.insert(sign, "e");
    return read_real(number, place);
  }
} // namespace springfit
