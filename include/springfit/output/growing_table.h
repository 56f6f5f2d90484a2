#ifndef springfit_output_growing_table_h
#define springfit_output_growing_table_h

#include <springfit/output/csv.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace springfit
{
  /**
   * A table of comma-separated values that is there while it grows, so that a
   * run which is stopped leaves all rows but the one in hand.
   */
  class GrowingTable
  {
  public:
    /** @throws RunError when the file cannot be written. */
    GrowingTable(const std::filesystem::path &path, const std::string &header);

    /** Go on with the first @p size bytes of the file. */
    GrowingTable(const std::filesystem::path &path,
                 const std::string &header,
                 std::uintmax_t size);

    /** For a row to be written into by append(). */
    CsvTable &
    row();

    /** @throws RunError when the file cannot be written. */
    void
    append();

    /** Bytes. */
    std::uintmax_t
    size() const;

  private:
    const std::filesystem::path path_;
    CsvTable row_;
    std::ofstream file_;
    std::uintmax_t size_ = 0;
  };
} // namespace springfit

#endif
