#include <springfit/core/atomic_file.h>
#include <springfit/core/error.h>
#include <springfit/output/vtu_file.h>

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <new>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    const char *
    byte_order()
    {
      const std::uint16_t one = 1;
      unsigned char first;
      std::memcpy(&first, &one, 1);
      return first == 1 ? "LittleEndian" : "BigEndian";
    }

    /** Text between the quotes of an attribute. */
    std::string
    escaped(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        switch (c)
          {
            case '&':
              result += "&amp;";
              break;
            case '<':
              result += "&lt;";
              break;
            case '>':
              result += "&gt;";
              break;
            case '"':
              result += "&quot;";
              break;
            default:
              result += c;
          }
      return result;
    }

    /** The fewest digits that read back as the same number. */
    std::string
    shortest(const double number)
    {
      char text[32];
      const auto end = std::to_chars(text, text + sizeof(text), number).ptr;
      return std::string(text, end);
    }

    std::string
    base64(const std::string &bytes)
    {
      constexpr char digits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      std::string text;
      text.reserve((bytes.size() + 2) / 3 * 4);
      for (std::size_t i = 0; i < bytes.size(); i += 3)
        {
          const std::size_t n   = std::min<std::size_t>(3, bytes.size() - i);
          std::uint32_t triplet = 0;
          for (std::size_t j = 0; j < 3; ++j)
            triplet = triplet << 8 |
                      (j < n ? static_cast<unsigned char>(bytes[i + j]) : 0u);
          for (std::size_t j = 0; j < 4; ++j)
            text += j <= n ? digits[triplet >> (18 - 6 * j) & 63] : '=';
        }
      return text;
    }

    /**
     * Bytes in blocks that are compressed one by one, behind a header: the
     * number of blocks, the size of a block, that of the last one unless it is
     * whole, the sizes after compression.
     */
    std::string
    compressed(const char *bytes, const std::size_t size)
    {
      constexpr std::size_t block = 1 << 15; // as VTK itself
      std::vector<std::uint32_t> header(3);
      header[0] = (size + block - 1) / block;
      header[1] = block;
      header[2] = size % block;
      std::string blocks;
      std::vector<Bytef> buffer(compressBound(block));
      for (std::size_t begin = 0; begin < size; begin += block)
        {
          uLongf length = buffer.size();
          // The best compression takes several times as long and saves little.
          if (compress2(buffer.data(),
                        &length,
                        reinterpret_cast<const Bytef *>(bytes) + begin,
                        std::min(block, size - begin),
                        Z_BEST_SPEED) != Z_OK)
            throw std::bad_alloc();
          header.push_back(length);
          blocks.append(reinterpret_cast<const char *>(buffer.data()), length);
        }
      return base64({reinterpret_cast<const char *>(header.data()),
                     header.size() * sizeof(std::uint32_t)}) +
             base64(blocks);
    }

    // VTK's names of the types of numbers.

    const char *
    type_name(double)
    {
      return "Float64";
    }

    const char *
    type_name(std::int32_t)
    {
      return "Int32";
    }

    const char *
    type_name(std::int64_t)
    {
      return "Int64";
    }

    const char *
    type_name(VtkCell)
    {
      return "UInt8";
    }

    template <typename Number>
    void
    write_numbers(std::ostream &file,
                  const std::string &attributes,
                  const Number *numbers,
                  const std::size_t size)
    {
      file << "<DataArray type=\"" << type_name(Number()) << '"' << attributes
           << " format=\"binary\">\n"
           << compressed(reinterpret_cast<const char *>(numbers),
                         size * sizeof(Number))
           << "\n</DataArray>\n";
    }

    std::string
    name_attribute(const std::string &name)
    {
      return " Name=\"" + escaped(name) + '"';
    }

    std::string
    components_attribute(const Eigen::Index n_components)
    {
      return n_components == 1
               ? std::string()
               : " NumberOfComponents=\"" + std::to_string(n_components) + '"';
    }

    void
    write_arrays(std::ostream &file, const std::vector<VtuArray> &arrays)
    {
      for (const auto &array : arrays)
        std::visit(
          [&](const auto &values) {
            write_numbers(file,
                          name_attribute(array.name) +
                            components_attribute(values.rows()),
                          values.data(),
                          values.size());
          },
          array.values);
    }

    void
    check_finite(const bool is_finite,
                 const std::string &name,
                 const std::filesystem::path &path)
    {
      if (!is_finite)
        throw RunError("A result that belongs into the file '" +
                         path.filename().string() + "' as '" + name +
                         "' is not a finite number.",
                       "This should not happen: please report it with the "
                       "parameter file.");
    }

    void
    check(const std::vector<VtuArray> &arrays,
          const std::size_t size,
          const std::filesystem::path &path)
    {
      for (const auto &array : arrays)
        std::visit(
          [&](const auto &values) {
            if (values.cols() != static_cast<Eigen::Index>(size))
              throw std::logic_error(
                "'" + array.name + "' has " + std::to_string(values.cols()) +
                " columns for " + std::to_string(size) + " points or cells");
            check_finite(values.allFinite(), array.name, path);
          },
          array.values);
    }
  } // namespace

  void
  add_cell(UnstructuredGrid &grid,
           const VtkCell type,
           const std::vector<unsigned int> &points)
  {
    grid.connectivity.insert(grid.connectivity.end(),
                             points.begin(),
                             points.end());
    grid.offsets.push_back(grid.connectivity.size());
    grid.types.push_back(type);
  }

  UnstructuredGrid
  without_loose_points(const UnstructuredGrid &grid)
  {
    std::vector<int> new_number(grid.points.cols(), -1);
    for (const auto point : grid.connectivity)
      new_number[point] = 0;
    std::vector<Eigen::Index> kept;
    for (std::size_t point = 0; point < new_number.size(); ++point)
      if (new_number[point] == 0)
        {
          new_number[point] = kept.size();
          kept.push_back(point);
        }

    UnstructuredGrid result = grid;
    result.points           = grid.points(Eigen::all, kept);
    for (auto &point : result.connectivity)
      point = new_number[point];
    for (std::size_t a = 0; a < grid.point_data.size(); ++a)
      std::visit(
        [&](const auto &values) {
          result.point_data[a].values = values(Eigen::all, kept).eval();
        },
        grid.point_data[a].values);
    return result;
  }

  void
  write_vtu(const std::filesystem::path &path, const UnstructuredGrid &grid)
  {
    const std::size_t n_points = grid.points.cols();
    const std::size_t n_cells  = grid.types.size();
    check_finite(grid.points.allFinite(), "points", path);
    check(grid.point_data, n_points, path);
    check(grid.cell_data, n_cells, path);

    write_file(path, [&](std::ostream &file) {
      file << "<?xml version=\"1.0\"?>\n"
           << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
           << byte_order()
           << "\" header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\">"
           << "\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << n_points
           << "\" NumberOfCells=\"" << n_cells << "\">\n<Points>\n";
      write_numbers(file,
                    components_attribute(3),
                    grid.points.data(),
                    grid.points.size());
      file << "</Points>\n<Cells>\n";
      write_numbers(file,
                    name_attribute("connectivity"),
                    grid.connectivity.data(),
                    grid.connectivity.size());
      write_numbers(file,
                    name_attribute("offsets"),
                    grid.offsets.data(),
                    grid.offsets.size());
      write_numbers(file,
                    name_attribute("types"),
                    grid.types.data(),
                    grid.types.size());
      file << "</Cells>\n<PointData>\n";
      write_arrays(file, grid.point_data);
      file << "</PointData>\n<CellData>\n";
      write_arrays(file, grid.cell_data);
      file << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    });
  }

  void
  write_pvd(const std::filesystem::path &path,
            const std::vector<std::pair<double, std::string>> &files)
  {
    write_file(path, [&](std::ostream &series) {
      series << "<?xml version=\"1.0\"?>\n"
             << "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\""
             << byte_order() << "\">\n<Collection>\n";
      for (const auto &[place, file] : files)
        series << "<DataSet timestep=\"" << shortest(place)
               << "\" group=\"\" part=\"0\" file=\"" << escaped(file)
               << "\"/>\n";
      series << "</Collection>\n</VTKFile>\n";
    });
  }
} // namespace springfit
