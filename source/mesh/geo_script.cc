#include <springfit/core/error.h>
#include <springfit/mesh/geo_script.h>

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
            else if (c == '"')
              return string();
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
      string()
      {
        const std::size_t begin = position_;
        skip_past("\"");
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

    void
    check(const std::filesystem::path &file,
          std::set<std::filesystem::path> &seen)
    {
      if (!seen.insert(file.lexically_normal()).second)
        return;
      Script script(file);
      std::string last;
      for (std::string word = script.next(); !word.empty();
           word             = script.next())
        {
                      if (refused_commands().count(word) > 0)
            throw InputError("Mesh file '" + file.string() + "', line " +
                               std::to_string(script.line()) +
                               ": the command " + word +
                               " is not run by springfit.",
                             "Remove it: a .geo shall describe a geometry, not "
                                         "run programs or end gmsh.");
          if (word.size() > 2 && word[0] == '"' &&
              (last == "Include" || last == "Merge"))
            {
                          const auto other =
                            file.parent_path() / word.substr(1, word.size() - 2);
                          if (other.extension() == ".geo" &&
                  std::filesystem::is_regular_file(other))
                check(other, seen);
            }
                      last = word;
        }
    }
  } // namespace


  void
  check_geo_script(const std::filesystem::path &file)
  {
    std::set<std::filesystem::path> seen;
    check(file, seen);
  }
} // namespace springfit
