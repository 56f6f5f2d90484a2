#include <springfit/mesh/file_contents.h>
#include <springfit/mesh/mesh_text.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace springfit
{
  namespace
  {
    /** How a file begins: some thousand bytes, and their lines. */
    struct Beginning
    {
      std::string bytes;
      std::vector<std::string> lines; // trimmed, without the empty ones

      bool
      starts(const std::string &with) const
      {
        return bytes.compare(0, with.size(), with) == 0;
      }

      bool
      first_line_starts(const std::string &with) const
      {
        return !lines.empty() && lines[0].compare(0, with.size(), with) == 0;
      }
    };

    Beginning
    beginning_of(const std::filesystem::path &file)
    {
      constexpr std::size_t n_bytes = 1 << 15;
      Beginning beginning;
      beginning.bytes.resize(n_bytes);
      std::ifstream stream(file, std::ios::binary);
      stream.read(beginning.bytes.data(), n_bytes);
      beginning.bytes.resize(stream.gcount());
      std::string text = beginning.bytes;
      if (text.rfind("\xEF\xBB\xBF", 0) == 0)
        text.erase(0, 3);
      std::replace(text.begin(), text.end(), '\r', '\n');
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);)
        if (!trimmed(line).empty())
          beginning.lines.push_back(trimmed(line));
      return beginning;
    }

    /** Whether any line begins with one of the words, a whole one. */
    bool
    has_line_of(const Beginning &beginning, const std::set<std::string> &words)
    {
      return std::any_of(
        beginning.lines.begin(),
        beginning.lines.end(),
        [&](const std::string &line) {
          const auto end =
            std::find_if_not(line.begin(),
                             line.end(),
                             [](const unsigned char c) {
                               return std::isalnum(c) || c == '_';
                             });
          return words.count(in_capitals({line.begin(), end})) > 0;
        });
    }

    // What makes gmsh take a file for a mesh, if nothing stands before it.
    bool
    is_gmsh_mesh(const Beginning &beginning)
    {
      for (const char *section :
           {"$MeshFormat", "$Comments", "$NO", "$ELM", "$PARA", "$PTS"})
        if (beginning.starts(section))
          return true;
      return false;
    }

    bool
    is_stl(const Beginning &beginning)
    {
      if (beginning.first_line_starts("solid"))
        return has_line_of(beginning, {"FACET"});
      return false;
    }

    bool
    is_vtk_xml(const Beginning &beginning)
    {
      return beginning.first_line_starts("<") &&
             beginning.bytes.find("<VTKFile") != std::string::npos;
    }

    bool
    is_medit(const Beginning &beginning)
    {
      for (const std::string &line : beginning.lines)
        if (line[0] != '#')
          return in_capitals(line).rfind("MESHVERSIONFORMATTED", 0) == 0;
      return false;
    }

    bool
    is_ls_dyna(const Beginning &beginning)
    {
      for (const std::string &line : beginning.lines)
        if (line[0] != '$')
          return in_capitals(line).rfind("*KEYWORD", 0) == 0;
      return false;
    }

    bool
    is_abaqus(const Beginning &beginning)
    {
      for (const std::string &line : beginning.lines)
        if (line.rfind("**", 0) != 0)
          return line[0] == '*' && line.size() > 1 &&
                 std::isalpha(static_cast<unsigned char>(line[1]));
      return false;
    }

    // The letter of a section stands in column 73 of each line.
    bool
    is_iges(const Beginning &beginning)
    {
      return beginning.bytes.size() > 79 && beginning.bytes[72] == 'S' &&
             std::isdigit(static_cast<unsigned char>(beginning.bytes[79]));
    }

    bool
    is_brep(const Beginning &beginning)
    {
      return beginning.first_line_starts("DBRep_DrawableShape") ||
             beginning.first_line_starts("CASCADE Topology");
    }

    bool
    is_nastran(const Beginning &beginning)
    {
      return has_line_of(beginning, {"GRID", "CEND"}) ||
             std::any_of(beginning.lines.begin(),
                         beginning.lines.end(),
                         [](const std::string &line) {
                           return in_capitals(line).rfind("BEGIN BULK", 0) == 0;
                         });
    }

    bool
    is_geo_script(const Beginning &beginning)
    {
      for (const std::string &line : beginning.lines)
        for (const char *command : {"SetFactory", "Point", "Physical"})
          if (line.rfind(command, 0) == 0 &&
              line.find('(') != std::string::npos)
            return true;
      return false;
    }

    using Format = std::pair<std::string, bool (*)(const Beginning &)>;

    // Those that leave no doubt come first.
    const std::vector<Format> &
    formats()
    {
      static const std::vector<Format> all = {
        {"git-lfs",
         [](const Beginning &beginning) {
           return beginning.starts("version https://git-lfs");
         }},
        {".gz",
         [](const Beginning &beginning) {
           return beginning.starts("\x1f\x8b");
         }},
        {".zip",
         [](const Beginning &beginning) {
           return beginning.starts("PK\x03\x04");
         }},
        {".h5",
         [](const Beginning &beginning) {
           return beginning.starts("\x89HDF");
         }},
        {".cas",
         [](const Beginning &beginning) {
           return beginning.first_line_starts("(");
         }},
        {".e",
         [](const Beginning &beginning) { return beginning.starts("CDF"); }},
        {".msh", is_gmsh_mesh},
        {".vtk",
         [](const Beginning &beginning) {
           return beginning.first_line_starts("# vtk DataFile");
         }},
        {".vtu", is_vtk_xml},
        {".stl", is_stl},
        {".step",
         [](const Beginning &beginning) {
           return beginning.first_line_starts("ISO-10303-21");
         }},
        {".brep", is_brep},
        {".igs", is_iges},
        {".mesh", is_medit},
        {".k", is_ls_dyna},
        {".inp", is_abaqus},
        {".unv",
         [](const Beginning &beginning) {
           return !beginning.lines.empty() && beginning.lines[0] == "-1";
         }},
        {".su2",
         [](const Beginning &beginning) {
           return has_line_of(beginning, {"NDIME"});
         }},
        {".bdf", is_nastran},
        {".geo", is_geo_script}};
      return all;
    }
  } // namespace


  std::string
  ending_by_content(const std::filesystem::path &file)
  {
    const Beginning beginning = beginning_of(file);
    for (const auto &[ending, is_so] : formats())
      if (is_so(beginning))
        return ending;
    return "";
  }
} // namespace springfit
