#include <springfit/mesh/announced_msh_binary.h>
#include <springfit/mesh/gmsh_element_types.h>
#include <springfit/mesh/known_numbers.h>
#include <springfit/mesh/mesh_text.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>

namespace springfit
{
  namespace
  {
    enum class Layout
    {
      version_2,
      version_4_1
    };

    class Reader
    {
    public:
      Reader(const std::filesystem::path &file, const Layout layout)
        : layout_(layout), nodes_("node"), elements_("element")
      {
        std::ifstream stream(file, std::ios::binary);
        content_.assign(std::istreambuf_iterator<char>(stream), {});
        place_ = {std::make_shared<const std::string>(file.string()), 0};
      }

      /** False if there is something that is not known here. */
      bool
      read()
      {
        for (std::string word; !(word = next_word()).empty();)
          if (word == "$Nodes")
            {
              layout_ == Layout::version_2 ? read_nodes() : read_node_blocks();
              expect("$EndNodes");
            }
          else if (word == "$Elements")
            {
              if (!(layout_ == Layout::version_2 ? read_elements()
                                                 : read_element_blocks()))
                return false;
              expect("$EndElements");
            }
          else if (word == "$MeshFormat")
            {
              skip_line();
              skip_line(); // the version
              if (number<std::int32_t>("the order of bytes") != 1)
                return false;
              expect("$EndMeshFormat");
            }
          else if (word == "$PhysicalNames")
            {
              const std::size_t n = count_in_text("names");
              for (std::size_t i = 0; i < n && at_ < content_.size(); ++i)
                skip_line();
              expect("$EndPhysicalNames");
            }
          else if (word == "$ParametricNodes")
            return false;
          else if (word[0] == '$')
            skip_to("$End" + word.substr(1));
          else
            throw error("'" + word.substr(0, 60) +
                        "' stands outside of all sections");
        announced.n_nodes = nodes_.size();
        return true;
      }

      Announced announced;

    private:
      InputError
      error(const std::string &what) const
      {
        return text_error(place_,
                          what,
                          "A count before it may be wrong, or the file cut "
                          "short: write it anew.");
      }

      std::string
      next_word()
      {
        const char *const blanks = " \t\r\n";
        const auto begin         = content_.find_first_not_of(blanks, at_);
        if (begin == std::string::npos)
          return "";
        at_ = std::min(content_.find_first_of(blanks, begin), content_.size());
        return content_.substr(begin, at_ - begin);
      }

      void
      skip_line()
      {
        at_ = std::min(content_.find('\n', at_), content_.size() - 1) + 1;
      }

      void
      expect(const std::string &word)
      {
        const std::string found = next_word();
        if (found == word)
          return;
        const bool is_text =
          found.find_first_not_of("$abcdefghijklmnopqrstuvwxyz"
                                  "ABCDEFGHIJKLMNOPQRSTUVWXYZ") ==
          std::string::npos;
        throw error(found.empty()
                      ? "the file ends before '" + word + "'"
                      : (is_text ? "'" + found.substr(0, 60) + "' stands"
                                 : "something else stands") +
                          " where '" + word + "' should");
      }

      void
      skip_to(const std::string &word)
      {
        const auto place = content_.find(word, at_);
        if (place == std::string::npos)
          throw error("the file ends before '" + word + "'");
        at_ = place + word.size();
      }

      template <typename Number>
      Number
      number(const std::string &what)
      {
        Number value;
        if (content_.size() - at_ < sizeof value)
          throw error("the file ends before " + what);
        std::memcpy(&value, content_.data() + at_, sizeof value);
        at_ += sizeof value;
        return value;
      }

      /** A count that stands as text on the first line of a section. */
      std::size_t
      count_in_text(const std::string &what)
      {
        const std::string word = next_word();
        skip_line();
        if (word.empty() || word.size() > 15 ||
            word.find_first_not_of("0123456789") != std::string::npos)
          throw error("'" + word.substr(0, 60) + "' is no count of " + what);
        return std::stoul(word);
      }

      static std::string
      which(const std::string &what, const std::size_t i, const std::size_t n)
      {
        return what + ' ' + std::to_string(i + 1) + " of the " +
               std::to_string(n) + " announced";
      }

      void
      read_point(const std::string &what)
      {
        for (unsigned int d = 0; d < 3; ++d)
          if (!std::isfinite(number<double>(what)))
            throw error(what + " has a coordinate that is not finite");
      }

      void
      read_nodes()
      {
        const std::size_t n = count_in_text("nodes");
        for (std::size_t i = 0; i < n; ++i)
          {
            const std::string what = which("node", i, n);
            nodes_.add(number<std::int32_t>(what), place_);
            read_point(what);
          }
      }

      struct HeadOfBlocks
      {
        std::size_t n_blocks, n;
      };

