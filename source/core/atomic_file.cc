#include <springfit/core/atomic_file.h>
#include <springfit/core/error.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace springfit
{
  void
  write_file(const std::filesystem::path &path,
             const std::function<void(std::ostream &)> &write)
  {
    const std::filesystem::path temporary = path.string() + ".part";

    const auto fail = [&](const std::string &reason) {
      std::error_code ignored;
      std::filesystem::remove(temporary, ignored);
      throw RunError("The file '" + path.string() +
                       "' could not be written: " + reason + ".",
                     "Free space on the disk, or choose another folder by "
                     "'Output directory'.");
    };

    errno = 0;
    std::ofstream file(temporary);
    if (!file)
      fail(std::strerror(errno));
    bool given_up = false;
    try
      {
        write(file);
      }
    catch (const std::exception &)
      {
        if (file)
          {
            std::error_code ignored;
            std::filesystem::remove(temporary, ignored);
            throw;
          }
        // A library found that the file does not take its words: write the
        // last ones once more to learn why.
        given_up = true;
        file.clear();
        errno = 0;
      }
    file.close();
    if (!file || given_up)
      fail(errno != 0 ? std::strerror(errno) : "writing failed");

    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    if (error)
      fail(error.message());
  }
} // namespace springfit
