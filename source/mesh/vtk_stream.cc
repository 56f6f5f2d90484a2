#include <springfit/mesh/mesh_text.h>
#include <springfit/mesh/vtk_stream.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

namespace springfit
{
  namespace
  {
    constexpr const char *blanks = " \t\r\n\f\v";

    // VTK's binary numbers are big-endian.
    template <typename Number>
    double
    big_endian(const char *bytes)
    {
      std::array<char, sizeof(Number)> reversed;
      std::reverse_copy(bytes, bytes + sizeof(Number), reversed.begin());
      Number value;
      std::memcpy(&value, reversed.data(), sizeof(Number));
      return static_cast<double>(value);
    }

    struct NumberType
    {
      std::size_t size;
      double (*read)(const char *);
    };

    template <typename Number>
    NumberType
    number_type()
    {
      return {sizeof(Number), &big_endian<Number>};
    }

    const std::map<std::string, NumberType> &
    number_types()
    {
      static const std::map<std::string, NumberType> types = {
        {"CHAR", number_type<std::int8_t>()},
        {"SIGNED_CHAR", number_type<std::int8_t>()},
        {"UNSIGNED_CHAR", number_type<std::uint8_t>()},
        {"SHORT", number_type<std::int16_t>()},
        {"UNSIGNED_SHORT", number_type<std::uint16_t>()},
        {"INT", number_type<std::int32_t>()},
        {"UNSIGNED_INT", number_type<std::uint32_t>()},
        {"LONG", number_type<std::int64_t>()},
        {"UNSIGNED_LONG", number_type<std::uint64_t>()},
        {"VTKIDTYPE", number_type<std::int32_t>()},
        {"VTKTYPEINT32", number_type<std::int32_t>()},
        {"VTKTYPEINT64", number_type<std::int64_t>()},
        {"VTKTYPEUINT32", number_type<std::uint32_t>()},
        {"VTKTYPEUINT64", number_type<std::uint64_t>()},
        {"FLOAT", number_type<float>()},
        {"DOUBLE", number_type<double>()}};
      return types;
    }
  } // namespace


  VtkStream::VtkStream(const std::filesystem::path &file,
                       const std::string &name)
    : name_(name)
  {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream all;
    all << stream.rdbuf();
    content_ = all.str();

    const std::string head = "# vtk DataFile Version ";
    if (in_capitals(content_.substr(0, head.size())) != in_capitals(head))
      throw error("it does not begin with '# vtk DataFile Version'");
    position_ = head.size();
    version_  = std::atoi(content_.c_str() + position_);
    skip_line();
    skip_line(); // the title
    const std::string format = keyword();
    if (format != "ASCII" && format != "BINARY")
      throw error("its third line is neither ASCII nor BINARY");
    is_binary_ = format == "BINARY";
  }


  std::string
  VtkStream::keyword()
  {
    position_ = content_.find_first_not_of(blanks, position_);
    if (position_ == std::string::npos)
      {
        position_ = content_.size();
        return "";
      }
    return in_capitals(word());
  }


  std::string
  VtkStream::word()
  {
    const auto begin = content_.find_first_not_of(blanks, position_);
    if (begin == std::string::npos)
      {
        position_ = content_.size();
        throw error("the file ends too early; it may be cut short");
      }
    position_ =
      std::min(content_.find_first_of(blanks, begin), content_.size());
    return content_.substr(begin, position_ - begin);
  }


  std::size_t
  VtkStream::count()
  {
    const std::string text = word();
    std::size_t value      = 0;
    const auto result =
      std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size())
      throw error("'" + text.substr(0, 60) + "' stands where a count should");
    return value;
  }


  bool
  VtkStream::goes_on_in_line() const
  {
    const auto next = content_.find_first_not_of(" \t\r", position_);
    return next != std::string::npos && content_[next] != '\n';
  }


  void
  VtkStream::skip_line()
  {
    const auto end = content_.find('\n', position_);
    position_      = end == std::string::npos ? content_.size() : end + 1;
  }


  void
  VtkStream::skip_paragraph()
  {
    skip_line();
    while (position_ < content_.size())
      {
        const bool is_empty = !goes_on_in_line();
        skip_line();
        if (is_empty)
          return;
      }
  }


  std::vector<double>
  VtkStream::numbers(const std::size_t n, const std::string &type)
  {
    // Each takes a byte at least, so this bounds the memory by the file.
    if (n > content_.size() - position_)
      throw error("it announces " + std::to_string(n) +
                  " numbers, more than the file holds; it may be cut short");
    const auto values = is_binary_ ? read_binary(n, type) : read_text(n);
    for (const double value : values)
      if (!std::isfinite(value))
        throw error("a number is not finite");
    return values;
  }


  std::vector<double>
  VtkStream::read_text(const std::size_t n)
  {
    std::vector<double> values(n);
    for (double &value : values)
      {
        std::string text = word();
        for (char &c : text)
          if (c == 'd' || c == 'D')
            c = 'e';
        const char *const begin = text.data() + (text[0] == '+' ? 1 : 0);
        const char *const end   = text.data() + text.size();
        const auto result       = std::from_chars(begin, end, value);
        if (result.ec != std::errc() || result.ptr != end)
          throw error("'" + text.substr(0, 60) +
                      "' stands where a number should");
      }
    return values;
  }


  std::vector<double>
  VtkStream::read_binary(const std::size_t n, const std::string &type)
  {
    skip_line(); // the rest of the keyword's
    const auto known = number_types().find(in_capitals(type));
    if (known == number_types().end())
      throw error("numbers of the type '" + type.substr(0, 60) +
                  "' are not known");
    const auto &[size, read] = known->second;
    if (n > (content_.size() - position_) / size)
      throw error("it announces " + std::to_string(n) +
                  " numbers, more than the file holds; it may be cut short");
    std::vector<double> values(n);
    for (double &value : values)
      {
        value = read(content_.data() + position_);
        position_ += size;
      }
    return values;
  }


  unsigned int
  VtkStream::version() const
  {
    return version_;
  }


  InputError
  VtkStream::error(const std::string &what) const
  {
    const auto line =
      1 + std::count(content_.begin(), content_.begin() + position_, '\n');
    return InputError(name_ +
                        (is_binary_ ? std::string(" (binary)")
                                    : ", line " + std::to_string(line) + ',') +
                        " cannot be read: " + what + '.',
                      "Mend it, or write the mesh anew.");
  }
} // namespace springfit
