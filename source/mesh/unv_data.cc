#include <springfit/mesh/unv_data.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <system_error>

namespace springfit
{
  namespace
  {
    // I-deas' numbers of elements: rods and beams, then plane ones, solids.
    // Others are springs, masses, rigid links and gaps, which have no shape.
    int
    dim_of(const std::size_t type)
    {
      if (type >= 41 && type <= 96)
        return 2;
      if (type >= 101 && type <= 119)
        return 3;
      return type >= 11 && type <= 37 ? 1 : 0;
    }

    /** The number of nodes of the types whose nodes are their corners. */
    std::size_t
    n_corners(const std::size_t type)
    {
      static const std::set<std::size_t> triangles = {41, 51, 61, 74, 81, 91},
                                         quadrilaterals = {
                                           44, 54, 64, 71, 84, 94};
      if (triangles.count(type) > 0)
        return 3;
      if (quadrilaterals.count(type) > 0 || type == 111)
        return 4;
      return type == 112 ? 6 : type == 115 ? 8 : 0;
    }

    long
    read_integer(const std::string &text, const TextPlace &place)
    {
      long value            = 0;
      const char *const end = text.data() + text.size();
      const auto result     = std::from_chars(text.data(), end, value);
      if (result.ec != std::errc() || result.ptr != end)
        throw text_error(place, "'" + text.substr(0, 60) + "' is no integer");
      return value;
    }

    class Reader
    {
    public:
      explicit Reader(const std::filesystem::path &file)
        : lines_(read_text_lines(file))
      {}

      void
      read()
      {
        while (next_ < lines_.size())
          {
            const std::string text = trimmed(lines_[next_++].text);
            if (text.empty())
              continue;
            if (text != "-1")
              throw text_error(lines_[next_ - 1].place,
                               "'" + text.substr(0, 60) +
                                 "' stands where a data set should begin with "
                                 "-1");
            begin_ = lines_[next_ - 1].place;
            read_set(trimmed(line("its number").text));
          }
      }

      UnvData data;

    private:
      const TextLine &
      line(const std::string &what)
      {
        if (next_ >= lines_.size())
          throw text_error(begin_,
                           "the file ends before the data set that begins "
                           "here does, where " +
                             what + " should come",
                           "It may be cut short: write it anew.");
        return lines_[next_++];
      }

      bool
      ends()
      {
        if (trimmed(line("-1").text) == "-1")
          return true;
        --next_;
        return false;
      }

      void
      read_set(const std::string &number)
      {
        static const std::set<std::string> of_groups = {
          "2417", "2429", "2430", "2432", "2435", "2452", "2467", "2477"};
        static const std::set<std::string> without_mesh = {"151", "164"};
        const bool has_nodes    = number == "2411" || number == "781";
        const bool has_elements = number == "2412" || number == "780";
        const bool has_bins     = number == "780";
        const bool has_systems  = number == "2420";
        const bool has_groups   = of_groups.count(number) > 0;
        unsigned int n_lines    = 0;
        if (has_systems && !ends())
          {
            line("the number of a part");
            line("the name of a part");
          }
        while (!ends())
          if (has_nodes)
            read_node();
          else if (number == "15")
            read_node_of_one_line();
          else if (has_elements)
            read_element(has_bins);
          else if (has_systems)
            read_system();
          else if (has_groups)
            read_group(number < "2435" ? 2 : 4);
          else
            {
              const TextLine &row = line("");
              if (number == "164" && ++n_lines == 2)
                read_unit(row);
              else if (without_mesh.count(number) == 0)
                data.ignored.insert(number);
            }
      }

      // By how much lengths, forces and temperatures of the file are more than
      // in SI.
      void
      read_unit(const TextLine &factors)
      {
        const auto values = split_at_blanks(factors.text);
        if (values.empty() || !(read_real(values[0], factors.place) > 0.))
          throw text_error(factors.place, "the unit of lengths is not above 0");
        data.unit = 1. / read_real(values[0], factors.place);
      }

      // Three lines of the axes and one of the origin follow the name.
      void
      read_system()
      {
        const TextLine &head = line("a coordinate system");
        const auto words     = split_at_blanks(head.text);
        if (words.size() < 2)
          throw text_error(head.place,
                           "a coordinate system needs a number and a type");
        bool is_basic = read_integer(words[1], head.place) == 0;
        line("the name of a coordinate system");
        for (unsigned int i = 0; i < 4; ++i)
          {
            const TextLine &row = line("an axis of a coordinate system");
            const auto values   = split_at_blanks(row.text);
            if (values.size() != 3)
              throw text_error(row.place, "an axis needs three numbers");
            for (unsigned int j = 0; j < 3; ++j)
              is_basic = is_basic &&
                         read_real(values[j], row.place) == (i == j ? 1. : 0.);
          }
        if (!is_basic)
          other_systems_.insert(words[0]);
      }

      void
      read_node()
      {
        const TextLine &head = line("a node");
        const auto words     = split_at_blanks(head.text);
        if (words.size() != 4)
          throw text_error(head.place,
                           "a node needs four numbers in its first line");
        for (const std::string &word : words)
          read_integer(word, head.place);
        const TextLine &line_of_point = line("a node's coordinates");
        add_node(words,
                 head.place,
                 split_at_blanks(line_of_point.text),
                 line_of_point.place);
      }

