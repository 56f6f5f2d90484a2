#include <springfit/mesh/numbered_elements.h>

#include <algorithm>

namespace springfit
{
  NumberedElements::NumberedElements()
    : known_nodes_("node"), known_elements_("element")
  {}


  void
  NumberedElements::add_node(const std::size_t number,
                             const MeshPoint &point,
                             const TextPlace &place)
  {
    known_nodes_.add(number, place);
    nodes_.emplace(number, point);
  }


  void
  NumberedElements::add_element(const FileElements &type,
                                const std::size_t number,
                                const unsigned int id,
                                const std::vector<std::size_t> &nodes,
                                const TextPlace &place)
  {
    known_elements_.add(number, place);
    auto of_type = std::find_if(elements_.begin(),
                                elements_.end(),
                                [&](const FileElements &other) {
                                  return other.type == type.type;
                                });
    if (of_type == elements_.end())
      of_type = elements_.insert(of_type, type);
    element_of_number_[number] = {std::size_t(of_type - elements_.begin()),
                                  of_type->numbers.size(),
                                  place};
    of_type->numbers.push_back(number);
    of_type->ids.push_back(id);
    of_type->nodes.insert(of_type->nodes.end(), nodes.begin(), nodes.end());
  }


  void
  NumberedElements::make_mesh(const std::string &name, const int dim)
  {
    std::vector<MeshPoint> points;
    for (const auto &[number, point] : nodes_)
      {
        index_of_node_[number] = points.size();
        points.push_back(point);
      }
    for (FileElements &of_type : elements_)
      for (std::size_t i = 0; i < of_type.nodes.size(); ++i)
        {
          const std::size_t number = of_type.numbers[i / of_type.n_nodes];
          known_nodes_.check(of_type.nodes[i],
                             "the element " + std::to_string(number),
                             element_of_number_.at(number).place);
          of_type.nodes[i] = index_of_node_.at(of_type.nodes[i]);
        }
    result_ = mesh_of_elements(name, dim, points, elements_);
  }


  void
  NumberedElements::label_sides_by_ids()
  {
    label_sides(result_, elements_);
  }


  MeshDescription &
  NumberedElements::mesh()
  {
    return result_.mesh;
  }


  bool
  NumberedElements::has_node(const std::size_t number) const
  {
    return nodes_.count(number) > 0;
  }


  bool
  NumberedElements::has_element(const std::size_t number) const
  {
    return element_of_number_.count(number) > 0;
  }


  std::optional<unsigned int>
  NumberedElements::vertex_of(const std::size_t node) const
  {
    return result_.vertex_of_node[index_of_node_.at(node)];
  }


  std::optional<unsigned int>
  NumberedElements::cell_of(const std::size_t element) const
  {
    const Element &found = element_of_number_.at(element);
    if (elements_[found.type].dim != dimension(result_.mesh.cell_kind))
      return {};
    return found.position;
  }


  std::optional<std::vector<unsigned int>>
  NumberedElements::side_of(const std::size_t element) const
  {
    const Element &found        = element_of_number_.at(element);
    const FileElements &of_type = elements_[found.type];
    if (of_type.dim != dimension(result_.mesh.cell_kind) - 1)
      return {};
    std::vector<unsigned int> side;
    for (unsigned int i = 0; i < of_type.n_nodes; ++i)
      {
        const std::size_t node =
          of_type.nodes[found.position * of_type.n_nodes + i];
        if (!result_.vertex_of_node[node])
          return {};
        side.push_back(*result_.vertex_of_node[node]);
      }
    std::sort(side.begin(), side.end());
    return side;
  }
} // namespace springfit
