#include <springfit/mesh/file_elements.h>
#include <springfit/mesh/medit_file.h>
#include <springfit/mesh/text_tokens.h>

#include <cctype>
#include <map>
#include <set>

namespace springfit
{
  namespace
  {
    const std::map<std::string, FileElements> &
    element_types()
    {
      static const std::map<std::string, FileElements> types = {
        {"Edges", {"Edges", 1, 2, {}, {}, {}, {}}},
        {"Triangles", {"Triangles", 2, 3, CellKind::triangle, {}, {}, {}}},
        {"Quadrilaterals",
         {"Quadrilaterals", 2, 4, CellKind::quadrilateral, {}, {}, {}}},
        {"Tetrahedra", {"Tetrahedra", 3, 4, CellKind::tetrahedron, {}, {}, {}}},
        {"Hexahedra", {"Hexahedra", 3, 8, CellKind::hexahedron, {}, {}, {}}},
        {"Hexaedra", {"Hexaedra", 3, 8, CellKind::hexahedron, {}, {}, {}}},
        {"Prisms", {"Prisms", 3, 6, {}, {}, {}, {}}},
        {"Pentahedra", {"Pentahedra", 3, 6, {}, {}, {}, {}}},
        {"Pyramids", {"Pyramids", 3, 5, {}, {}, {}, {}}}};
      return types;
    }

    /** Of a keyword, whatever its case; none if it names no elements. */
    const FileElements *
    find_element_type(const std::string &keyword)
    {
      for (const auto &[name, type] : element_types())
        if (in_capitals(name) == keyword)
          return &type;
      return nullptr;
    }

    bool
    is_keyword(const std::string &word)
    {
      return std::isalpha(static_cast<unsigned char>(word[0])) &&
             word != "nan" && word != "inf";
    }

    class Reader
    {
    public:
      explicit Reader(const std::filesystem::path &file) : tokens_(file, '#')
      {}

      void
      read()
      {
        while (!tokens_.at_end())
          {
            const std::string word = tokens_.next("a keyword");
            if (in_capitals(word) == "END")
              {
                has_end = true;
                return;
              }
            read_section(word);
          }
      }

      std::vector<MeshPoint> points;
      std::map<std::string, FileElements> elements;
      std::set<std::string> ignored;
      bool has_end = false;

    private:
      void
      read_section(const std::string &word)
      {
        if (!is_keyword(word))
          throw text_error(tokens_.place(),
                           "'" + word.substr(0, 60) +
                             "' stands where a keyword should",
                           "The count before it may be too small, or a line "
                           "too long.");
        const std::string keyword      = in_capitals(word);
        const FileElements *const type = find_element_type(keyword);
        if (keyword == "MESHVERSIONFORMATTED")
          tokens_.count("a version");
        else if (keyword == "DIMENSION")
          read_dimension();
        else if (keyword == "VERTICES")
          read_vertices();
        else if (type != nullptr)
          read_elements(*type);
        else
          {
            ignored.insert(word);
            while (!tokens_.at_end() && !is_keyword(tokens_.peek()))
              tokens_.next("");
          }
      }

      void
      read_dimension()
      {
        dim_ = tokens_.count("the dimension");
        if (dim_ != 2 && dim_ != 3)
          throw text_error(tokens_.place(), "the dimension is neither 2 nor 3");
      }

      void
      read_vertices()
      {
        const std::size_t n = tokens_.count("the number of vertices");
        for (std::size_t v = 0; v < n; ++v)
          {
            MeshPoint point{};
            const std::string what = "vertex " + std::to_string(v + 1) +
                                     " of the " + std::to_string(n) +
                                     " announced";
            for (std::size_t d = 0; d < dim_; ++d)
              point[d] = tokens_.real(what);
            tokens_.integer("the reference of " + what);
            points.push_back(point);
          }
      }

      void
      read_elements(const FileElements &type)
      {
        FileElements &of_type = elements.emplace(type.type, type).first->second;
        const std::size_t n   = tokens_.count("the number of " + type.type);
        for (std::size_t e = 0; e < n; ++e)
          {
            const std::string what = "number " + std::to_string(e + 1) +
                                     " of the " + std::to_string(n) + ' ' +
                                     type.type + " announced";
            for (unsigned int i = 0; i < of_type.n_nodes; ++i)
              {
                const std::size_t node = tokens_.count(what);
                if (node < 1 || node > points.size())
                  throw text_error(tokens_.place(),
                                   what + " has the vertex " +
                                     std::to_string(node) +
                                     ", which is not there",
                                   "Vertices are numbered from 1 and stand "
                                   "before the cells.");
                of_type.nodes.push_back(node - 1);
              }
            const long id = tokens_.integer("the reference of " + what);
            of_type.ids.push_back(
              checked_id(id, "the reference", tokens_.place()));
            of_type.numbers.push_back(of_type.numbers.size() + 1);
          }
      }

      TextTokens tokens_;
      std::size_t dim_ = 3;
    };
  } // namespace


  MeshDescription
  read_medit_file(const std::filesystem::path &file,
                  const std::string &name,
                  const int dim)
  {
    Reader reader(file);
    reader.read();
    std::vector<FileElements> elements;
    for (const auto &[word, of_type] : reader.elements)
      elements.push_back(of_type);
    MeshOfElements result =
      mesh_of_elements(name, dim, reader.points, elements);
    label_sides(result, elements);
    MeshDescription &mesh = result.mesh;
    if (!reader.has_end)
      mesh.warnings.push_back(name + " has no 'End': it may be cut short.");
    if (!reader.ignored.empty())
      mesh.warnings.push_back(
        name + ": of no meaning to springfit and passed over: " +
        join_some({reader.ignored.begin(), reader.ignored.end()}) + '.');
    return std::move(mesh);
  }
} // namespace springfit
