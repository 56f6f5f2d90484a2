#ifndef springfit_output_csv_h
#define springfit_output_csv_h

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /**
   * A table of comma-separated values. A cell that has no value stays empty;
   * what is not a finite number never enters.
   */
  class CsvTable
  {
  public:
    explicit CsvTable(const std::string &header);

    /** Begin a row. */
    void
    new_row();

    CsvTable &
    operator<<(const std::string &text);

    CsvTable &
    operator<<(unsigned int number);

    /**
     * Eight significant digits.
     *
     * @throws RunError when @p number is not finite.
     */
    CsvTable &
    operator<<(double number);

    CsvTable &
    operator<<(const std::optional<double> &number);

    /** As many digits as it takes to read the same double back. */
    CsvTable &
    exactly(double number);

    /** All rows, each ended, which the table does not have any more. */
    std::string
    take_rows();

    /** @throws RunError when the file cannot be written. */
    void
    write(const std::filesystem::path &path) const;

  private:
    CsvTable &
    add(double number, int n_digits);

    const std::string header_;
    std::string rows_;
    bool row_begins_ = true;
  };
} // namespace springfit

#endif
