#include <springfit/core/atomic_file.h>
#include <springfit/core/error.h>
#include <springfit/motion/checkpoint.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

namespace springfit
{
  namespace
  {
    const std::string mark = "springfit checkpoint 1\n";

    template <typename T>
    void
    append(const T &value, std::string &bytes)
    {
      bytes.append(reinterpret_cast<const char *>(&value), sizeof(value));
    }
  } // namespace

  std::uint64_t
  checksum(const std::string &bytes)
  {
    std::uint64_t sum = 14695981039346656037u;
    for (const unsigned char byte : bytes)
      sum = (sum ^ byte) * 1099511628211u;
    return sum;
  }

  CheckpointWriter &
  CheckpointWriter::operator<<(const double value)
  {
    append(value, bytes_);
    return *this;
  }

  CheckpointWriter &
  CheckpointWriter::operator<<(const std::uint64_t value)
  {
    append(value, bytes_);
    return *this;
  }

  CheckpointWriter &
  CheckpointWriter::operator<<(const std::string &value)
  {
    *this << std::uint64_t(value.size());
    bytes_ += value;
    return *this;
  }

  CheckpointWriter &
  CheckpointWriter::operator<<(const Eigen::MatrixXd &value)
  {
    *this << std::uint64_t(value.rows()) << std::uint64_t(value.cols());
    bytes_.append(reinterpret_cast<const char *>(value.data()),
                  sizeof(double) * value.size());
    return *this;
  }

  std::uint64_t
  CheckpointWriter::sum() const
  {
    return checksum(bytes_);
  }

  void
  CheckpointWriter::write(const std::filesystem::path &path) const
  {
    write_file(path, [this](std::ostream &file) {
      std::string sum;
      append(this->sum(), sum);
      file << mark << sum << bytes_;
    });
  }

  CheckpointReader::CheckpointReader(const std::filesystem::path &path)
    : path_(path)
  {
    std::ifstream file(path, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
    const std::size_t head = mark.size() + sizeof(std::uint64_t);
    if (bytes_.size() < head || bytes_.compare(0, mark.size(), mark) != 0)
      throw InputError("The file '" + path.string() +
                         "' is no checkpoint of this version of springfit.",
                       "Remove it to begin anew.");
    std::uint64_t sum;
    std::memcpy(&sum, bytes_.data() + mark.size(), sizeof(sum));
    bytes_.erase(0, head);
    if (checksum(bytes_) != sum)
      throw InputError("The checkpoint '" + path.string() + "' is damaged.",
                       "Remove it to begin anew.");
  }

  CheckpointReader &
  CheckpointReader::operator>>(double &value)
  {
    take(&value, sizeof(value));
    return *this;
  }

  CheckpointReader &
  CheckpointReader::operator>>(std::uint64_t &value)
  {
    take(&value, sizeof(value));
    return *this;
  }

  CheckpointReader &
  CheckpointReader::operator>>(std::string &value)
  {
    std::uint64_t size;
    *this >> size;
    value.resize(std::min<std::uint64_t>(size, bytes_.size()));
    take(value.data(), size);
    return *this;
  }

  CheckpointReader &
  CheckpointReader::operator>>(Eigen::MatrixXd &value)
  {
    std::uint64_t n_rows, n_columns;
    *this >> n_rows >> n_columns;
    if (n_rows > bytes_.size() || n_columns > bytes_.size())
      take(nullptr, bytes_.size() + 1);
    value.resize(n_rows, n_columns);
    take(value.data(), sizeof(double) * value.size());
    return *this;
  }

  void
  CheckpointReader::take(void *value, const std::size_t size)
  {
    if (size > bytes_.size() - position_)
      throw InputError("The checkpoint '" + path_.string() + "' is too short.",
                       "Remove it to begin anew.");
    std::memcpy(value, bytes_.data() + position_, size);
    position_ += size;
  }
} // namespace springfit
