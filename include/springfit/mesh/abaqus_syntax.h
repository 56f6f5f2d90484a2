#ifndef springfit_mesh_abaqus_syntax_h
#define springfit_mesh_abaqus_syntax_h

#include <springfit/mesh/mesh_text.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace springfit
{
  /** A keyword of an Abaqus file with the lines of data that follow it. */
  struct AbaqusBlock
  {
    std::string word; // in capitals, single blanks: "SOLID SECTION"
    std::map<std::string, std::string> settings; // keys in capitals
    TextPlace place;
    std::vector<TextLine> lines;

    /** The value of a setting, or "" when it is not there. */
    std::string
    setting(const std::string &key) const;
  };

  /**
   * The keywords of an Abaqus file. Comments are left out, keyword lines that
   * end with a comma go on in the next one, and *INCLUDE and the setting INPUT
   * of *NODE, *ELEMENT and sets are replaced by what is in that file, whose
   * name is relative to the folder of the one that names it.
   *
   * @throws InputError when a file is missing or includes itself, when the
   * first keyword comes after data, or when a keyword line has no word.
   */
  std::vector<AbaqusBlock>
  read_abaqus_blocks(const std::filesystem::path &file);
} // namespace springfit

#endif
