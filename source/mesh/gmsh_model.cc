#include <springfit/core/error.h>
#include <springfit/mesh/gmsh_model.h>
#include <springfit/mesh/vertex_order.h>

#include <gmsh.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    const std::map<int, CellKind> &
    kind_of_element_type()
    {
      static const std::map<int, CellKind> kinds = {{2, CellKind::triangle},
                                                    {3,
                                                     CellKind::quadrilateral},
                                                    {4, CellKind::tetrahedron},
                                                    {5, CellKind::hexahedron}};
      return kinds;
    }

    struct ElementType
    {
      std::string name;
      int order;
      int n_nodes;
    };

    ElementType
    properties(const int type)
    {
      ElementType result;
      int dim, n_primary_nodes;
      std::vector<double> local_coordinates;
      gmsh::model::mesh::getElementProperties(type,
                                              result.name,
                                              dim,
                                              result.order,
                                              result.n_nodes,
                                              local_coordinates,
                                              n_primary_nodes);
      return result;
    }

    /** Elements of one type of one surface or volume. */
    struct Elements
    {
      int entity;
      std::vector<std::size_t> numbers;
      std::vector<std::size_t> nodes;
    };

    std::map<int, std::vector<Elements>>
    elements_by_type(const int dim)
    {
      std::map<int, std::vector<Elements>> result;
      gmsh::vectorpair entities;
      gmsh::model::getEntities(entities, dim);
      for (const auto &[entity_dim, entity] : entities)
        {
          std::vector<int> types;
          std::vector<std::vector<std::size_t>> numbers, nodes;
          gmsh::model::mesh::getElements(types, numbers, nodes, dim, entity);
          for (unsigned int i = 0; i < types.size(); ++i)
            if (!numbers[i].empty())
              result[types[i]].push_back(
                {entity, std::move(numbers[i]), std::move(nodes[i])});
        }
      return result;
    }

    std::size_t
    n_elements(const std::vector<Elements> &groups)
    {
      std::size_t n = 0;
      for (const Elements &elements : groups)
        n += elements.numbers.size();
      return n;
    }

    std::string
    found_elements(const std::map<int, std::vector<Elements>> &elements)
    {
      std::vector<std::string> found;
      for (const auto &[type, groups] : elements)
        found.push_back(std::to_string(n_elements(groups)) + " of type '" +
                        properties(type).name + "'");
      return join(found);
    }

    void
    check_types(const std::string &name,
                const std::map<int, std::vector<Elements>> &elements)
    {
      for (const auto &[type, groups] : elements)
        if (properties(type).order > 1)
          throw InputError(name + " has cells of order " +
                             std::to_string(properties(type).order) + " (" +
                             found_elements(elements) + ").",
                           "springfit needs cells with straight edges: convert "
                           "the mesh with 'gmsh -order 1', or mesh the object "
                           "so.");
      if (elements.size() > 1)
        throw InputError(name + " has mixed cell types: " +
                           found_elements(elements) + ".",
                         "Mesh the object with cells of one type.");
      if (kind_of_element_type().count(elements.begin()->first) == 0)
        throw InputError(name + " has cells that springfit does not know: " +
                           found_elements(elements) + ".",
                         "Use " + join(words_of(cell_kind_words())) + ".");
    }

    void
    add_cells(GmshCells &result, const Elements &elements)
    {
      MeshDescription &mesh = result.mesh;
      const auto &order     = order_around_faces(mesh.cell_kind);
      const unsigned int n  = order.size();

      mesh.group_begins.push_back(mesh.n_cells());
      result.entities.push_back(elements.entity);
      mesh.cell_numbers.insert(mesh.cell_numbers.end(),
                               elements.numbers.begin(),
                               elements.numbers.end());
      for (std::size_t c = 0; c < elements.numbers.size(); ++c)
        for (unsigned int i = 0; i < n; ++i)
          mesh.cells.push_back(
            result.vertex_of_node.at(elements.nodes[c * n + order[i]]));
    }

    /** Fill the vertices with the nodes that @p groups use. */
    void
    add_vertices(GmshCells &result, const std::vector<Elements> &groups)
    {
      std::vector<std::size_t> used;
      for (const Elements &elements : groups)
        used.insert(used.end(), elements.nodes.begin(), elements.nodes.end());
      std::sort(used.begin(), used.end());
      used.erase(std::unique(used.begin(), used.end()), used.end());
      for (unsigned int v = 0; v < used.size(); ++v)
        result.vertex_of_node[used[v]] = v;

      std::vector<std::size_t> nodes;
      std::vector<double> coordinates, parameters;
      gmsh::model::mesh::getNodes(
        nodes, coordinates, parameters, -1, -1, false, false);
      result.mesh.vertices.resize(used.size());
      for (std::size_t i = 0; i < nodes.size(); ++i)
        {
          const auto vertex = result.vertex_of_node.find(nodes[i]);
          if (vertex != result.vertex_of_node.end())
            result.mesh.vertices[vertex->second] = {{coordinates[3 * i],
                                                     coordinates[3 * i + 1],
                                                     coordinates[3 * i + 2]}};
        }
      if (nodes.size() > used.size())
        result.mesh.warnings.push_back(
          std::to_string(nodes.size() - used.size()) + " of the " +
          std::to_string(nodes.size()) +
          " nodes of the mesh belong to no cell and are left out; the others "
          "are numbered from 0 in the order of their numbers there.");
    }
  } // namespace


  GmshSession::GmshSession()
  {
    gmsh::initialize(0, nullptr, /*readConfigFiles=*/false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.RandomSeed", 1);
    gmsh::option::setNumber("Mesh.Algorithm", 6);   // frontal Delaunay
    gmsh::option::setNumber("Mesh.Algorithm3D", 1); // Delaunay
  }


  GmshSession::~GmshSession()
  {
    gmsh::finalize();
  }


  void
  set_gmsh_cell_size(const double cell_size)
  {
    gmsh::option::setNumber("Mesh.MeshSizeMin", cell_size);
    gmsh::option::setNumber("Mesh.MeshSizeMax", cell_size);
  }


  int
  add_gmsh_spline(const int first,
                  const std::vector<MeshPoint> &between,
                  const int last)
  {
    gmsh::vectorpair helpers;
    std::vector<int> points = {first};
    for (const MeshPoint &p : between)
      {
        points.push_back(gmsh::model::occ::addPoint(p[0], p[1], p[2]));
        helpers.emplace_back(0, points.back());
      }
    points.push_back(last);
    const int spline = gmsh::model::occ::addSpline(points);
    gmsh::model::occ::remove(helpers); // or they would become nodes
    return spline;
  }


  void
  make_gmsh_quadrilaterals()
  {
    gmsh::option::setNumber("Mesh.RecombineAll", 1);
    // Blossom, and a subdivision that leaves no triangle.
    gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 3);
  }


  void
  mesh_gmsh_model(const std::string &name, const int dim)
  {
    try
      {
        gmsh::model::mesh::generate(dim);
      }
    catch (...)
      {
        std::string complaint;
        gmsh::logger::getLastError(complaint);
        throw InputError(name + ": gmsh could not mesh it (" + complaint + ").",
                         "Another Geometry/Cell size may help.");
      }
  }


  GmshCells
  read_gmsh_cells(const std::string &name, const int dim)
  {
    const auto elements = elements_by_type(dim);
    GmshCells result;
    result.mesh.name = name;
    if (elements.empty())
      throw InputError(name + " has no cells of dimension " +
                         std::to_string(dim) + ".",
                       "Mesh it in that dimension.");
    check_types(name, elements);

    const auto &[type, groups] = *elements.begin();
    result.mesh.cell_kind      = kind_of_element_type().at(type);
    add_vertices(result, groups);
    for (const Elements &group : groups)
      add_cells(result, group);
    result.mesh.material_ids.assign(result.mesh.n_cells(), 0);
    return result;
  }


  std::size_t
  n_gmsh_elements(const int dim)
  {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> numbers, nodes;
    gmsh::model::mesh::getElements(types, numbers, nodes, dim);
    std::size_t n = 0;
    for (const auto &of_type : numbers)
      n += of_type.size();
    return n;
  }
} // namespace springfit
