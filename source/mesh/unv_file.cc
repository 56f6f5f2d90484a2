#include <springfit/mesh/boundary_groups.h>
#include <springfit/mesh/mesh_text.h>
#include <springfit/mesh/numbered_elements.h>
#include <springfit/mesh/unv_data.h>
#include <springfit/mesh/unv_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

namespace springfit
{
  namespace
  {
    // Types differ in what the material does; the shape follows from the number
    // of nodes, and from whether they have some between the corners.
    FileElements
    shape_of(const UnvElement &element)
    {
      const int dim              = element.dim;
      const unsigned int n_nodes = element.nodes.size();
      static const std::map<std::pair<int, unsigned int>, CellKind> kinds = {
        {{2, 3}, CellKind::triangle},
        {{2, 4}, CellKind::quadrilateral},
        {{3, 4}, CellKind::tetrahedron},
        {{3, 8}, CellKind::hexahedron}};
      FileElements shape{std::to_string(element.type) + " with " +
                           std::to_string(n_nodes) + " nodes",
                         dim,
                         n_nodes,
                         {},
                         {},
                         {},
                         {}};
      const auto kind = kinds.find({dim, n_nodes});
      if (kind != kinds.end())
        {
          shape.cell_kind = kind->second;
          shape.type      = singular(kind->second);
        }
      return shape;
    }

    // The material's number if any element of the dimension has one, as gmsh
    // writes it, else the property's.
    NumberedElements
    number_elements(const UnvData &data)
    {
      NumberedElements numbered;
      for (const UnvNode &node : data.nodes)
        numbered.add_node(node.number, node.point, node.place);
      std::array<bool, 4> has_material{};
      for (const UnvElement &element : data.elements)
        has_material[element.dim] =
          has_material[element.dim] || element.material > 0;
      for (const UnvElement &element : data.elements)
        {
          const long id =
            has_material[element.dim] ? element.material : element.property;
          numbered.add_element(shape_of(element),
                               element.number,
                               checked_id(id,
                                          has_material[element.dim]
                                            ? "the material"
                                            : "the property",
                                          element.place),
                               element.nodes,
                               element.place);
        }
      return numbered;
    }

    /** What the groups say of one mesh. */
    class Grouping
    {
    public:
      Grouping(const std::vector<UnvGroup> &groups, NumberedElements &numbered)
        : numbered_(numbered), mesh_(numbered.mesh())
      {
        for (const UnvGroup &group : groups)
          take(group);
      }

      void
      label()
      {
        if (boundaries_.empty())
          numbered_.label_sides_by_ids();
        else
          label_boundary_groups(mesh_, boundaries_);
        for (const std::string &name : names_of_cells_)
          mesh_.unused_boundary_names.emplace(name, "is a group of cells");
        if (!names_of_cells_.empty())
          label_materials();
        if (!missing_.empty())
          warn("there are groups with members that the file does not define: " +
               join_some(missing_) + "; these are left out.");
      }

    private:
      void
      warn(const std::string &what)
      {
        mesh_.warnings.push_back(mesh_.name + ": " + what);
      }

      void
      take(const UnvGroup &group)
      {
        BoundaryGroup boundary{group.name, {}, {}, group.number};
        std::vector<unsigned int> cells;
        std::size_t n_missing = 0;
        for (const UnvMember &member : group.members)
          if (member.is_node && !numbered_.has_node(member.number))
            ++n_missing;
          else if (member.is_node)
            {
              if (const auto vertex = numbered_.vertex_of(member.number))
                boundary.vertices.push_back(*vertex);
            }
          else if (!numbered_.has_element(member.number))
            ++n_missing;
          else if (const auto side = numbered_.side_of(member.number))
            boundary.sides.push_back(*side);
          else if (const auto cell = numbered_.cell_of(member.number))
            cells.push_back(*cell);

        if (n_missing > 0)
          missing_.push_back('\'' + group.name + "' (" +
                             std::to_string(n_missing) + ')');
        if (!cells.empty())
          {
            names_of_cells_.push_back(group.name);
            materials_.push_back({group.number, cells});
          }
        if (!boundary.sides.empty() || !boundary.vertices.empty())
          boundaries_.push_back(boundary);
        else if (cells.empty())
          mesh_.unused_boundary_names[group.name] = "holds no side of a cell";
      }