      void
      read_node_of_one_line()
      {
        const TextLine &row  = line("a node");
        const auto words     = split_at_blanks(row.text);
        const auto n_numbers = std::min<std::size_t>(words.size(), 4);
        add_node({words.begin(), words.begin() + n_numbers},
                 row.place,
                 {words.begin() + n_numbers, words.end()},
                 row.place);
      }

      /** @p numbers of the node, its systems and its colour. */
      void
      add_node(const std::vector<std::string> &numbers,
               const TextPlace &place,
               const std::vector<std::string> &coordinates,
               const TextPlace &place_of_point)
      {
        if (coordinates.size() != 3)
          throw text_error(place_of_point,
                           "the node " + numbers[0] + " has " +
                             std::to_string(coordinates.size()) +
                             " coordinates instead of 3");
        if (other_systems_.count(numbers[1]) > 0)
          throw text_error(place,
                           "the node " + numbers[0] +
                             " is given in the coordinate system " +
                             numbers[1] + ", which springfit does not know",
                           "Write all nodes in the basic system, or convert "
                           "the mesh to .msh.");
        MeshPoint point;
        for (unsigned int d = 0; d < 3; ++d)
          point[d] = read_real(coordinates[d], place_of_point);
        data.nodes.push_back({read_label(numbers[0], place), point, place});
      }

      // A number, a type, those of the property and the material, each behind
      // that of its bin in older files, a colour, and how many nodes there are.
      void
      read_element(const bool has_bins)
      {
        const TextLine &head = line("an element");
        const auto words     = split_at_blanks(head.text);
        if (words.size() != (has_bins ? 8 : 6))
          throw text_error(head.place,
                           std::string("an element needs ") +
                             (has_bins ? "eight" : "six") +
                             " numbers in its first line");
        for (const std::string &word : words)
          read_integer(word, head.place);
        UnvElement element;
        element.place    = head.place;
        element.number   = read_label(words[0], head.place);
        element.type     = read_label(words[1], head.place);
        element.dim      = dim_of(element.type);
        element.property = read_integer(words[has_bins ? 3 : 2], head.place);
        element.material = read_integer(words[has_bins ? 5 : 3], head.place);
        const std::size_t n_nodes = read_label(words.back(), head.place);
        const std::string which   = "element " + words[0];

        const bool is_beam = element.type >= 21 && element.type <= 24;
        if (is_beam ||
            (element.dim == 1 && n_nodes != 3 && next_ < lines_.size() &&
             split_at_blanks(lines_[next_].text).size() == 3))
          line("a beam's orientation");
        while (element.nodes.size() < n_nodes)
          {
            const TextLine &nodes = line("nodes of " + which);
            const auto labels     = split_at_blanks(nodes.text);
            if (labels.empty() ||
                labels.size() > n_nodes - element.nodes.size())
              throw text_error(nodes.place,
                               which +
                                 " has another number of nodes than the " +
                                 std::to_string(n_nodes) + " announced");
            for (const std::string &label : labels)
              element.nodes.push_back(read_label(label, nodes.place));
          }
        if (n_corners(element.type) > 0 && n_corners(element.type) != n_nodes)
          throw text_error(head.place,
                           which + " of type " + words[1] + " has " +
                             words.back() + " nodes instead of " +
                             std::to_string(n_corners(element.type)));
        if (element.dim == 0)
          ++data.n_shapeless[element.type];
        else
          data.elements.push_back(element);
      }

      // A head whose last number is how many members there are, a name, and of
      // each member its type, its number and, in newer sets, two more.
      void
      read_group(const unsigned int n_words)
      {
        const TextLine &head = line("a group");
        const auto words     = split_at_blanks(head.text);
        if (words.size() < 2)
          throw text_error(head.place,
                           "a group needs its number and that of its members");
        UnvGroup group;
        const long number = read_integer(words[0], head.place);
        const long n      = read_integer(words.back(), head.place);
        if (n < 0)
          throw text_error(head.place,
                           "a group announces fewer than 0 members");
        group.number = checked_id(number, "the group", head.place);
        group.name   = trimmed(line("the name of a group").text);
        while (group.members.size() < std::size_t(n))
          {
            const TextLine &row      = line("a member of '" + group.name + "'");
            const auto values        = split_at_blanks(row.text);
            const std::size_t n_here = values.size() / n_words;
            if (values.empty() || values.size() % n_words != 0 ||
                n_here > n - group.members.size())
              throw text_error(row.place,
                               "the group '" + group.name +
                                 "' has another number of members than the " +
                                 std::to_string(n) + " announced");
            for (std::size_t i = 0; i < values.size(); i += n_words)
              {
                const long kind = read_integer(values[i], row.place);
                if (kind == 7 || kind == 8)
                  group.members.push_back(
                    {kind == 7, read_label(values[i + 1], row.place)});
                else
                  throw text_error(row.place,
                                   "the group '" + group.name +
                                     "' has a member of the kind " + values[i],
                                   "Members may be nodes (7) or elements (8).");
              }
          }
        data.groups.push_back(group);
      }

      std::vector<TextLine> lines_;
      std::size_t next_ = 0;
      TextPlace begin_;
      std::set<std::string> other_systems_;
    };
  } // namespace


  UnvData
  read_unv_data(const std::filesystem::path &file)
  {
    Reader reader(file);
    reader.read();
    return std::move(reader.data);
  }
} // namespace springfit
