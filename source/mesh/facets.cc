#include <springfit/core/error.h>
#include <springfit/mesh/cell_names.h>
#include <springfit/mesh/facets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace springfit
{
  namespace
  {
    constexpr unsigned int none = static_cast<unsigned int>(-1);

    struct Side
    {
      std::array<unsigned int, 4> vertices; // ascending, padded with none
      unsigned int number;                  // in the order of the cells
      unsigned int cell;

      bool
      operator<(const Side &other) const
      {
        return vertices != other.vertices ? vertices < other.vertices
                                          : number < other.number;
      }
    };

    std::vector<Side>
    all_sides(const MeshDescription &mesh)
    {
      const auto &sides = sides_of(mesh.cell_kind);
      std::vector<Side> result;
      result.reserve(std::size_t(mesh.n_cells()) * sides.size());
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        for (const auto &positions : sides)
          {
            Side side{{none, none, none, none},
                      static_cast<unsigned int>(result.size()),
                      c};
            for (unsigned int i = 0; i < positions.size(); ++i)
              side.vertices[i] = mesh.cell(c)[positions[i]];
            std::sort(side.vertices.begin(), side.vertices.end());
            result.push_back(side);
          }
      return result;
    }
  } // namespace


  const std::vector<std::vector<unsigned int>> &
  sides_of(const CellKind kind)
  {
    using Sides = std::vector<std::vector<unsigned int>>;

    static const Sides triangle      = {{0, 1}, {1, 2}, {2, 0}};
    static const Sides quadrilateral = {{0, 2}, {1, 3}, {0, 1}, {2, 3}};
    static const Sides tetrahedron   = {{0, 1, 2},
                                        {0, 1, 3},
                                        {0, 2, 3},
                                        {1, 2, 3}};
    static const Sides hexahedron    = {{0, 2, 4, 6},
                                        {1, 3, 5, 7},
                                        {0, 1, 4, 5},
                                        {2, 3, 6, 7},
                                        {0, 1, 2, 3},
                                        {4, 5, 6, 7}};
    switch (kind)
      {
        case CellKind::triangle:
          return triangle;
        case CellKind::quadrilateral:
          return quadrilateral;
        case CellKind::tetrahedron:
          return tetrahedron;
        case CellKind::hexahedron:
          return hexahedron;
      }
    throw std::logic_error("a kind of cell has no sides");
  }


  std::vector<CellSide>
  boundary_cell_sides(const MeshDescription &mesh)
  {
    std::vector<Side> sides = all_sides(mesh);
    std::sort(sides.begin(), sides.end());

    std::vector<unsigned int> single; // numbers in the order of the cells
    for (std::size_t i = 0; i < sides.size();)
      {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].vertices == sides[i].vertices)
          ++end;
        if (end - i > 2)
          throw InputError(
            mesh.name + " has a side that " + std::to_string(end - i) +
              " cells share, one of them " +
              describe_cell(mesh, sides[i].cell) + ".",
            "At most two cells may meet there: look for cells that overlap" +
              std::string(dimension(mesh.cell_kind) == 2
                            ? ", or for a surface that branches."
                            : "."));
        if (end - i == 1)
          single.push_back(sides[i].number);
        i = end;
      }
    std::sort(single.begin(), single.end());

    const unsigned int n_sides = sides_of(mesh.cell_kind).size();
    std::vector<CellSide> result;
    result.reserve(single.size());
    for (const unsigned int number : single)
      result.push_back({number / n_sides, number % n_sides});
    return result;
  }


  std::vector<std::vector<unsigned int>>
  boundary_sides(const MeshDescription &mesh)
  {
    std::vector<std::vector<unsigned int>> result;
    for (const CellSide &place : boundary_cell_sides(mesh))
      {
        std::vector<unsigned int> vertices;
        for (const unsigned int i : sides_of(mesh.cell_kind)[place.side])
          vertices.push_back(mesh.cell(place.cell)[i]);
        std::sort(vertices.begin(), vertices.end());
        result.push_back(std::move(vertices));
      }
    return result;
  }


  void
  label_boundary(
    MeshDescription &mesh,
    const std::function<unsigned int(const std::vector<MeshPoint> &)> &id_of)
  {
    mesh.facets.clear();
    for (auto &vertices : boundary_sides(mesh))
      {
        std::vector<MeshPoint> points;
        for (const unsigned int v : vertices)
          points.push_back(mesh.vertices[v]);
        mesh.facets.push_back({std::move(vertices), id_of(points)});
      }
  }
} // namespace springfit
