#ifndef springfit_mesh_name_lookup_h
#define springfit_mesh_name_lookup_h

#include <map>
#include <set>
#include <string>
#include <vector>

namespace springfit
{
  /** A boundary or a material; the name may be empty. */
  struct IdAndName
  {
    unsigned int id;
    std::string name;
  };

  /** Each id with each of its names; once with "" if it has none. */
  std::vector<IdAndName>
  ids_and_names(const std::set<unsigned int> &ids,
                const std::multimap<unsigned int, std::string> &names);

  /** The names of @p id between commas. */
  std::string
  joined_names(const std::multimap<unsigned int, std::string> &names,
               unsigned int id);

  /** Names in a mesh file that are none of those looked for, and why. */
  using UnusedNames = std::map<std::string, std::string>;

  /**
   * The ids that @p word means: all ids of that name, or itself, if it is a
   * number. (Both, if the boundary of that number has it for its name, too, as
   * groups without a name do that overlap with others.) The case of a name does
   * not matter where it tells no two names apart. A word in double quotes is a
   * name only, "id 2" the number 2. @p what is "boundary" or "material", @p
   * entry the parameter. An id with several names is listed several times in @p
   * known.
   *
   * @throws EntryError when the word is the number of one and the name of
   * others; when it is neither, with @p known, the nearest name, and
   * @p unused.
   */
  std::set<unsigned int>
  find_ids(const std::vector<IdAndName> &known,
           const UnusedNames &unused,
           const std::string &word,
           const std::string &what,
           const std::string &entry);


  /** A line of a table for the screen. */
  struct TableLine
  {
    unsigned int id;
    std::string name; // shown as - if empty
    unsigned int count;
    double measure;
  };

  /** Four columns below their headlines, separated by " : ". */
  std::string
  format_table(const std::vector<std::string> &headlines,
               const std::vector<TableLine> &lines);
} // namespace springfit

#endif
