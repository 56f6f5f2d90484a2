#include <springfit/mesh/abaqus_entities.h>
#include <springfit/mesh/abaqus_fields.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    constexpr const char *convert =
      "Write out what it makes (Abaqus: a flattened input file), or convert "
      "the mesh to .msh.";

    void
    add_node(AbaqusInstance &instance,
             const std::size_t label,
             const MeshPoint &point,
             const AbaqusBlock &block,
             const TextPlace &place)
    {
      if (!instance.nodes.emplace(label, point).second)
        throw text_error(place,
                         "the node " + std::to_string(label) +
                           " is defined a second time",
                         "Give each node a number of its own.");
      if (block.settings.count("NSET") > 0)
        add_label(set_in(instance.node_sets, block.setting("NSET")), label);
    }

    const MeshPoint &
    known_node(const AbaqusInstance &instance,
               const std::size_t label,
               const TextPlace &place)
    {
      const auto node = instance.nodes.find(label);
      if (node == instance.nodes.end())
        throw text_error(place,
                         "the node " + std::to_string(label) +
                           " is not defined before");
      return node->second;
    }

    void
    check_n_generated(const std::size_t n, const TextPlace &place)
    {
      constexpr std::size_t most = 100000000;
      if (n > most)
        throw text_error(place,
                         "it makes more than " + std::to_string(most) +
                           " nodes or elements",
                         "Make fewer.");
    }

    void
    add_element(AbaqusInstance &instance,
                const AbaqusElement &element,
                const std::string &set)
    {
      const std::string which = "the element " + std::to_string(element.label);
      if (element.nodes.size() != element.type->n_nodes)
        throw text_error(element.place,
                         which + " of type " + element.type_name + " has " +
                           std::to_string(element.nodes.size()) +
                           " nodes instead of " +
                           std::to_string(element.type->n_nodes),
                         element.nodes.size() < element.type->n_nodes
                           ? "The file may be cut short: write it anew."
                           : "Give it the type that has as many.");
      if (instance.shapeless.count(element.label) > 0 ||
          !instance.index_of_element
             .emplace(element.label, instance.elements.size())
             .second)
        throw text_error(element.place,
                         which + " is defined a second time",
                         "Give each element a number of its own.");
      instance.elements.push_back(element);
      if (!set.empty())
        add_label(set_in(instance.element_sets, set), element.label);
    }
  } // namespace


  std::size_t
  define_nodes(const AbaqusBlock &block,
               const AbaqusPlacement &system_of_nodes,
               AbaqusInstance &instance)
  {
    const std::string system = in_capitals(block.setting("SYSTEM"));
    if (!system.empty() && system != "R" && system != "C")
      throw text_error(block.place,
                       "springfit does not know the coordinate system '" +
                         system + "' of *NODE",
                       "Give right-angled (R) or cylindrical (C) "
                       "coordinates.");
    // A number and three coordinates, behind which a normal may stand.
    const auto n_given = [](const TextLine &line) {
      return std::min<std::size_t>(split_fields(line.text, ',').size(), 4);
    };
    std::size_t n_most = 0, n_short = 0;
    for (const TextLine &line : block.lines)
      n_most = std::max(n_most, n_given(line));
    for (const TextLine &line : block.lines)
      {
        const auto fields = abaqus_fields(line);
        n_short += n_given(line) < n_most ? 1 : 0;
        MeshPoint point{};
        for (unsigned int d = 0; d < 3; ++d)
          if (d + 1 < fields.size() && !fields[d + 1].empty())
            point[d] = read_real(fields[d + 1], line.place);
        if (fields.size() < 2)
          throw text_error(line.place, "a node has no coordinates");
        if (system == "C")
          point = from_cylindrical(point);
        add_node(instance,
                 needed_label(fields, 0, line.place),
                 placed(system_of_nodes, point),
                 block,
                 line.place);
      }
    return n_short;
  }


  void
  generate_nodes(const AbaqusBlock &block, AbaqusInstance &instance)
  {
    if (block.settings.count("LINE") > 0 || block.settings.count("SYSTEM") > 0)
      throw text_error(block.place,
                       "springfit knows *NGEN along straight lines only",
                       convert);
    for (const TextLine &line : block.lines)
      {
        const auto fields = abaqus_fields(line);
        const auto first  = needed_label(fields, 0, line.place);
        const auto last   = needed_label(fields, 1, line.place);
        const auto step   = label_or(fields, 2, 1, line.place);
        if (last <= first || (last - first) % step != 0)
          throw text_error(line.place,
                           "the step " + std::to_string(step) +
                             " does not lead from node " +
                             std::to_string(first) + " to node " +
                             std::to_string(last));
        const MeshPoint a = known_node(instance, first, line.place);
        const MeshPoint b = known_node(instance, last, line.place);
        check_n_generated((last - first) / step, line.place);
        for (std::size_t label = first + step; label < last; label += step)
          add_node(instance,
                   label,
                   between(a, b, double(label - first) / (last - first)),
                   block,
                   line.place);
        if (block.settings.count("NSET") > 0)
          for (const std::size_t end : {first, last})
            add_label(set_in(instance.node_sets, block.setting("NSET")), end);
      }
  }


  void
  define_elements(const AbaqusBlock &block,
                  const AbaqusElementType &type,
                  const std::size_t block_number,
                  AbaqusInstance &instance)
  {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < block.lines.size(); ++i)
      {
        const TextLine &line = block.lines[i];
        for (const std::string &field : abaqus_fields(line))
          numbers.push_back(read_label(field, line.place));
        // A line goes on after a comma, or if it cannot hold all nodes.
        const bool goes_on = i + 1 < block.lines.size() &&
                             numbers.size() < type.n_nodes + 1 &&
                             (line.text.back() == ',' || type.n_nodes > 15);
        if (goes_on)
          continue;
        add_element(instance,
                    {numbers.empty() ? 0 : numbers.front(),
                     &type,
                     block.setting("TYPE"),
                     {numbers.begin() + (numbers.empty() ? 0 : 1),
                      numbers.end()},
                     block_number,
                     in_capitals(block.setting("ELSET")),
                     line.place},
                    block.setting("ELSET"));
        numbers.clear();
      }
  }


  // A row of elements, then rows of rows, then layers of those, each with
  // its count and its steps in the numbers of nodes and elements.
  void
  generate_elements(const AbaqusBlock &block, AbaqusInstance &instance)
  {
    const std::string set = block.setting("ELSET");
    for (const TextLine &line : block.lines)
      {
        const auto fields = abaqus_fields(line);
        const auto label  = needed_label(fields, 0, line.place);
        const auto master = instance.index_of_element.find(label);
        if (master == instance.index_of_element.end())
          throw text_error(line.place,
                           "the element " + std::to_string(label) +
                             " is not defined before");
        const AbaqusElement first = instance.elements[master->second];
        std::array<std::size_t, 3> n, node_step, element_step;
        for (unsigned int d = 0; d < 3; ++d)
          {
            n[d]            = label_or(fields, 3 * d + 1, 1, line.place);
            node_step[d]    = label_or(fields, 3 * d + 2, 1, line.place);
            element_step[d] = label_or(fields, 3 * d + 3, 1, line.place);
            check_n_generated(n[d], line.place);
          }
        check_n_generated(n[0] * n[1], line.place);
        check_n_generated(n[0] * n[1] * n[2], line.place);

        if (!set.empty())
          add_label(set_in(instance.element_sets, set), label);
        for (std::size_t k = 0; k < n[2]; ++k)
          for (std::size_t j = 0; j < n[1]; ++j)
            for (std::size_t i = 0; i < n[0]; ++i)
              if (i + j + k > 0)
                {
                  AbaqusElement copy = first;
                  copy.place         = line.place;
                  copy.set           = in_capitals(set);
                  copy.label += i * element_step[0] + j * element_step[1] +
                                k * element_step[2];
                  for (std::size_t &node : copy.nodes)
                    node +=
                      i * node_step[0] + j * node_step[1] + k * node_step[2];
                  add_element(instance, copy, set);
                }
      }
  }


  std::size_t
  skip_shapeless_elements(const AbaqusBlock &block, AbaqusInstance &instance)
  {
    for (const TextLine &line : block.lines)
      instance.shapeless.insert(
        needed_label(abaqus_fields(line), 0, line.place));
    if (block.settings.count("ELSET") > 0)
      set_in(instance.element_sets, block.setting("ELSET"));
    return block.lines.size();
  }
} // namespace springfit
