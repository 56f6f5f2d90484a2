#ifndef springfit_mesh_mesh_text_h
#define springfit_mesh_mesh_text_h

#include <springfit/core/error.h>
#include <springfit/core/trimmed.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace springfit
{
  /** Where something stands: a line, counted from 1, of a file; 0 in a binary
   * one. */
  struct TextPlace
  {
    std::shared_ptr<const std::string> file;
    unsigned int line;
  };

  /** A line of a mesh file and its place. */
  struct TextLine
  {
    std::string text;
    TextPlace place;
  };

  /**
   * All lines of a text file, without line ends of any system and without the
   * mark of byte order at its beginning.
   *
   * @throws InputError when the file cannot be read, or holds bytes 0 as files
   * that are no text do.
   */
  std::vector<TextLine>
  read_text_lines(const std::filesystem::path &file);

  /**
   * "Mesh file 'a.inp', line 7, cannot be read: <what>. <mend>", where @p what
   * is shortened if it is long.
   */
  InputError
  text_error(const TextPlace &place,
             const std::string &what,
             const std::string &mend = "Mend it, or convert the mesh to .msh.");

  /** @p text in capitals. */
  std::string
  in_capitals(std::string text);

  /** The pieces between @p separator, trimmed; those in between may be empty.
   */
  std::vector<std::string>
  split_fields(const std::string &text, char separator);

  /** The pieces between blanks and tabs, none of them empty. */
  std::vector<std::string>
  split_at_blanks(const std::string &text);

  /**
   * The whole of @p text as a finite number; the exponent may begin with an e
   * or, as in Fortran, a d.
   *
   * @throws InputError that names @p place.
   */
  double
  read_real(const std::string &text, const TextPlace &place);

  /**
   * The whole of @p text as a number of a node or an element, from 1 to 2^53.
   *
   * @throws InputError that names @p place.
   */
  std::size_t
  read_label(const std::string &text, const TextPlace &place);

  /**
   * @p number as the id of a material or a boundary, from 0 to 2147483647.
   * @p what it is, for the message: "the reference".
   *
   * @throws InputError that names @p place.
   */
  unsigned int
  checked_id(long number, const std::string &what, const TextPlace &place);

  /** "a, b, c and 12 more": at most @p n_named words by themselves. */
  std::string
  join_some(const std::vector<std::string> &words, unsigned int n_named = 12);
} // namespace springfit

#endif
