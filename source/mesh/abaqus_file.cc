#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/mesh/abaqus_file.h>

#include <gmsh.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    struct Element
    {
      std::size_t number;
      int type; // gmsh's
      std::vector<std::size_t> nodes;
      unsigned int group; // 0: none
    };

    struct AbaqusMesh
    {
      std::vector<std::size_t> nodes;
      std::vector<double> coordinates; // x, y, z of each node
      std::vector<Element> elements;

      std::vector<std::string> groups; // the name of group i is groups[i - 1]
      std::map<std::size_t, unsigned int> group_of_element; // by *ELSET
    };

    /** A line that begins with a star: its word and its settings. */
    struct Keyword
    {
      std::string word; // in capitals, as are the keys
      std::map<std::string, std::string> settings;
    };

    std::string
    in_capitals(std::string text)
    {
      for (char &c : text)
        c = std::toupper(static_cast<unsigned char>(c));
      return text;
    }

    std::string
    trimmed(const std::string &text)
    {
      const auto pieces = split_at_commas(text);
      return pieces.empty() ? "" : pieces.front();
    }

    Keyword
    parse_keyword(const std::string &line)
    {
      Keyword keyword;
      for (const std::string &piece : split_at_commas(line.substr(1)))
        {
          const auto equals = piece.find('=');
          const auto key    = in_capitals(trimmed(piece.substr(0, equals)));
          if (keyword.word.empty())
            keyword.word = key;
          else
            keyword.settings[key] = equals == std::string::npos
                                      ? ""
                                      : trimmed(piece.substr(equals + 1));
        }
      return keyword;
    }

    // Abaqus' names begin with the shape and end with letters for variants:
    // CPS4R is a quadrilateral like CPE4 and S4.
    int
    gmsh_type(const std::string &name)
    {
      static const std::map<std::string, int> types = {
        {"T2D2", 1},   {"T3D2", 1},   {"B21", 1},    {"B31", 1},   {"CPS3", 2},
        {"CPE3", 2},   {"S3", 2},     {"STRI3", 2},  {"M3D3", 2},  {"R3D3", 2},
        {"SFM3D3", 2}, {"CPS4", 3},   {"CPE4", 3},   {"S4", 3},    {"M3D4", 3},
        {"R3D4", 3},   {"SFM3D4", 3}, {"C3D4", 4},   {"C3D8", 5},  {"C3D6", 6},
        {"CPS6", 9},   {"CPE6", 9},   {"C3D10", 11}, {"CPS8", 16}, {"CPE8", 16},
        {"C3D20", 17}, {"T3D3", 8},   {"STRI65", 9}, {"S8R", 16}};
      std::string shape = in_capitals(name);
      while (!shape.empty() && types.count(shape) == 0 &&
             std::isalpha(static_cast<unsigned char>(shape.back())))
        shape.pop_back();
      const auto type = types.find(shape);
      if (type == types.end())
        throw std::invalid_argument("element type '" + name + "' is not known");
      return type->second;
    }

    struct TypeProperties
    {
      int dim;
      int n_nodes;
    };

    TypeProperties
    properties(const int gmsh_type)
    {
      static std::map<int, TypeProperties> known;
      const auto old = known.find(gmsh_type);
      if (old != known.end())
        return old->second;

      TypeProperties result;
      std::string name;
      int order, n_primary;
      std::vector<double> points;
      gmsh::model::mesh::getElementProperties(
        gmsh_type, name, result.dim, order, result.n_nodes, points, n_primary);
      return known[gmsh_type] = result;
    }

    unsigned int
    group_number(AbaqusMesh &mesh, const std::string &name)
    {
      const auto known =
        std::find(mesh.groups.begin(), mesh.groups.end(), name);
      if (known != mesh.groups.end())
        return known - mesh.groups.begin() + 1;
      mesh.groups.push_back(name);
      return mesh.groups.size();
    }

    /** Reads a file line by line; a data line belongs to the last keyword. */
    class Reader
    {
    public:
      void
      read(const std::string &line)
      {
        if (line.rfind("**", 0) == 0 || trimmed(line).empty())
          return;
        if (line.front() == '*')
          start(parse_keyword(line));
        else
          read_data(split_at_commas(line));
      }

      AbaqusMesh mesh;

    private:
      void
      start(const Keyword &keyword)
      {
        keyword_ = keyword;
        numbers_.clear();
        const auto set = keyword_.settings.find("ELSET");
        group_ =
          set == keyword_.settings.end() ? 0 : group_number(mesh, set->second);
        if (keyword_.word == "ELEMENT")
          type_ = gmsh_type(keyword_.settings["TYPE"]);
      }

      void
      read_data(const std::vector<std::string> &pieces)
      {
        if (keyword_.word == "NODE")
          {
            mesh.nodes.push_back(std::stoul(pieces.at(0)));
            for (unsigned int d = 1; d <= 3; ++d)
              mesh.coordinates.push_back(d < pieces.size() && !pieces[d].empty()
                                           ? std::stod(pieces[d])
                                           : 0.);
          }
        else if (keyword_.word == "ELEMENT")
          read_element(pieces);
        else if (keyword_.word == "ELSET")
          read_set(pieces);
      }

      // The nodes of an element may go on in the next line.
      void
      read_element(const std::vector<std::string> &pieces)
      {
        for (const std::string &piece : pieces)
          if (!piece.empty())
            numbers_.push_back(std::stoul(piece));
        const std::size_t n = properties(type_).n_nodes;
        if (numbers_.size() > n + 1)
          throw std::invalid_argument("an element has too many nodes");
        if (numbers_.size() < n + 1)
          return;
        mesh.elements.push_back({numbers_.front(),
                                 type_,
                                 {numbers_.begin() + 1, numbers_.end()},
                                 group_});
        numbers_.clear();
      }

      void
      read_set(const std::vector<std::string> &pieces)
      {
        std::vector<std::size_t> members;
        for (const std::string &piece : pieces)
          if (!piece.empty())
            members.push_back(std::stoul(piece));
        if (keyword_.settings.count("GENERATE") > 0)
          {
            const std::size_t last = members.at(1);
            const std::size_t step = members.size() > 2 ? members[2] : 1;
            if (step == 0)
              throw std::invalid_argument("a set has the step 0");
            members.resize(1);
            while (members.back() + step <= last)
              members.push_back(members.back() + step);
          }
        for (const std::size_t element : members)
          mesh.group_of_element.emplace(element, group_);
      }

      Keyword keyword_;
      int type_           = 0;
      unsigned int group_ = 0;
      std::vector<std::size_t> numbers_;
    };

    void
    check_nodes(const AbaqusMesh &mesh)
    {
      std::vector<std::size_t> nodes = mesh.nodes;
      std::sort(nodes.begin(), nodes.end());
      for (const Element &element : mesh.elements)
        for (const std::size_t node : element.nodes)
          if (!std::binary_search(nodes.begin(), nodes.end(), node))
            throw std::invalid_argument(
              "element " + std::to_string(element.number) + " has the node " +
              std::to_string(node) + ", which is not defined");
    }

    // A group of elements of several types has several entities.
    void
    add_to_group(const int dim,
                 const int entity,
                 const int group,
                 const std::string &name)
    {
      std::vector<int> members = {entity};
      gmsh::vectorpair groups;
      gmsh::model::getPhysicalGroups(groups, dim);
      if (std::find(groups.begin(), groups.end(), std::pair(dim, group)) !=
          groups.end())
        {
          std::vector<int> old;
          gmsh::model::getEntitiesForPhysicalGroup(dim, group, old);
          members.insert(members.end(), old.begin(), old.end());
          gmsh::model::removePhysicalGroups({{dim, group}});
        }
      gmsh::model::addPhysicalGroup(dim, members, group);
      gmsh::model::setPhysicalName(dim, group, name);
    }

    void
    add_block(const std::vector<const Element *> &elements, const int entity)
    {
      const int type = elements.front()->type;
      std::vector<std::size_t> numbers, nodes;
      for (const Element *element : elements)
        {
          numbers.push_back(element->number);
          nodes.insert(nodes.end(),
                       element->nodes.begin(),
                       element->nodes.end());
        }
      gmsh::model::addDiscreteEntity(properties(type).dim, entity);
      gmsh::model::mesh::addElementsByType(entity, type, numbers, nodes);
    }

    void
    fill_gmsh(const AbaqusMesh &mesh)
    {
      // Elements of the same group and type, each for one entity of gmsh.
      std::map<std::pair<unsigned int, int>, std::vector<const Element *>>
        blocks;
      int dim = 0;
      for (const Element &element : mesh.elements)
        {
          const auto set = mesh.group_of_element.find(element.number);
          const unsigned int group =
            set == mesh.group_of_element.end() ? element.group : set->second;
          blocks[{group, element.type}].push_back(&element);
          dim = std::max(dim, properties(element.type).dim);
        }
      if (blocks.empty())
        return;

      int entity = 1; // holds the nodes
      gmsh::model::addDiscreteEntity(dim, entity);
      gmsh::model::mesh::addNodes(dim, entity, mesh.nodes, mesh.coordinates);
      for (const auto &[group_and_type, elements] : blocks)
        {
          const auto &[group, type] = group_and_type;
          add_block(elements, ++entity);
          if (group > 0)
            add_to_group(properties(type).dim,
                         entity,
                         group,
                         mesh.groups[group - 1]);
        }
    }
  } // namespace


  void
  open_abaqus_file(const std::filesystem::path &file)
  {
    std::ifstream stream(file);
    Reader reader;
    std::string line;
    unsigned int n_lines = 0;
    try
      {
        while (std::getline(stream, line))
          {
            ++n_lines;
            if (!line.empty() && line.back() == '\r')
              line.pop_back();
            reader.read(line);
          }
        check_nodes(reader.mesh);
      }
    catch (const std::logic_error &error) // of stoul, stod, at and this file
      {
        throw InputError("Mesh file '" + file.string() + "', line " +
                           std::to_string(n_lines) + ", cannot be read (" +
                           error.what() + ").",
                         "Mend it, or convert it to .msh.");
      }
    fill_gmsh(reader.mesh);
  }
} // namespace springfit
