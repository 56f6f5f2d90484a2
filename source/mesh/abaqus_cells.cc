#include <springfit/mesh/abaqus_cells.h>

#include <algorithm>
#include <map>

namespace springfit
{
  namespace
  {
    void
    check_nodes(const AbaqusModel &model)
    {
      for (const AbaqusInstance &instance : model.instances)
        for (const AbaqusElement &element : instance.elements)
          for (const std::size_t node : element.nodes)
            if (instance.nodes.count(node) == 0)
              throw text_error(element.place,
                               "the element " + std::to_string(element.label) +
                                 " has the node " + std::to_string(node) +
                                 ", which is not defined",
                               "Define it, or mend the element.");
    }


    // Types with different letters for variants are of one shape.
    std::vector<FileElements>
    elements_by_shape(const AbaqusModel &model,
                      const std::vector<AbaqusItem> &nodes)
    {
      std::map<const AbaqusElementType *, std::size_t> index;
      std::vector<FileElements> elements;
      for (unsigned int i = 0; i < model.instances.size(); ++i)
        for (const AbaqusElement &element : model.instances[i].elements)
          {
            const auto [place, is_new] =
              index.emplace(element.type, elements.size());
            if (is_new)
              elements.push_back({in_capitals(element.type_name),
                                  element.type->dim,
                                  element.type->n_nodes,
                                  element.type->cell_kind,
                                  {},
                                  {},
                                  {}});
            FileElements &of_shape = elements[place->second];
            of_shape.numbers.push_back(element.label);
            of_shape.ids.push_back(0);
            for (const std::size_t node : element.nodes)
              of_shape.nodes.push_back(std::lower_bound(nodes.begin(),
                                                        nodes.end(),
                                                        AbaqusItem(i, node)) -
                                       nodes.begin());
          }
      return elements;
    }

    void
    warn_of_lower_dimensions(const std::vector<FileElements> &elements,
                             const int dim,
                             MeshDescription &mesh)
    {
      for (int d = 1; d < dim; ++d)
        {
          std::vector<std::string> counts;
          for (const FileElements &of_shape : elements)
            if (of_shape.dim == d)
              counts.push_back(std::to_string(of_shape.numbers.size()) +
                               " of type " + of_shape.type);
          if (!counts.empty())
            mesh.warnings.push_back(
              mesh.name +
              ": beside the cells there are elements of dimension " +
              std::to_string(d) + ", which are left out: " + join_some(counts) +
              (d == dim - 1
                 ? "; where they lie on the boundary, their sets name it."
                 : "."));
        }
    }
  } // namespace


  AbaqusCells::AbaqusCells(const AbaqusModel &model,
                           const std::string &name,
                           const int dim)
    : model_(model), dim_(dim)
  {
    check_nodes(model);
    std::vector<MeshPoint> points;
    for (unsigned int i = 0; i < model.instances.size(); ++i)
      for (const auto &[label, point] : model.instances[i].nodes)
        {
          nodes_.emplace_back(i, label);
          points.push_back(point);
        }
    const auto elements   = elements_by_shape(model, nodes_);
    result_               = mesh_of_elements(name, dim, points, elements);
    MeshDescription &mesh = result_.mesh;
    for (const std::string &warning : model.warnings)
      mesh.warnings.push_back(name + ": " + warning + '.');
    warn_of_lower_dimensions(elements, dim, mesh);

    for (unsigned int i = 0; i < model.instances.size(); ++i)
      {
        std::size_t block = 0;
        for (const AbaqusElement &element : model.instances[i].elements)
          if (element.type->dim == dim)
            {
              if (block != element.block)
                mesh.group_begins.push_back(elements_.size());
              block = element.block;
              elements_.emplace_back(i, &element);
            }
      }
  }


  MeshDescription &
  AbaqusCells::mesh()
  {
    return result_.mesh;
  }


  int
  AbaqusCells::dim() const
  {
    return dim_;
  }


  const std::vector<std::pair<unsigned int, const AbaqusElement *>> &
  AbaqusCells::elements() const
  {
    return elements_;
  }


  std::optional<unsigned int>
  AbaqusCells::vertex_of(const AbaqusItem &node) const
  {
    const auto place = std::lower_bound(nodes_.begin(), nodes_.end(), node);
    if (place == nodes_.end() || *place != node)
      return {};
    return result_.vertex_of_node[place - nodes_.begin()];
  }


  std::optional<std::vector<unsigned int>>
  AbaqusCells::side_of(const unsigned int instance,
                       const std::vector<std::size_t> &nodes) const
  {
    std::vector<unsigned int> side;
    for (const std::size_t node : nodes)
      if (const auto vertex = vertex_of({instance, node}))
        side.push_back(*vertex);
    if (side.size() < nodes.size())
      return {};
    std::sort(side.begin(), side.end());
    return side;
  }
} // namespace springfit
