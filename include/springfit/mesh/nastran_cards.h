#ifndef springfit_mesh_nastran_cards_h
#define springfit_mesh_nastran_cards_h

#include <springfit/mesh/mesh_text.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  /** An entry of a Nastran file's bulk data, with its continuations. */
  struct NastranCard
  {
    std::string name;                // in capitals, without the * of large ones
    std::vector<std::string> fields; // those behind the name, trimmed
    TextPlace place;

    /** Empty behind the last one. */
    std::string
    field(std::size_t i) const;
  };

  /** The bulk data of a Nastran file. */
  struct NastranBulk
  {
    std::vector<NastranCard> cards;
    bool has_end = false; // ENDDATA, behind which nothing is read
  };

  /**
   * Read small, large and free fields from behind BEGIN BULK, or from the
   * beginning of a file that has none.
   *
   * @throws InputError of read_text_lines.
   */
  NastranBulk
  read_nastran_bulk(const std::filesystem::path &file);

  /**
   * A number that may leave out the letter of its exponent: 1.5-3; 0 of an
   * empty field.
   *
   * @throws InputError of read_real.
   */
  double
  read_nastran_real(const std::string &text, const TextPlace &place);
} // namespace springfit

#endif
