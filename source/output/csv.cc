#include <springfit/core/atomic_file.h>
#include <springfit/core/error.h>
#include <springfit/output/csv.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace springfit
{
  CsvTable::CsvTable(const std::string &header) : header_(header)
  {}

  void
  CsvTable::new_row()
  {
    if (!rows_.empty())
      rows_ += '\n';
    row_begins_ = true;
  }

  CsvTable &
  CsvTable::operator<<(const std::string &text)
  {
    if (!row_begins_)
      rows_ += ',';
    rows_ += text;
    row_begins_ = false;
    return *this;
  }

  CsvTable &
  CsvTable::operator<<(const unsigned int number)
  {
    return *this << std::to_string(number);
  }

  CsvTable &
  CsvTable::operator<<(const double number)
  {
    return add(number, 8);
  }

  CsvTable &
  CsvTable::operator<<(const std::optional<double> &number)
  {
    return number ? *this << *number : *this << std::string();
  }

  CsvTable &
  CsvTable::exactly(const double number)
  {
    return add(number, 17);
  }

  CsvTable &
  CsvTable::add(const double number, const int n_digits)
  {
    if (!std::isfinite(number))
      throw RunError("A result that belongs into the table '" + header_ +
                       "' is not a finite number.",
                     "This should not happen: please report it with the "
                     "parameter file.");
    char text[32];
    std::snprintf(text, sizeof(text), "%.*g", n_digits, number);
    return *this << std::string(text);
  }

  std::string
  CsvTable::take_rows()
  {
    std::string rows;
    std::swap(rows, rows_);
    return rows.empty() ? rows : rows + '\n';
  }

  void
  CsvTable::write(const std::filesystem::path &path) const
  {
    write_file(path, [this](std::ostream &file) {
      file << header_ << '\n' << rows_ << (rows_.empty() ? "" : "\n");
    });
  }
} // namespace springfit
