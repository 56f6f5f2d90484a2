#include <springfit/core/error.h>
#include <springfit/mesh/announced.h>
#include <springfit/mesh/announced_msh_binary.h>
#include <springfit/mesh/gmsh_element_types.h>
#include <springfit/mesh/known_numbers.h>
#include <springfit/mesh/msh_head.h>
#include <springfit/mesh/text_tokens.h>

#include <array>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  namespace
  {
    class Reader
    {
    public:
      Reader(const std::filesystem::path &file, const std::string &version)
        : tokens_(file), version_(version), nodes_("node"), elements_("element")
      {}

      /** False if there is something that is not known here. */
      bool
      read()
      {
        while (!tokens_.at_end())
          {
            const std::string word = tokens_.next("");
            if (word[0] != '$')
              throw text_error(tokens_.place(),
                               "'" + word.substr(0, 60) +
                                 "' stands outside of all sections",
                               "The count before it may be too small.");
            if (!read_section(word.substr(1)))
              return false;
          }
        announced.n_nodes = nodes_.size();
        return true;
      }

      Announced announced;

    private:
      bool
      read_section(const std::string &section)
      {
        std::string end = "$End" + section;
        if (section == "NOD")
          end = "$ENDNOD";
        if (section == "ELM")
          end = "$ENDELM";
        if (section == "ParametricNodes")
          return false;
        if (section == "NOD" || section == "Nodes")
          version_[0] == '4' ? read_node_blocks() : read_nodes();
        else if (section == "ELM" || section == "Elements")
          {
            if (!(version_[0] == '4' ? read_element_blocks() : read_elements()))
              return false;
          }
        else if (section == "PhysicalNames")
          read_names();
        else if (section == "Entities" && version_[0] == '4')
          read_entities();
        else
          {
            while (!tokens_.at_end() && tokens_.peek() != end)
              tokens_.next("");
          }
        const std::string found = tokens_.next(end);
        if (found != end)
          throw text_error(tokens_.place(),
                           "'" + found.substr(0, 60) + "' stands where '" +
                             end + "' should",
                           "The count at the beginning of the section may be "
                           "wrong.");
        return true;
      }

      void
      read_names()
      {
        const std::size_t n = tokens_.count("the number of names");
        for (std::size_t i = 0; i < n; ++i)
          {
            const std::string what = which("name", i, n);
            tokens_.count(what);
            read_tag(what);
            tokens_.skip_line();
          }
      }

      static std::string
      which(const std::string &what, const std::size_t i, const std::size_t n)
      {
        return what + ' ' + std::to_string(i + 1) + " of the " +
               std::to_string(n) + " announced";
      }

      /** Of a group or an entity; gmsh keeps it in 32 bits. */
      void
      read_tag(const std::string &what)
      {
        const long tag = tokens_.integer(what);
        checked_id(std::abs(tag), "the number", tokens_.place());
      }

      // Of each point, curve, surface and volume its number, the corners of its
      // box, the numbers of its groups, and of what it is bounded by.
      void
      read_entities()
      {
        std::array<std::size_t, 4> n;
        for (std::size_t &of_dim : n)
          of_dim = tokens_.count("a number of entities");
        for (unsigned int dim = 0; dim < 4; ++dim)
          for (std::size_t i = 0; i < n[dim]; ++i)
            {
              const std::string what = which("entity", i, n[dim]) +
                                       " of dimension " + std::to_string(dim);
              read_tag(what);
              const unsigned int n_reals = dim == 0 && !is_4_0() ? 3 : 6;
              for (unsigned int d = 0; d < n_reals; ++d)
                tokens_.next(what);
              for (unsigned int list = 0; list < (dim == 0 ? 1 : 2); ++list)
                {
                  const std::size_t n_tags = tokens_.count(what);
                  for (std::size_t t = 0; t < n_tags; ++t)
                    read_tag(what);
                }
            }
      }

      void
      read_point(const std::string &what)
      {
        for (unsigned int d = 0; d < 3; ++d)
          tokens_.real("a coordinate of " + what);
      }

      void
      read_nodes()
      {
        const std::size_t n = tokens_.count("the number of nodes");
        for (std::size_t i = 0; i < n; ++i)
          {
            const std::string what = which("node", i, n);
            nodes_.add(tokens_.count(what), tokens_.place());
            read_point(what);
          }
      }

      bool
      is_4_0() const
      {
        return version_ == "4" || version_ == "4.0";
      }

      /** The numbers of blocks and of what is in them all. */
      std::pair<std::size_t, std::size_t>
      read_head_of_blocks(const std::string &what)
      {
        const std::size_t n_blocks = tokens_.count("the number of blocks");
        const std::size_t n        = tokens_.count("the number of " + what);
        if (!is_4_0())
          tokens_.skip_line(); // the smallest and the largest number
        return {n_blocks, n};
      }

      /** @throws InputError when the blocks hold another number than announced.
       */
      void
      check_blocks(const std::size_t n_announced,
                   const std::size_t n_found,
                   const std::string &what) const
      {
        if (n_found != n_announced)
          throw text_error(tokens_.place(),
                           "the section announces " +
                             std::to_string(n_announced) + ' ' + what +
                             ", its blocks hold " + std::to_string(n_found));
      }

      void
      read_node_blocks()
      {
        const auto [n_blocks, n] = read_head_of_blocks("nodes");
        std::size_t i            = 0;
        for (std::size_t b = 0; b < n_blocks; ++b)
          {
            const std::string block = which("block", b, n_blocks);
            tokens_.integer(block);
            tokens_.integer(block);
            const bool is_parametric = tokens_.count(block) > 0;
            const std::size_t size   = tokens_.count(block);
            if (is_4_0())
              for (std::size_t k = 0; k < size; ++k, ++i)
                {
                  nodes_.add(tokens_.count(which("node", i, n)),
                             tokens_.place());
                  read_point(which("node", i, n));
                  skip_parameters(is_parametric);
                }
            else
              {
                for (std::size_t k = 0; k < size; ++k)
                  nodes_.add(tokens_.count(which("node", i + k, n)),
                             tokens_.place());
                for (std::size_t k = 0; k < size; ++k, ++i)
                  {
                    read_point(which("node", i, n));
                    skip_parameters(is_parametric);
                  }
              }
          }
        check_blocks(n, i, "nodes");
      }

      // As many as the dimension of the block, on the point's line.
      void
      skip_parameters(const bool is_parametric)
      {
        if (is_parametric)
          tokens_.skip_line();
      }

      bool
      read_elements()
      {
        const std::size_t n = tokens_.count("the number of elements");

        for (std::size_t i = 0; i < n; ++i)
          {
            const std::string what    = which("element", i, n);
            const std::size_t element = tokens_.count(what);
            const TextPlace place     = tokens_.place();
            const auto number         = tokens_.integer(what);
            const auto type = find_gmsh_element_type(number, what, place);
            if (type == nullptr)
              return false;
            if (version_ == "1")
              {
                read_tag(what);
                read_tag(what);
                if (tokens_.count(what) != type->n_nodes)
                  throw text_error(tokens_.place(),
                                   what +
                                     " has another number of nodes than its "
                                     "type");
              }
            else
              {
                const std::size_t n_tags = tokens_.count(what);
                for (std::size_t t = 0; t < n_tags; ++t)
                  read_tag(what);
              }
            elements_.add(element, place);
            read_nodes_of(element, *type);
          }
        return true;
      }

      bool
      read_element_blocks()
      {
        const auto [n_blocks, n] = read_head_of_blocks("elements");
        std::size_t i            = 0;
        for (std::size_t b = 0; b < n_blocks; ++b)
          {
            const std::string block = which("block", b, n_blocks);
            read_tag(block);
            read_tag(block);
            const auto number = tokens_.integer(block);
            const auto type =
              find_gmsh_element_type(number, block, tokens_.place());
            if (type == nullptr)
              return false;
            const std::size_t size = tokens_.count(block);
            for (std::size_t k = 0; k < size; ++k, ++i)
              {
                const std::size_t element =
                  tokens_.count(which("element", i, n));
                elements_.add(element, tokens_.place());
                read_nodes_of(element, *type);
              }
          }
        check_blocks(n, i, "elements");
        return true;
      }

      void
      read_nodes_of(const std::size_t element, const GmshElementType &type)
      {
        const std::string what = "element " + std::to_string(element);
        for (unsigned int i = 0; i < type.n_nodes; ++i)
          {
            const std::size_t node = tokens_.count("a node of " + what);
            nodes_.check(node, what, tokens_.place());
          }
        ++announced.n_elements[type.dim];
      }

      TextTokens tokens_;
      const std::string version_;
      KnownNumbers nodes_, elements_;
    };
  } // namespace


  std::optional<Announced>
  announced_in_msh(const std::filesystem::path &file)
  {
    const MshHead head = read_msh_head(file);
    if (head.version.empty())
      throw InputError("Mesh file '" + file.string() +
                         "' has neither $MeshFormat nor, as of version 1, "
                         "$NOD.",
                       "Write it anew.");
    static const std::set<std::string> known = {
      "1", "2", "2.0", "2.1", "2.2", "4", "4.0", "4.1"};
    if (known.count(head.version) == 0)
      return {};
    if (head.is_binary && head.version[0] == '4' && head.version != "4.1")
      return {}; // gmsh 4.8 refuses it
    if (head.is_binary)
      return announced_in_binary_msh(file, head.version);
    Reader reader(file, head.version);
    if (!reader.read())
      return {};
    return reader.announced;
  }
} // namespace springfit
