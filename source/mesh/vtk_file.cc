#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/mesh/file_elements.h>
#include <springfit/mesh/mesh_text.h>
#include <springfit/mesh/vtk_file.h>
#include <springfit/mesh/vtk_stream.h>

#include <cmath>
#include <map>
#include <optional>

namespace springfit
{
  namespace
  {
    struct CellType
    {
      std::string name;
      int dim;
      unsigned int n_nodes; // 0 if it varies
      std::optional<CellKind> kind;
      std::vector<unsigned int> order; // around a face; empty if it is so
    };

    const std::map<unsigned int, CellType> &
    cell_types()
    {
      static const std::map<unsigned int, CellType> types = {
        {1, {"vertex", 0, 1, {}, {}}},
        {2, {"poly-vertex", 0, 0, {}, {}}},
        {3, {"line", 1, 2, {}, {}}},
        {4, {"poly-line", 1, 0, {}, {}}},
        {5, {"triangle", 2, 3, CellKind::triangle, {}}},
        {6, {"triangle strip", 2, 0, {}, {}}},
        {7, {"polygon", 2, 0, {}, {}}},
        {8, {"pixel", 2, 4, CellKind::quadrilateral, {0, 1, 3, 2}}},
        {9, {"quad", 2, 4, CellKind::quadrilateral, {}}},
        {10, {"tetrahedron", 3, 4, CellKind::tetrahedron, {}}},
        {11, {"voxel", 3, 8, CellKind::hexahedron, {0, 1, 3, 2, 4, 5, 7, 6}}},
        {12, {"hexahedron", 3, 8, CellKind::hexahedron, {}}},
        {13, {"wedge", 3, 6, {}, {}}},
        {14, {"pyramid", 3, 5, {}, {}}},
        {21, {"quadratic edge", 1, 3, {}, {}}},
        {22, {"quadratic triangle", 2, 6, {}, {}}},
        {23, {"quadratic quad", 2, 8, {}, {}}},
        {24, {"quadratic tetrahedron", 3, 10, {}, {}}},
        {25, {"quadratic hexahedron", 3, 20, {}, {}}}};
      return types;
    }

    class Reader
    {
    public:
      Reader(const std::filesystem::path &file, const std::string &name)
        : name_(name), stream_(file, name)
      {}

      void
      read()
      {
        for (std::string word = stream_.keyword(); !word.empty();
             word             = stream_.keyword())
          read_section(word);
        if (offsets_.size() != types_.size() + 1)
          throw stream_.error("it has " + std::to_string(n_cells()) +
                              " cells and " + std::to_string(types_.size()) +
                              " cell types");
      }

      std::vector<FileElements>
      elements(const std::vector<double> &ids) const
      {
        std::map<unsigned int, FileElements> by_type;
        for (std::size_t c = 0; c < types_.size(); ++c)
          {
            const auto known = cell_types().find(types_[c]);
            if (known == cell_types().end())
              throw stream_.error("cells of the type number " +
                                  std::to_string(types_[c]) + " are not known");
            const CellType &type = known->second;
            const std::size_t n  = offsets_[c + 1] - offsets_[c];
            if (type.n_nodes > 0 && n != type.n_nodes)
              throw stream_.error("cell " + std::to_string(c) + ", a " +
                                  type.name + ", has " + std::to_string(n) +
                                  " points");
            FileElements &of_type =
              by_type
                .emplace(
                  types_[c],
                  FileElements{
                    type.name, type.dim, type.n_nodes, type.kind, {}, {}, {}})
                .first->second;
            of_type.numbers.push_back(c);
            of_type.ids.push_back(ids.empty() ? 0 : id_of(ids[c], c));
            for (unsigned int i = 0; i < type.n_nodes; ++i)
              of_type.nodes.push_back(
                connectivity_[offsets_[c] +
                              (type.order.empty() ? i : type.order[i])]);
          }
        // Pixels and quads are one kind of cells, and so are voxels and bricks.
        for (const auto &[from, to] : {std::make_pair(8u, 9u), {11u, 12u}})
          if (by_type.count(from) > 0)
            append(by_type, from, to);
        std::vector<FileElements> result;
        for (const auto &[number, of_type] : by_type)
          result.push_back(of_type);
        return result;
      }

      std::vector<MeshPoint> points;
      std::map<std::string, std::vector<double>> cell_arrays;

    private:
      std::size_t
      n_cells() const
      {
        return offsets_.empty() ? 0 : offsets_.size() - 1;
      }

