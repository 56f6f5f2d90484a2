#ifndef springfit_motion_checkpoint_h
#define springfit_motion_checkpoint_h

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  /** Numbers and texts as bytes, in the order in which they are put. */
  class CheckpointWriter
  {
  public:
    CheckpointWriter &
    operator<<(double value);

    CheckpointWriter &
    operator<<(std::uint64_t value);

    CheckpointWriter &
    operator<<(const std::string &value);

    CheckpointWriter &
    operator<<(const Eigen::MatrixXd &value);

    /** See checksum(), of all that was put. */
    std::uint64_t
    sum() const;

    /**
     * The whole file at once, with a sum that tells damage.
     *
     * @throws RunError when it cannot be written.
     */
    void
    write(const std::filesystem::path &path) const;

  private:
    std::string bytes_;
  };


  /** Reads what a CheckpointWriter wrote, to the same bits. */
  class CheckpointReader
  {
  public:
    /** @throws InputError when it is no such file, or damaged. */
    explicit CheckpointReader(const std::filesystem::path &path);

    // @throws InputError when nothing of that size is left.

    CheckpointReader &
    operator>>(double &value);

    CheckpointReader &
    operator>>(std::uint64_t &value);

    CheckpointReader &
    operator>>(std::string &value);

    CheckpointReader &
    operator>>(Eigen::MatrixXd &value);

  private:
    void
    take(void *value, std::size_t size);

    const std::filesystem::path path_;
    std::string bytes_;
    std::size_t position_ = 0;
  };

  /** Of bytes, by Fowler, Noll and Vo's function FNV-1a of 64 bits. */
  std::uint64_t
  checksum(const std::string &bytes);
} // namespace springfit

#endif
