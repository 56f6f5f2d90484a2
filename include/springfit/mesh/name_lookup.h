#ifndef springfit_mesh_name_lookup_h
#define springfit_mesh_name_lookup_h

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

  /**
   * The ids that @p word means: itself, if it is a number, or all ids of that
   * name. @p what is "boundary" or "material", @p entry the parameter.
   *
   * @throws EntryError that lists @p known, with the nearest name.
   */
  std::vector<unsigned int>
  find_ids(const std::vector<IdAndName> &known,
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