      static void
      append(std::map<unsigned int, FileElements> &by_type,
             const unsigned int from,
             const unsigned int to)
      {
        const FileElements more = by_type.at(from);
        by_type.erase(from);
        const auto [place, is_new] = by_type.emplace(to, more);
        if (is_new)
          return;
        FileElements &all = place->second;
        all.numbers.insert(all.numbers.end(),
                           more.numbers.begin(),
                           more.numbers.end());
        all.ids.insert(all.ids.end(), more.ids.begin(), more.ids.end());
        all.nodes.insert(all.nodes.end(), more.nodes.begin(), more.nodes.end());
      }

      unsigned int
      id_of(const double value, const std::size_t cell) const
      {
        if (value != std::floor(value) || value < 0. || value > 4e9)
          throw stream_.error("the id of cell " + std::to_string(cell) +
                              " is no whole number from 0 to 4e9");
        return static_cast<unsigned int>(value);
      }

      void
      read_section(const std::string &word)
      {
        if (word == "DATASET")
          {
            const std::string kind = stream_.keyword();
            if (kind != "UNSTRUCTURED_GRID")
              throw InputError(name_ + " is a " + kind.substr(0, 60) +
                                 ", not an UNSTRUCTURED_GRID.",
                               "The filter 'Append Datasets' of ParaView makes "
                               "one of it: save that as .vtk.");
          }
        else if (word == "POINTS")
          read_points();
        else if (word == "CELLS")
          read_cells();
        else if (word == "CELL_TYPES")
          {
            const std::size_t n = stream_.count();
            types_.clear();
            for (const double type : stream_.numbers(n, "int"))
              types_.push_back(type < 0. || type > 1000. ? 0 : unsigned(type));
          }
        else if (word == "METADATA")
          stream_.skip_paragraph();
        else if (word == "FIELD")
          read_field();
        else if (word == "CELL_DATA" || word == "POINT_DATA")
          {
            is_of_cells_ = word == "CELL_DATA";
            n_data_      = stream_.count();
            if (is_of_cells_ && n_data_ != n_cells())
              throw stream_.error("it announces data of " +
                                  std::to_string(n_data_) + " cells, but has " +
                                  std::to_string(n_cells()) + " cells");
          }
        else if (word == "SCALARS")
          read_scalars();
        else if (word == "VECTORS" || word == "NORMALS")
          skip_array(3);
        else if (word == "TENSORS")
          skip_array(9);
        else if (word == "LOOKUP_TABLE")
          {
            stream_.word();
            const std::size_t n = stream_.count();
            stream_.numbers(4 * n, "unsigned_char");
          }
        else if (word == "TEXTURE_COORDINATES")
          {
            stream_.word();
            const std::size_t n = stream_.count();
            stream_.numbers(n * n_data_, stream_.word());
          }
        else if (word == "COLOR_SCALARS")
          {
            stream_.word();
            const std::size_t n = stream_.count();
            stream_.numbers(n * n_data_, "unsigned_char");
          }
        else
          throw stream_.error("'" + word.substr(0, 60) +
                              "' stands where a keyword should");
      }

      void
      read_points()
      {
        const std::size_t n    = stream_.count();
        const std::string type = stream_.word();
        const auto values      = stream_.numbers(3 * n, type);
        points.resize(n);
        for (std::size_t i = 0; i < n; ++i)
          points[i] = {{values[3 * i], values[3 * i + 1], values[3 * i + 2]}};
      }

      void
      read_cells()
      {
        const std::size_t first  = stream_.count();
        const std::size_t second = stream_.count();
        if (stream_.version() >= 5)
          read_offsets(first, second);
        else
          read_lists(first, second);
        for (const std::size_t node : connectivity_)
          if (node >= points.size())
            throw stream_.error("a cell has the point " + std::to_string(node) +
                                ", but there are " +
                                std::to_string(points.size()));
      }

      std::size_t
      index_of(const double value) const
      {
        if (!(value >= 0.) || value != std::floor(value) || value > 9e15)
          throw stream_.error("a cell has a point that is no number >= 0");
        return static_cast<std::size_t>(value);
      }

      void
      read_offsets(const std::size_t n_offsets, const std::size_t n_entries)
      {
        if (stream_.keyword() != "OFFSETS")
          throw stream_.error("CELLS is not followed by OFFSETS");
        std::string type = stream_.word();
        offsets_.clear();
        for (const double value : stream_.numbers(n_offsets, type))
          offsets_.push_back(index_of(value));
        if (stream_.keyword() != "CONNECTIVITY")
          throw stream_.error("OFFSETS is not followed by CONNECTIVITY");
        type = stream_.word();
        connectivity_.clear();
        for (const double value : stream_.numbers(n_entries, type))
          connectivity_.push_back(index_of(value));
        for (std::size_t i = 0; i < offsets_.size(); ++i)
          if (offsets_[i] > n_entries ||
              (i == 0 ? offsets_[i] != 0 : offsets_[i] < offsets_[i - 1]) ||
              (i + 1 == offsets_.size() && offsets_[i] != n_entries))
            throw stream_.error("the offsets of the cells do not fit their "
                                "connectivity");
      }