      HeadOfBlocks
      read_head_of_blocks(const std::string &what)
      {
        skip_line();
        const auto n_blocks =
          number<std::uint64_t>("the number of blocks of " + what);
        const auto n = number<std::uint64_t>("the number of " + what);
        for (unsigned int i = 0; i < 2; ++i)
          number<std::uint64_t>("the smallest and largest number");
        return {n_blocks, n};
      }

      struct HeadOfBlock
      {
        int dim, flag; // "parametric" or the type of element
        std::size_t n;
      };

      HeadOfBlock
      read_head_of_block(const std::string &what)
      {
        const auto dim = number<std::int32_t>(what);
        number<std::int32_t>(what); // of the entity
        const auto flag = number<std::int32_t>(what);
        const auto n    = number<std::uint64_t>(what);
        return {dim, flag, n};
      }

      std::size_t
      read_number(const std::string &what)
      {
        return layout_ == Layout::version_4_1 ? number<std::uint64_t>(what)
                                              : number<std::int32_t>(what);
      }

      void
      check_blocks(const std::size_t n_announced,
                   const std::size_t n_found,
                   const std::string &what) const
      {
        if (n_found != n_announced)
          throw error("the section announces " + std::to_string(n_announced) +
                      ' ' + what + ", its blocks hold " +
                      std::to_string(n_found));
      }

      void
      read_node_blocks()
      {
        const HeadOfBlocks head = read_head_of_blocks("nodes");
        std::size_t i           = 0;
        for (std::size_t b = 0; b < head.n_blocks; ++b)
          {
            const HeadOfBlock block =
              read_head_of_block(which("block of nodes", b, head.n_blocks));
            if (block.dim < 0 || block.dim > 3)
              throw error("a block of nodes has the dimension " +
                          std::to_string(block.dim));
            for (std::size_t k = 0; k < block.n; ++k)
              nodes_.add(read_number(which("node", i + k, head.n)), place_);
            for (std::size_t k = 0; k < block.n; ++k, ++i)
              {
                const std::string what = which("node", i, head.n);
                read_point(what);
                for (int d = 0; block.flag != 0 && d < block.dim; ++d)
                  number<double>(what);
              }
          }
        check_blocks(head.n, i, "nodes");
      }

      void
      read_nodes_of(const std::size_t element, const GmshElementType &type)
      {
        const std::string what = "the element " + std::to_string(element);
        for (unsigned int i = 0; i < type.n_nodes; ++i)
          nodes_.check(read_number("a node of " + what), what, place_);
        ++announced.n_elements[type.dim];
      }

      bool
      read_elements()
      {
        const std::size_t n = count_in_text("elements");
        for (std::size_t i = 0; i < n;)
          {
            const std::string what = which("element", i, n);
            const auto type_number = number<std::int32_t>(what);
            const auto n_in_block  = number<std::int32_t>(what);
            const auto n_tags      = number<std::int32_t>(what);
            const auto type = find_gmsh_element_type(type_number, what, place_);
            if (type == nullptr)
              return false;
            if (n_in_block < 1 || std::size_t(n_in_block) > n - i)
              throw error("a block holds " + std::to_string(n_in_block) +
                          " elements, of the " + std::to_string(n) +
                          " announced " + std::to_string(n - i) + " are left");
            for (std::int32_t k = 0; k < n_in_block; ++k, ++i)
              {
                const std::size_t element = read_number(which("element", i, n));
                elements_.add(element, place_);
                for (std::int32_t t = 0; t < n_tags; ++t)
                  number<std::int32_t>(which("element", i, n));
                read_nodes_of(element, *type);
              }
          }
        return true;
      }

      bool
      read_element_blocks()
      {
        const HeadOfBlocks head = read_head_of_blocks("elements");
        std::size_t i           = 0;
        for (std::size_t b = 0; b < head.n_blocks; ++b)
          {
            const std::string what =
              which("block of elements", b, head.n_blocks);
            const HeadOfBlock block = read_head_of_block(what);
            const auto type = find_gmsh_element_type(block.flag, what, place_);
            if (type == nullptr)
              return false;
            for (std::size_t k = 0; k < block.n; ++k, ++i)
              {
                const std::size_t element =
                  read_number(which("element", i, head.n));
                elements_.add(element, place_);
                read_nodes_of(element, *type);
              }
          }
        check_blocks(head.n, i, "elements");
        return true;
      }

      const Layout layout_;
      std::string content_;
      std::size_t at_ = 0;
      TextPlace place_;
      KnownNumbers nodes_, elements_;
    };
  } // namespace


  std::optional<Announced>
  announced_in_binary_msh(const std::filesystem::path &file,
                          const std::string &version)
  {
    Reader reader(file,
                  version == "4.1" ? Layout::version_4_1 : Layout::version_2);
    if (!reader.read())
      return {};
    return reader.announced;
  }
} // namespace springfit
