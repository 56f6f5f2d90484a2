#include <springfit/mesh/abaqus_syntax.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <system_error>

namespace springfit
{
  namespace
  {
    bool
    is_comment(const std::string &text)
    {
      return text.rfind("**", 0) == 0;
    }

    std::string
    without_quotes(const std::string &text)
    {
      if (text.size() > 1 && text.front() == '"' && text.back() == '"')
        return trimmed(text.substr(1, text.size() - 2));
      return text;
    }

    // A comma within quotes belongs to the name.
    std::vector<std::string>
    split_keyword_line(const std::string &text)
    {
      std::vector<std::string> pieces(1);
      bool is_quoted = false;
      for (const char c : text)
        {
          if (c == '"')
            is_quoted = !is_quoted;
          if (c == ',' && !is_quoted)
            pieces.emplace_back();
          else
            pieces.back() += c;
        }
      return pieces;
    }

    std::string
    with_single_blanks(const std::string &text)
    {
      std::string result;
      for (const std::string &piece : split_at_blanks(text))
        result += (result.empty() ? "" : " ") + piece;
      return result;
    }

    AbaqusBlock
    parse_keyword(const TextLine &line)
    {
      AbaqusBlock block;
      block.place = line.place;
      for (const std::string &piece :
           split_keyword_line(trimmed(line.text).substr(1)))
        {
          const auto equals = piece.find('=');
          const auto key =
            in_capitals(with_single_blanks(piece.substr(0, equals)));
          if (!key.empty() &&
              (std::isdigit(static_cast<unsigned char>(key.front())) ||
               key.front() == '-'))
            throw text_error(line.place,
                             "the keyword has the setting '" + key + "'",
                             "Remove the comma at the end of the keyword's "
                             "line, which makes the next line a part of it.");
          if (block.word.empty())
            block.word = key;
          else if (!key.empty())
            block.settings[key] =
              equals == std::string::npos
                ? ""
                : without_quotes(trimmed(piece.substr(equals + 1)));
          if (block.word.empty())
            throw text_error(line.place, "a star without a keyword");
        }
      return block;
    }

    class Reader
    {
    public:
      void
      read(const std::filesystem::path &file)
      {
        const auto lines = read_text_lines(file);
        open_files_.push_back(canonical(file));
        for (std::size_t i = 0; i < lines.size(); ++i)
          {
            TextLine line = lines[i];
            line.text     = trimmed(line.text);
            if (line.text.empty() || is_comment(line.text))
              continue;
            if (line.text.front() != '*')
              {
                add_data(line);
                continue;
              }
            while (line.text.back() == ',' && i + 1 < lines.size() &&
                   trimmed(lines[i + 1].text).rfind('*', 0) != 0)
              line.text += trimmed(lines[++i].text);
            start(parse_keyword(line), file);
          }
        open_files_.pop_back();
      }

      std::vector<AbaqusBlock> blocks;

    private:
      static std::filesystem::path
      canonical(const std::filesystem::path &file)
      {
        std::error_code ignored;
        return std::filesystem::weakly_canonical(file, ignored);
      }

      void
      add_data(const TextLine &line)
      {
        if (blocks.empty())
          throw text_error(line.place,
                           "an Abaqus file begins with a keyword such as "
                           "*NODE, this one with other text",
                           "If it is another format that ends in .inp, such "
                           "as AVS-UCD, convert it to .msh or .vtk.");
        blocks.back().lines.push_back(line);
      }

      void
      start(const AbaqusBlock &block, const std::filesystem::path &file)
      {
        static const std::set<std::string> with_input = {
          "NODE", "ELEMENT", "NSET", "ELSET", "SURFACE"};
        if (block.word == "INCLUDE")
          return include(block, file);
        blocks.push_back(block);
        if (with_input.count(block.word) > 0 &&
            block.settings.count("INPUT") > 0)
          include(block, file);
      }

      void
      include(const AbaqusBlock &block, const std::filesystem::path &file)
      {
        const std::string name = block.setting("INPUT");
        if (name.empty())
          throw text_error(block.place,
                           "*" + block.word + " names no file",
                           "Write *INCLUDE, INPUT=file.");
        const auto other = file.parent_path() / name;
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(other, ignored))
          throw text_error(block.place,
                           "the file '" + other.string() +
                             "' that it names is not there",
                           "Put it there: its name is relative to the folder "
                           "of the file that names it.");
        if (std::find(open_files_.begin(),
                      open_files_.end(),
                      canonical(other)) != open_files_.end())
          throw text_error(block.place,
                           "the file '" + other.string() + "' includes itself",
                           "Remove one of the inclusions.");
        read(other);
      }

      std::vector<std::filesystem::path> open_files_;
    };
  } // namespace


  std::string
  AbaqusBlock::setting(const std::string &key) const
  {
    const auto found = settings.find(key);
    return found == settings.end() ? "" : found->second;
  }


  std::vector<AbaqusBlock>
  read_abaqus_blocks(const std::filesystem::path &file)
  {
    Reader reader;
    reader.read(file);
    return reader.blocks;
  }
} // namespace springfit