      void
      read_lists(const std::size_t n, const std::size_t n_entries)
      {
        const auto values = stream_.numbers(n_entries, "int");
        offsets_          = {0};
        connectivity_.clear();
        std::size_t at = 0;
        for (std::size_t c = 0; c < n; ++c)
          {
            if (at >= n_entries || index_of(values[at]) > n_entries - at - 1)
              throw stream_.error("the lists of the " + std::to_string(n) +
                                  " cells announced do not fit into " +
                                  std::to_string(n_entries) + " numbers");
            const std::size_t n_points = index_of(values[at++]);
            for (std::size_t i = 0; i < n_points; ++i)
              connectivity_.push_back(index_of(values[at++]));
            offsets_.push_back(connectivity_.size());
          }
        if (at != n_entries)
          throw stream_.error("the lists of the " + std::to_string(n) +
                              " cells announced take " + std::to_string(at) +
                              " numbers, not " + std::to_string(n_entries));
      }

      void
      keep(const std::string &array,
           const std::size_t n_components,
           std::vector<double> &&values)
      {
        if (is_of_cells_ && n_components == 1)
          cell_arrays[array] = std::move(values);
      }

      void
      read_scalars()
      {
        const std::string array = stream_.word();
        const std::string type  = stream_.word();
        const std::size_t n = stream_.goes_on_in_line() ? stream_.count() : 1;
        if (stream_.keyword() != "LOOKUP_TABLE")
          throw stream_.error("SCALARS is not followed by LOOKUP_TABLE");
        stream_.word();
        keep(array, n, stream_.numbers(n * n_data_, type));
      }

      void
      read_field()
      {
        stream_.word();
        const std::size_t n_arrays = stream_.count();
        for (std::size_t a = 0; a < n_arrays; ++a)
          {
            std::string array = stream_.word();
            while (in_capitals(array) == "METADATA")
              {
                stream_.skip_paragraph();
                array = stream_.word();
              }
            const std::size_t n_components = stream_.count();
            const std::size_t n            = stream_.count();
            const std::string type         = stream_.word();
            if (in_capitals(type) == "STRING")
              for (std::size_t i = 0; i < n; ++i)
                stream_.skip_line();
            auto values = stream_.numbers(
              in_capitals(type) == "STRING" ? 0 : n_components * n, type);
            if (n == n_data_)
              keep(array, n_components, std::move(values));
          }
      }

      void
      skip_array(const std::size_t n_components)
      {
        stream_.word();
        const std::string type = stream_.word();
        stream_.numbers(n_components * n_data_, type);
      }

      const std::string name_;
      VtkStream stream_;
      std::vector<std::size_t> offsets_ = {0}, connectivity_;
      std::vector<unsigned int> types_;
      bool is_of_cells_   = false;
      std::size_t n_data_ = 0;
    };

    std::vector<std::string>
    names_of(const std::map<std::string, std::vector<double>> &arrays)
    {
      std::vector<std::string> names;
      for (const auto &[array, values] : arrays)
        names.push_back('\'' + array + '\'');
      return names;
    }
  } // namespace


  MeshDescription
  read_vtk_file(const std::filesystem::path &file,
                const std::string &name,
                const int dim,
                const std::string &id_array)
  {
    Reader reader(file, name);
    reader.read();
    const auto names = names_of(reader.cell_arrays);
    const auto array = reader.cell_arrays.find(id_array);
    if (!id_array.empty() && array == reader.cell_arrays.end())
      throw EntryError("Geometry/Material ids",
                       name + " has no cell array '" + id_array + "'.",
                       names.empty() ? "Leave it empty: there are none."
                                     : "There are: " + join_some(names) + '.');
    const auto elements =
      reader.elements(id_array.empty() ? std::vector<double>() : array->second);
    MeshOfElements result =
      mesh_of_elements(name, dim, reader.points, elements);
    label_sides(result, elements);
    MeshDescription &mesh = result.mesh;
    if (id_array.empty() && !names.empty())
      mesh.warnings.push_back(
        name + " has the cell arrays " + join_some(names) +
        ": if one tells materials and boundaries apart, name it by "
        "Geometry/Material ids. All ids are 0.");
    return std::move(mesh);
  }
} // namespace springfit