      void
      label_materials()
      {
        std::vector<std::size_t> group_of_cell(mesh_.n_cells(), none);
        std::size_t n_overlaps = 0;
        std::vector<std::string> overlaps;
        for (std::size_t g = 0; g < materials_.size(); ++g)
          for (const unsigned int cell : materials_[g].second)
            if (group_of_cell[cell] == none)
              group_of_cell[cell] = g;
            else if (group_of_cell[cell] != g)
              {
                ++n_overlaps;
                const std::string both = '\'' +
                                         names_of_cells_[group_of_cell[cell]] +
                                         "' and '" + names_of_cells_[g] + '\'';
                if (std::find(overlaps.begin(), overlaps.end(), both) ==
                    overlaps.end())
                  overlaps.push_back(both);
              }

        const auto ids = ids_of_materials();
        const std::set<std::size_t> used(group_of_cell.begin(),
                                         group_of_cell.end());
        mesh_.material_names.clear();
        for (std::size_t g = 0; g < materials_.size(); ++g)
          if (used.count(g) > 0)
            mesh_.material_names.emplace(ids[g], names_of_cells_[g]);
          else
            mesh_.unused_material_names[names_of_cells_[g]] =
              "holds only cells of groups that stand before it";
        for (unsigned int cell = 0; cell < mesh_.n_cells(); ++cell)
          mesh_.material_ids[cell] =
            group_of_cell[cell] == none ? 0 : ids[group_of_cell[cell]];

        if (n_overlaps > 0)
          warn(std::to_string(n_overlaps) + " cells belong to two groups, " +
               join_some(overlaps) + "; the first one counts.");
        const auto n_without =
          std::count(group_of_cell.begin(), group_of_cell.end(), none);
        if (n_without > 0)
          warn(std::to_string(n_without) +
               " cells belong to no group; their material id is 0.");
      }

      /** The groups' own numbers, or free ones where they are not unique. */
      std::vector<unsigned int>
      ids_of_materials() const
      {
        std::set<unsigned int> taken = {0};
        for (const auto &[number, cells] : materials_)
          taken.insert(number);
        std::set<unsigned int> given = {0};
        std::vector<unsigned int> ids;
        for (const auto &[number, cells] : materials_)
          {
            unsigned int id = number;
            if (given.count(id) > 0)
              for (id = 1; taken.count(id) > 0;)
                ++id;
            taken.insert(id);
            given.insert(id);
            ids.push_back(id);
          }
        return ids;
      }

      static constexpr std::size_t none = -1;

      NumberedElements &numbered_;
      MeshDescription &mesh_;
      std::vector<BoundaryGroup> boundaries_;
      std::vector<std::string> names_of_cells_; // one for each of materials_
      std::vector<std::pair<unsigned int, std::vector<unsigned int>>>
        materials_;
      std::vector<std::string> missing_;
    };
  } // namespace


  MeshDescription
  read_unv_file(const std::filesystem::path &file,
                const std::string &name,
                const int dim,
                const double scale)
  {
    const UnvData data        = read_unv_data(file);
    NumberedElements numbered = number_elements(data);
    numbered.make_mesh(name, dim);
    Grouping(data.groups, numbered).label();
    MeshDescription &mesh = numbered.mesh();
    if (!data.n_shapeless.empty())
      {
        std::vector<std::string> counts;
        for (const auto &[type, n] : data.n_shapeless)
          counts.push_back(std::to_string(n) + " of type " +
                           std::to_string(type));
        mesh.warnings.push_back(name +
                                ": elements without a shape are left out: " +
                                join_some(counts) + '.');
      }
    if (!data.ignored.empty())
      mesh.warnings.push_back(
        name + ": data sets of no meaning to springfit and passed over: " +
        join_some({data.ignored.begin(), data.ignored.end()}) + '.');
    const double unit = data.unit.value_or(1.);
    if (std::abs(unit - 1.) > 1e-6 && std::abs(unit / scale - 1.) > 1e-6)
      {
        std::ostringstream text;
        text << name << " states that its unit of length is " << unit
             << " m. Should Geometry/Scale be " << unit << " instead of "
             << scale << '?';
        mesh.warnings.push_back(text.str());
      }
    return std::move(mesh);
  }
} // namespace springfit
