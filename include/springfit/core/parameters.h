#ifndef springfit_core_parameters_h
#define springfit_core_parameters_h

#include <springfit/core/error.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  /**
   * What the user says on the command line: a parameter file, and entries
   * that take precedence over it, each as "Section/Entry=value".
   */
  struct ParameterSource
  {
    std::filesystem::path file;
    std::vector<std::string> overrides;
  };

  /**
   * Check that @p file can be read, and the files that it includes.
   *
   * @throws InputError when it is missing, a directory, something that blocks
   * its reader, or unreadable, and when a file includes itself, be it through
   * others.
   */
  void
  check_parameter_file(const std::filesystem::path &file);

  /**
   * Check that a parameter file gives back @p value, or used.prm would not say
   * how a run was made.
   *
   * @throws EntryError of @p entry when it has a character that ends a value.
   */
  void
  check_can_be_stored(const std::string &entry, const std::string &value);

  /**
   * Read every entry of @p source into @p prm, in which all entries have been
   * declared.
   *
   * @throws InputError naming the file, the line, the entry and the nearest
   * known one when an entry is misspelt or a value does not have the form
   * that its entry asks for. EntryError when a value of the command line cannot
   * be stored in a parameter file.
   */
  void
  read_parameters(dealii::ParameterHandler &prm, const ParameterSource &source);

  /**
   * Read a single top-level entry and ignore all others; empty when it is not
   * given.
   */
  std::string
  read_top_level_entry(const ParameterSource &source, const std::string &entry);

  /** @p error's message, led by the place where its entry was set. */
  std::string
  locate(const EntryError &error, const ParameterSource &source);
} // namespace springfit

#endif
