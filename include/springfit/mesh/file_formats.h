#ifndef springfit_mesh_file_formats_h
#define springfit_mesh_file_formats_h

#include <filesystem>
#include <string>

namespace springfit
{
  /** The ending of a file's name in small letters, as ".geo". */
  std::string
  ending_of(const std::filesystem::path &file);

  /** Whether gmsh runs the file: its own scripts, and what it does not know. */
  bool
  may_be_script(const std::filesystem::path &file);

  /** Whether the file holds a geometry, which is yet to be meshed. */
  bool
  is_geometry_file(const std::filesystem::path &file);

  /** Whether the file states the unit of its lengths (STEP, IGES). */
  bool
  states_its_unit(const std::filesystem::path &file);

  /**
   * Refuse formats that springfit cannot read; @p name begins the message.
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
