#include <springfit/core/error.h>
#include <springfit/output/growing_table.h>

namespace springfit
{
  GrowingTable::GrowingTable(const std::filesystem::path &path,
                             const std::string &header)
    : path_(path), row_(header), file_(path, std::ios::trunc)
  {
    file_ << header << '\n';
    size_ = header.size() + 1;
  }

  GrowingTable::GrowingTable(const std::filesystem::path &path,
                             const std::string &header,
                             const std::uintmax_t size)
    : path_(path), row_(header), size_(size)
  {
    std::filesystem::resize_file(path, size);
    file_.open(path, std::ios::app);
  }

  CsvTable &
  GrowingTable::row()
  {
    row_.new_row();
    return row_;
  }

  void
  GrowingTable::append()
  {
    const std::string text = row_.take_rows();
    file_ << text << std::flush;
    if (!file_)
      throw RunError("The file '" + path_.string() + "' could not be written.",
                     "Free space on the disk.");
    size_ += text.size();
  }

  std::uintmax_t
  GrowingTable::size() const
  {
    return size_;
  }
} // namespace springfit
