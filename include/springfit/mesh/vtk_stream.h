#ifndef springfit_mesh_vtk_stream_h
#define springfit_mesh_vtk_stream_h

#include <springfit/core/error.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  /** The words and arrays of a legacy VTK file, which may be binary. */
  class VtkStream
  {
  public:
    /** @throws InputError when the file is none. */
    VtkStream(const std::filesystem::path &file, const std::string &name);

    /** The next word in capitals, or "" at the end. */
    std::string
    keyword();

    /** The next word as it is. @throws InputError at the end. */
    std::string
    word();

    /** @throws InputError when it is no number >= 0. */
    std::size_t
    count();

    /** Whether another word stands on the line that was read last. */
    bool
    goes_on_in_line() const;

    void
    skip_line();

    /** Leave out all lines up to and with an empty one. */
    void
    skip_paragraph();

    /**
     * @p n numbers of a type of VTK ("float", "vtktypeint64", ...).
     *
     * @throws InputError when the type is not known, the file ends before, or
     * one is not finite.
     */
    std::vector<double>
    numbers(std::size_t n, const std::string &type);

    /** The major version. */
    unsigned int
    version() const;

    /** "Mesh file 'a.vtk', line 7, cannot be read: ..." */
    InputError
    error(const std::string &what) const;

  private:
    std::vector<double>
    read_text(std::size_t n);

    std::vector<double>
    read_binary(std::size_t n, const std::string &type);

    std::string name_;
    std::string content_;
    std::size_t position_ = 0;
    unsigned int version_ = 0;
    bool is_binary_       = false;
  };
} // namespace springfit

#endif
