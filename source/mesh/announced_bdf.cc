#include <springfit/mesh/announced.h>
#include <springfit/mesh/known_numbers.h>

#include <algorithm>
#include <map>
#include <vector>

namespace springfit
{
  namespace
  {
    /** A card with its continuations: its name and its fields, trimmed. */
    struct Card
    {
      std::string name;
      std::vector<std::string> fields;
      TextPlace place;
    };

    struct ElementType
    {
      int dim;
      unsigned int n_nodes;
      unsigned int n_nodes_of_second_order;
    };

    const std::map<std::string, ElementType> &
    element_types()
    {
      static const std::map<std::string, ElementType> types = {
        {"CTRIA3", {2, 3, 3}},
        {"CTRIA6", {2, 6, 6}},
        {"CQUAD4", {2, 4, 4}},
        {"CQUAD8", {2, 8, 8}},
        {"CTETRA", {3, 4, 10}},
        {"CPYRAM", {3, 5, 13}},
        {"CPENTA", {3, 6, 15}},
        {"CHEXA", {3, 8, 20}}};
      return types;
    }

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

    std::vector<std::string>
    fields_of(const std::string &text)
    {
      if (text.find(',') != std::string::npos)
        {
          // The tenth field marks the line that goes on.
          auto fields = split_fields(text, ',');
          if (fields.size() > 9)
            fields.resize(9);
          return fields;
        }
      const std::string head = trimmed(text.substr(0, 8));
      const std::size_t width =
        !head.empty() && (head.back() == '*' || head.front() == '*') ? 16 : 8;
      std::vector<std::string> fields = {head};
      for (std::size_t begin = 8;
           begin < std::min<std::size_t>(text.size(), 72);
           begin += width)
        fields.push_back(trimmed(
          text.substr(begin, std::min<std::size_t>(width, 72 - begin))));
      return fields;
    }

    std::vector<Card>
    read_cards(const std::filesystem::path &file)
    {
      std::vector<Card> cards;
      for (const TextLine &line : read_text_lines(file))
        {
          const std::string text =
            without_tabs(line.text.substr(0, line.text.find('$')));
          if (trimmed(text).empty())
            continue;
          auto fields      = fields_of(text);
          const char first = text[0];
          const bool goes_on =
            first == ' ' || first == '+' || first == '*' || first == ',';
          const bool is_indented =
            first == ' ' && !trimmed(text.substr(0, 8)).empty();
          if (goes_on && !is_indented && !cards.empty())
            {
              // A card in large fields has four in a line.
              Card &card = cards.back();
              card.fields.insert(card.fields.end(),
                                 fields.begin() + 1,
                                 fields.end());
              continue;
            }
          Card card{in_capitals(fields[0]),
                    {fields.begin() + 1, fields.end()},
                    line.place};
          card.name.erase(std::remove(card.name.begin(), card.name.end(), '*'),
                          card.name.end());
          card.name = trimmed(card.name);
          cards.push_back(card);
        }
      return cards;
    }

    std::string
    field(const Card &card, const std::size_t i)
    {
      return i < card.fields.size() ? card.fields[i] : "";
    }

    // Nastran's numbers may leave out the letter of their exponent: 1.5-3.
    void
    check_coordinate(const std::string &text, const TextPlace &place)
    {
      std::string number     = text;
      const std::size_t sign = number.find_last_of("+-");
      const bool has_no_letter =
        number.find_first_of("eEdD") == std::string::npos;
      if (has_no_letter && sign != std::string::npos && sign > 0)
        number.insert(sign, "e");
      if (!number.empty())
        read_real(number, place);
    }

    void
    check_node(const Card &card, const std::string &default_system)
    {
      const std::string system =
        field(card, 1).empty() ? default_system : field(card, 1);
      if (!system.empty() && system != "0")
        throw text_error(card.place,
                         "the node " + field(card, 0) +
                           " is given in the coordinate system " + system +
                           ", which springfit does not know",
                         "Write all nodes in the basic system (0), or convert "
                         "the mesh to .msh.");
    }
  } // namespace


  Announced
  announced_in_bdf(const std::filesystem::path &file)
  {
    Announced announced;
    KnownNumbers nodes("node"), elements("element");
    const auto cards           = read_cards(file);
    bool has_end               = false;
    std::string default_system = "";
    for (const Card &card : cards)
      {
        if (card.name == "INCLUDE" || card.name.rfind("INCLUDE ", 0) == 0 ||
            card.name.rfind("INCLUDE'", 0) == 0)
          throw text_error(card.place,
                           "springfit does not follow INCLUDE",
                           "Put the file in its place.");
        has_end = has_end || card.name.rfind("ENDDATA", 0) == 0;
        if (card.name == "GRDSET")
          default_system = field(card, 1);
      }
    for (const Card &card : cards)
      if (card.name == "GRID")
        {
          check_node(card, default_system);
          for (const std::size_t i : {2, 3, 4})
            check_coordinate(field(card, i), card.place);
          nodes.add(read_label(field(card, 0), card.place), card.place);
        }
    for (const Card &card : cards)
      {
        const auto type = element_types().find(card.name);
        if (type == element_types().end())
          continue;
        elements.add(read_label(field(card, 0), card.place), card.place);
        const std::string which = "element " + field(card, 0);
        const ElementType &kind = type->second;
        unsigned int n          = 0;
        while (n < kind.n_nodes_of_second_order && !field(card, n + 2).empty())
          nodes.check(read_label(field(card, n++ + 2), card.place),
                      which,
                      card.place);
        if (n < kind.n_nodes)
          throw text_error(card.place,
                           which + ", a " + card.name + ", has " +
                             std::to_string(n) + " nodes instead of " +
                             std::to_string(kind.n_nodes),
                           "The file may be cut short: write it anew.");
        ++announced.n_elements[kind.dim];
      }
    announced.n_nodes = nodes.size();
    if (!has_end)
      announced.warnings.push_back("has no ENDDATA: it may be cut short.");
    return announced;
  }
} // namespace springfit
