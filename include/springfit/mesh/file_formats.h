#ifndef springfit_mesh_file_formats_h
#define springfit_mesh_file_formats_h

#include <filesystem>
#include <string>

namespace springfit
{
  /** The ending of a file's name in small letters, as ".geo". */
  std::string
  ending_of(const std::filesystem::path &file);

  /** Whether the file is a program that gmsh runs. */
  bool
  is_geo_script(const std::filesystem::path &file);

  /** Whether the file holds a geometry, which is yet to be meshed. */
  bool
  is_geometry_file(const std::filesystem::path &file);

  /** Whether the file states the unit of its lengths (STEP, IGES). */
  bool
  states_its_unit(const std::filesystem::path &file);

  /**
   * Refuse formats that springfit cannot read, and files that begin as those of
   * another format than their ending says; @p name begins the message. What
   * passes is read by the reader of its ending: gmsh itself would choose by
   * rules of its own, and run what it does not know as a script.
   *
   * @throws InputError that says what the file is and how to convert it.
   */
  void
  check_format(const std::filesystem::path &file, const std::string &name);

  /** What a user can do about a file that cannot be read. */
  std::string
  mend_format();
} // namespace springfit

#endif
