#include <springfit/mesh/announced.h>
#include <springfit/mesh/known_numbers.h>

#include <cstdlib>

namespace springfit
{
  namespace
  {
    // I-deas' numbers of elements: rods and beams, then plane ones, solids.
    int
    dim_of(const std::size_t type)
    {
      if (type >= 41 && type <= 96)
        return 2;
      if (type >= 101 && type <= 119)
        return 3;
      return type >= 11 && type <= 37 ? 1 : 0;
    }

    class Reader
    {
    public:
      explicit Reader(const std::filesystem::path &file)
        : lines_(read_text_lines(file)), nodes_("node"), elements_("element")
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
        announced.n_nodes = nodes_.size();
      }

      Announced announced;

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
        const bool has_nodes    = number == "2411" || number == "781";
        const bool has_elements = number == "2412" || number == "780";
        while (!ends())
          if (has_nodes)
            read_node();
          else if (has_elements)
            read_element();
          else
            line("");
      }

      void
      read_node()
      {
        const TextLine &head = line("a node");
        const auto words     = split_at_blanks(head.text);
        if (words.empty())
          throw text_error(head.place, "an empty line where a node should be");
        nodes_.add(read_label(words[0], head.place), head.place);
        const TextLine &point  = line("a node's coordinates");
        const auto coordinates = split_at_blanks(point.text);
        if (coordinates.size() < 3)
          throw text_error(point.place,
                           "the node " + words[0] + " has " +
                             std::to_string(coordinates.size()) +
                             " coordinates instead of 3");
        for (unsigned int d = 0; d < 3; ++d)
          read_real(coordinates[d], point.place);
      }

      void
      read_element()
      {
        const TextLine &head = line("an element");
        const auto words     = split_at_blanks(head.text);
        if (words.size() < 6)
          throw text_error(head.place,
                           "an element needs six numbers in its first line");
        const std::string which = "element " + words[0];
        elements_.add(read_label(words[0], head.place), head.place);
        const std::size_t type    = read_label(words[1], head.place);
        const std::size_t n_nodes = read_label(words[5], head.place);
        const bool is_beam        = type >= 21 && type <= 24;
        if (is_beam ||
            (dim_of(type) == 1 && n_nodes != 3 && next_ < lines_.size() &&
             split_at_blanks(lines_[next_].text).size() == 3))
          line("a beam's orientation");

        std::size_t n = 0;
        while (n < n_nodes)
          {
            const TextLine &nodes = line("nodes of " + which);
            const auto labels     = split_at_blanks(nodes.text);
            if (labels.empty() || labels.size() > n_nodes - n)
              throw text_error(nodes.place,
                               which +
                                 " has another number of nodes than the " +
                                 std::to_string(n_nodes) + " announced");
            for (const std::string &label : labels)
              used_.push_back(
                {read_label(label, nodes.place), which, nodes.place});
            n += labels.size();
          }
        ++announced.n_elements[dim_of(type)];
      }

    public:
      /** Nodes may stand behind the elements. */
      void
      check_nodes() const
      {
        for (const Use &use : used_)
          nodes_.check(use.node, use.which, use.place);
      }

    private:
      struct Use
      {
        std::size_t node;
        std::string which;
        TextPlace place;
      };

      std::vector<TextLine> lines_;
      std::size_t next_ = 0;
      TextPlace begin_;
      KnownNumbers nodes_, elements_;
      std::vector<Use> used_;
    };
  } // namespace


  Announced
  announced_in_unv(const std::filesystem::path &file)
  {
    Reader reader(file);
    reader.read();
    reader.check_nodes();
    return reader.announced;
  }
} // namespace springfit
