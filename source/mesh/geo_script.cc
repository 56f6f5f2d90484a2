#include <springfit/core/error.h>
#include <springfit/mesh/announced.h>
#include <springfit/mesh/file_contents.h>
#include <springfit/mesh/file_formats.h>
#include <springfit/mesh/geo_script.h>
#include <springfit/mesh/mesh_text.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace springfit
{
  namespace
  {
    const std::set<std::string> &
    refused_commands()
    {
      static const std::set<std::string> commands = {"Abort",
                                                     "Exit",
                                                     "Error",
                                                     "ExternalProcess",
                                                     "NonBlockingSystemCall",
                                                     "OnelabRun",
                                                     "SyncModel",
                                                     "System",
                                                     "SystemCall"};
      return commands;
    }

    /** A script, read word by word. */
    class Script
    {
    public:
      explicit Script(const std::filesystem::path &file)
      {
        std::ifstream stream(file);
        text_.assign(std::istreambuf_iterator<char>(stream), {});
      }

      /** The next word or string, or an empty text at the end. */
      std::string
      next()
      {
        while (position_ < text_.size())
          {
            const char c = text_[position_];
            if (starts("//"))
              skip_past("\n");
            else if (starts("/*"))
              skip_past("*/");
            else if (c == '"' || c == '\'')
              return string(c);
            else if (std::isalpha(static_cast<unsigned char>(c)))
              return word();
            else
              skip(1);
          }
        return "";
      }

      unsigned int
      line() const
      {
        return line_;
      }

    private:
      bool
      starts(const std::string &with) const
      {
        return text_.compare(position_, with.size(), with) == 0;
      }

      void
      skip(const std::size_t n)
      {
        for (std::size_t i = 0; i < n && position_ < text_.size(); ++i)
          line_ += text_[position_++] == '\n' ? 1 : 0;
      }

      void
      skip_past(const std::string &end)
      {
        const std::size_t found = text_.find(end, position_ + 1);
        skip(found == std::string::npos ? text_.size()
                                        : found + end.size() - position_);
      }

      std::string
      string(const char quote)
      {
        const std::size_t begin = position_;
        skip_past({quote});
        return text_.substr(begin, position_ - begin);
      }

      std::string
      word()
      {
        const std::size_t begin = position_;
        while (position_ < text_.size() &&
               (std::isalnum(static_cast<unsigned char>(text_[position_])) ||
                text_[position_] == '_'))
          skip(1);
        return text_.substr(begin, position_ - begin);
      }

      std::string text_;
      std::size_t position_ = 0;
      unsigned int line_    = 1;
    };

    /** A script and all files that it makes gmsh read. */
    class Checks
    {
    public:
      /** Each script is looked at once. */
      void
      check(const std::filesystem::path &file)
      {
        if (!seen_.insert(file.lexically_normal()).second)
          return;
        Script script(file);
        for (std::string word = script.next(); !word.empty();
             word             = script.next())
          if (refused_commands().count(word) > 0)
            throw error(file,
                        script,
                        "the command " + word + " is not run by springfit",
                        "Remove it: a .geo shall describe a geometry, not "
                                    "run programs or end gmsh.");
          else if (word == "Include")
            check(named_file(file, script, word));
          else if (word == "Merge" || word == "MergeWithBoundingBox")
            check_merged(file, script, named_file(file, script, word));
        check_options(file);
      }

    private:
      static InputError
      error(const std::filesystem::path &file,
            const Script &script,
            const std::string &what,
            const std::string &mend)
      {
        return InputError("Mesh file '" + file.string() + "', line " +
                            std::to_string(script.line()) + ": " + what + '.',
                          mend);
      }

      static std::filesystem::path
      named_file(const std::filesystem::path &file,
                 Script &script,
                 const std::string &command)
      {
        const std::string word = script.next();
        if (word.size() < 2 || (word[0] != '"' && word[0] != '\''))
          throw error(file,
                      script,
                      command + " is not followed by a file's name in quotes",
                      "Write the name out.");
        const auto other = file.parent_path() / word.substr(1, word.size() - 2);
        if (!std::filesystem::is_regular_file(other))
          throw error(file,
                      script,
                      command + " names '" + other.string() +
                        "', which is not there",
                      "Give its path relative to the folder of the .geo file.");
        return other;
      }

      // gmsh tells a geometry by its ending, in small letters or capitals, a
      // mesh by its beginning, and runs what it cannot tell.
      void
      check_merged(const std::filesystem::path &file,
                   const Script &script,
                   const std::filesystem::path &merged)
      {
        const std::string ending  = ending_of(merged);
        const std::string written = merged.extension();
        const bool is_known =
          (is_geometry_file(merged) || ending == ".stl") &&
          (written == ending || written == in_capitals(ending));
        if (ending_by_content(merged) == ".msh")
          announced_in_msh(merged);
        else if (ending == ".geo" || ending == ".pos")
          return check(merged);
        else if (!is_known)
          throw error(file,
                      script,
                      "springfit does not follow Merge to '" + merged.string() +
                        '\'',
                      "It does to .geo, .pos, .msh, .stl, .step, .iges and "
                      ".brep files: give a mesh of another format itself as "
                      "Geometry/File, or save it as .msh.");
        check_options(merged);
      }

      // gmsh runs what is beside a file under its name and this ending.
      void
      check_options(const std::filesystem::path &file)
      {
        const std::filesystem::path options = file.string() + ".opt";
        if (std::filesystem::is_regular_file(options))
          check(options);
      }

      std::set<std::filesystem::path> seen_;
    };
  } // namespace


  void
  check_geo_script(const std::filesystem::path &file)
  {
    Checks().check(file);
  }
} // namespace springfit
