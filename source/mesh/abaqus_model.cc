#include <springfit/core/words.h>
#include <springfit/mesh/abaqus_model.h>
#include <springfit/mesh/abaqus_placement.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <optional>

namespace springfit
{
  namespace
  {
    constexpr const char *convert =
      "Write out what it makes (Abaqus: a flattened input file), or convert "
      "the mesh to .msh.";

    // They make, move or remove nodes or elements.
    const std::set<std::string> &
    refused_keywords()
    {
      static const std::set<std::string> words = {"NFILL",
                                                  "NCOPY",
                                                  "NMAP",
                                                  "ELCOPY",
                                                  "IMPERFECTION",
                                                  "IMPORT",
                                                  "IMPORT NODESET",
                                                  "IMPORT ELSET",
                                                  "SYMMETRIC MODEL GENERATION",
                                                  "PARAMETER",
                                                  "ASSEMBLY IMPORT",
                                                  "MAP SOLUTION",
                                                  "USER ELEMENT",
                                                  "MATRIX ASSEMBLE"};
      return words;
    }

    std::vector<std::string>
    fields_of(const TextLine &line)
    {
      auto fields = split_fields(line.text, ',');
      while (!fields.empty() && fields.back().empty())
        fields.pop_back();
      return fields;
    }

    std::size_t
    label_or(const std::vector<std::string> &fields,
             const std::size_t i,
             const std::size_t absent,
             const TextPlace &place)
    {
      return i < fields.size() && !fields[i].empty()
               ? read_label(fields[i], place)
               : absent;
    }

    std::size_t
    needed_label(const std::vector<std::string> &fields,
                 const std::size_t i,
                 const TextPlace &place)
    {
      if (i >= fields.size() || fields[i].empty())
        throw text_error(place,
                         "the line ends before its number " +
                           std::to_string(i + 1));
      return read_label(fields[i], place);
    }

    std::vector<double>
    reals_of(const TextLine &line)
    {
      std::vector<double> values;
      for (const std::string &field : fields_of(line))
        values.push_back(field.empty() ? 0. : read_real(field, line.place));
      return values;
    }

    // Consecutive labels make one range.
    void
    add_label(AbaqusSet &set, const std::size_t label)
    {
      if (!set.ranges.empty() && set.ranges.back().step == 1 &&
          set.ranges.back().last + 1 == label)
        set.ranges.back().last = label;
      else
        set.ranges.push_back({label, label, 1});
    }

    AbaqusSet &
    set_in(std::map<std::string, AbaqusSet> &sets, const std::string &name)
    {
      AbaqusSet &set = sets[in_capitals(name)];
      if (set.name.empty())
        set.name = name;
      return set;
    }

    /** Hands each keyword to the function that understands it. */
    class Reader
    {
    public:
      Reader()
      {
        model_.instances.resize(1);
      }

      void
      read(const AbaqusBlock &block)
      {
        using Handler = void (Reader::*)(const AbaqusBlock &);
        static const std::map<std::string, Handler> handlers = {
          {"NODE", &Reader::read_nodes},
          {"NGEN", &Reader::generate_nodes},
          {"SYSTEM", &Reader::read_system},
          {"ELEMENT", &Reader::read_elements},
          {"ELGEN", &Reader::generate_elements},
          {"NSET", &Reader::read_node_set},
          {"ELSET", &Reader::read_element_set},
          {"SURFACE", &Reader::read_surface},
          {"SOLID SECTION", &Reader::read_section},
          {"SHELL SECTION", &Reader::read_section},
          {"MEMBRANE SECTION", &Reader::read_section},
          {"PART", &Reader::begin_part},
          {"END PART", &Reader::end_part},
          {"INSTANCE", &Reader::begin_instance},
          {"END INSTANCE", &Reader::end_instance},
          {"ASSEMBLY", &Reader::nothing},
          {"END ASSEMBLY", &Reader::nothing},
          {"HEADING", &Reader::nothing}};

        const auto handler = handlers.find(block.word);
        if (handler != handlers.end())
          return (this->*handler->second)(block);
        if (refused_keywords().count(block.word) > 0)
          throw text_error(block.place,
                           "springfit does not know what *" + block.word +
                             " makes of the mesh",
                           convert);
        if (std::find(ignored_.begin(), ignored_.end(), block.word) ==
            ignored_.end())
          ignored_.push_back(block.word);
      }

      AbaqusModel
      finish()
      {
        if (open_part_ || instance_ > 0)
          throw text_error(opened_,
                           std::string("the file ends before the ") +
                             (open_part_ ? "part" : "instance") +
                             " that begins here does",
                           "It may be cut short: write it anew.");
        add_warnings();
        return std::move(model_);
      }

    private:
      AbaqusInstance &
      current()
      {
        return open_part_ ? parts_.at(*open_part_)
                          : model_.instances[instance_];
      }

      void
      nothing(const AbaqusBlock &)
      {}

      void
      read_nodes(const AbaqusBlock &block)
      {
        const std::string system = in_capitals(block.setting("SYSTEM"));
        if (!system.empty() && system != "R" && system != "C")
          throw text_error(block.place,
                           "springfit does not know the coordinate system '" +
                             system + "' of *NODE",
                           "Give right-angled (R) or cylindrical (C) "
                           "coordinates.");
        for (const TextLine &line : block.lines)
          {
            const auto fields = fields_of(line);
            MeshPoint point{};
            for (unsigned int d = 0; d < 3; ++d)
              if (d + 1 < fields.size() && !fields[d + 1].empty())
                point[d] = read_real(fields[d + 1], line.place);
            if (fields.size() < 2)
              throw text_error(line.place, "a node has no coordinates");
            if (system == "C")
              point = from_cylindrical(point);
            add_node(needed_label(fields, 0, line.place),
                     placed(system_, point),
                     block,
                     line.place);
          }
      }

      void
      add_node(const std::size_t label,
               const MeshPoint &point,
               const AbaqusBlock &block,
               const TextPlace &place)
      {
        if (!current().nodes.emplace(label, point).second)
          throw text_error(place,
                           "the node " + std::to_string(label) +
                             " is defined a second time",
                           "Give each node a number of its own.");
        if (block.settings.count("NSET") > 0)
          add_label(set_in(current().node_sets, block.setting("NSET")), label);
      }

      const MeshPoint &
      known_node(const std::size_t label, const TextPlace &place)
      {
        const auto node = current().nodes.find(label);
        if (node == current().nodes.end())
          throw text_error(place,
                           "the node " + std::to_string(label) +
                             " is not defined before");
        return node->second;
      }

      void
      generate_nodes(const AbaqusBlock &block)
      {
        if (block.settings.count("LINE") > 0 ||
            block.settings.count("SYSTEM") > 0)
          throw text_error(block.place,
                           "springfit knows *NGEN along straight lines only",
                           convert);
        for (const TextLine &line : block.lines)
          {
            const auto fields = fields_of(line);
            const auto first  = needed_label(fields, 0, line.place);
            const auto last   = needed_label(fields, 1, line.place);
            const auto step   = label_or(fields, 2, 1, line.place);
            if (last <= first || (last - first) % step != 0)
              throw text_error(line.place,
                               "the step " + std::to_string(step) +
                                 " does not lead from node " +
                                 std::to_string(first) + " to node " +
                                 std::to_string(last));
            const MeshPoint a = known_node(first, line.place);
            const MeshPoint b = known_node(last, line.place);
            check_n_generated((last - first) / step, line.place);
            for (std::size_t label = first + step; label < last; label += step)
              add_node(label,
                       between(a, b, double(label - first) / (last - first)),
                       block,
                       line.place);
            if (block.settings.count("NSET") > 0)
              for (const std::size_t end : {first, last})
                add_label(set_in(current().node_sets, block.setting("NSET")),
                          end);
          }
      }

      static void
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
      read_system(const AbaqusBlock &block)
      {
        std::vector<double> values;
        for (const TextLine &line : block.lines)
          for (const double value : reals_of(line))
            values.push_back(value);
        system_ = coordinate_system(values, block.place);
      }

      void
      read_elements(const AbaqusBlock &block)
      {
        const std::string name = block.setting("TYPE");
        if (is_shapeless_abaqus_element(name))
          return skip_shapeless(block, name);
        const AbaqusElementType *const type = find_abaqus_element_type(name);
        if (type == nullptr)
          throw text_error(block.place,
                           "the element type '" + name + "' is not known",
                           "Cells may be CPS3, CPE3, S3, CPS4, CPE4, S4, C3D4 "
                           "or C3D8 with their variants; remove what is no "
                           "part of the mesh.");
        ++n_blocks_;

        std::vector<std::size_t> numbers;
        for (std::size_t i = 0; i < block.lines.size(); ++i)
          {
            const TextLine &line = block.lines[i];
            for (const std::string &field : fields_of(line))
              numbers.push_back(read_label(field, line.place));
            // A line goes on after a comma, or if it cannot hold all nodes.
            const bool goes_on =
              i + 1 < block.lines.size() &&
              numbers.size() < type->n_nodes + 1 &&
              (line.text.back() == ',' || type->n_nodes > 15);
            if (goes_on)
              continue;
            add_element({numbers.empty() ? 0 : numbers.front(),
                         type,
                         name,
                         {numbers.begin() + (numbers.empty() ? 0 : 1),
                          numbers.end()},
                         n_blocks_,
                         in_capitals(block.setting("ELSET")),
                         line.place},
                        block.setting("ELSET"));
            numbers.clear();
          }
      }

      void
      add_element(const AbaqusElement &element, const std::string &set)
      {
        const std::string which =
          "the element " + std::to_string(element.label);
        if (element.nodes.size() != element.type->n_nodes)
          throw text_error(element.place,
                           which + " of type " + element.type_name + " has " +
                             std::to_string(element.nodes.size()) +
                             " nodes instead of " +
                             std::to_string(element.type->n_nodes),
                           "The file may be cut short: write it anew.");
        AbaqusInstance &instance = current();
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

      void
      skip_shapeless(const AbaqusBlock &block, const std::string &name)
      {
        for (const TextLine &line : block.lines)
          {
            const auto label = needed_label(fields_of(line), 0, line.place);
            current().shapeless.insert(label);
            ++n_shapeless_[in_capitals(name)];
          }
        if (block.settings.count("ELSET") > 0)
          set_in(current().element_sets, block.setting("ELSET"));
      }

      // A row of elements, then rows of rows, then layers of those, each with
      // its count and its steps in the numbers of nodes and elements.
      void
      generate_elements(const AbaqusBlock &block)
      {
        const std::string set = block.setting("ELSET");
        for (const TextLine &line : block.lines)
          {
            const auto fields = fields_of(line);
            const auto label  = needed_label(fields, 0, line.place);
            const auto master = current().index_of_element.find(label);
            if (master == current().index_of_element.end())
              throw text_error(line.place,
                               "the element " + std::to_string(label) +
                                 " is not defined before");
            const AbaqusElement first = current().elements[master->second];
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
              add_label(set_in(current().element_sets, set), label);
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
                        node += i * node_step[0] + j * node_step[1] +
                                k * node_step[2];
                      add_element(copy, set);
                    }
          }
      }

      // The instance in which a set is defined.
      AbaqusInstance &
      home_of(const AbaqusBlock &block)
      {
        const std::string name = block.setting("INSTANCE");
        if (name.empty())
          return current();
        for (std::size_t i = 1; i < model_.instances.size(); ++i)
          if (in_capitals(model_.instances[i].name) == in_capitals(name))
            return model_.instances[i];
        throw text_error(block.place,
                         "there is no instance '" + name + "' before");
      }

      void
      read_node_set(const AbaqusBlock &block)
      {
        AbaqusSet &set = begin_set(block, home_of(block).node_sets, "NSET");
        if (block.settings.count("ELSET") > 0)
          set.element_sets.push_back({block.setting("ELSET"), block.place});
        read_members(block, set);
      }

      void
      read_element_set(const AbaqusBlock &block)
      {
        read_members(block,
                     begin_set(block, home_of(block).element_sets, "ELSET"));
      }

      static AbaqusSet &
      begin_set(const AbaqusBlock &block,
                std::map<std::string, AbaqusSet> &sets,
                const std::string &key)
      {
        const std::string name = block.setting(key);
        if (name.empty())
          throw text_error(block.place, "a set has no name");
        AbaqusSet &set  = set_in(sets, name);
        set.is_internal = block.settings.count("INTERNAL") > 0;
        return set;
      }

      static void
      read_members(const AbaqusBlock &block, AbaqusSet &set)
      {
        for (const TextLine &line : block.lines)
          if (block.settings.count("GENERATE") > 0)
            {
              const auto fields = fields_of(line);
              const auto first  = needed_label(fields, 0, line.place);
              const auto last   = label_or(fields, 1, first, line.place);
              const auto step   = label_or(fields, 2, 1, line.place);
              if (last < first)
                throw text_error(line.place,
                                 "the set goes from " + std::to_string(first) +
                                   " to " + std::to_string(last));
              set.ranges.push_back({first, last, step});
            }
          else
            for (const std::string &field : fields_of(line))
              if (std::isdigit(static_cast<unsigned char>(field[0])) ||
                  field[0] == '-')
                add_label(set, read_label(field, line.place));
              else if (!field.empty())
                set.sets.push_back({field, line.place});
      }

      void
      read_surface(const AbaqusBlock &block)
      {
        const std::string type = in_capitals(block.setting("TYPE"));
        const std::string name = block.setting("NAME");
        if (name.empty())
          throw text_error(block.place, "a surface has no name");
        if (!(type.empty() || type == "ELEMENT" || type == "NODE") ||
            block.settings.count("COMBINE") > 0)
          {
            model_.warnings.push_back("the surface '" + name +
                                      "' is passed over: it is not one of "
                                      "sides of elements or of nodes");
            return;
          }
        AbaqusSurface surface{name,
                              block.settings.count("INTERNAL") > 0,
                              type == "NODE",
                              {}};
        for (const TextLine &line : block.lines)
          {
            const auto fields = fields_of(line);
            if (fields.empty() || fields[0].empty())
              throw text_error(line.place, "a surface names no set");
            surface.items.push_back({fields[0],
                                     fields.size() > 1 && type != "NODE"
                                       ? in_capitals(fields[1])
                                       : "",
                                     line.place});
          }
        home_of(block).surfaces.push_back(surface);
      }

      void
      read_section(const AbaqusBlock &block)
      {
        current().sections.push_back(
          {block.setting("ELSET"), block.setting("MATERIAL"), block.place});
      }

      void
      begin_part(const AbaqusBlock &block)
      {
        const std::string name = in_capitals(block.setting("NAME"));
        if (open_part_ || instance_ > 0)
          throw text_error(block.place, "a part within a part");
        if (name.empty() || parts_.count(name) > 0)
          throw text_error(block.place,
                           name.empty() ? "a part has no name"
                                        : "a second part '" + name + "'");
        parts_[name].name = block.setting("NAME");
        open_part_        = name;
        opened_           = block.place;
        system_           = {};
      }

      void
      end_part(const AbaqusBlock &block)
      {
        if (!open_part_)
          throw text_error(block.place, "no part begins before this end");
        open_part_.reset();
        system_ = {};
      }

      void
      begin_instance(const AbaqusBlock &block)
      {
        const std::string name = block.setting("NAME");
        const auto part = parts_.find(in_capitals(block.setting("PART")));
        if (open_part_ || instance_ > 0)
          throw text_error(block.place, "an instance within another");
        if (part == parts_.end())
          throw text_error(block.place,
                           "there is no part '" + block.setting("PART") +
                             "' before",
                           "Define it, or write a flattened input file.");
        for (std::size_t i = 1; i < model_.instances.size(); ++i)
          if (in_capitals(model_.instances[i].name) == in_capitals(name))
            throw text_error(block.place, "a second instance '" + name + "'");

        used_parts_.insert(part->first);
        instance_ = model_.instances.size();
        opened_   = block.place;
        system_   = {};
        model_.instances.push_back(part->second);
        model_.instances.back().name = name;

        std::vector<std::vector<double>> lines;
        for (const TextLine &line : block.lines)
          lines.push_back(reals_of(line));
        placement_ = instance_placement(lines, block.place);
      }

      // The nodes that an instance defines by itself move with it.
      void
      end_instance(const AbaqusBlock &block)
      {
        if (instance_ == 0)
          throw text_error(block.place, "no instance begins before this end");
        for (auto &[label, point] : current().nodes)
          point = placed(placement_, point);
        instance_ = 0;
        system_   = {};
      }

      void
      add_warnings()
      {
        std::vector<std::string> words, types, parts;
        for (const std::string &word : ignored_)
          words.push_back('*' + word);
        for (const auto &[type, n] : n_shapeless_)
          types.push_back(std::to_string(n) + " of type " + type);
        for (const auto &[name, part] : parts_)
          if (used_parts_.count(name) == 0)
            parts.push_back('\'' + part.name + '\'');

        if (!types.empty())
          model_.warnings.push_back("elements without a shape are left out: " +
                                    join_some(types));
        if (!parts.empty())
          model_.warnings.push_back("no instance is made of the part " +
                                    join_some(parts) + ": it is left out");
        if (!words.empty())
          model_.warnings.push_back(
            "of no meaning to the mesh and passed over: " +
            join_some(words, 40));
      }

      AbaqusModel model_;
      std::map<std::string, AbaqusInstance> parts_; // by name in capitals
      std::set<std::string> used_parts_;
      std::optional<std::string> open_part_;
      std::size_t instance_ = 0; // the open one; 0: none
      TextPlace opened_;
      AbaqusPlacement system_, placement_;
      std::size_t n_blocks_ = 0;
      std::vector<std::string> ignored_;
      std::map<std::string, std::size_t> n_shapeless_;
    };
  } // namespace


  AbaqusModel
  make_abaqus_model(const std::vector<AbaqusBlock> &blocks)
  {
    Reader reader;
    for (const AbaqusBlock &block : blocks)
      reader.read(block);
    return reader.finish();
  }
} // namespace springfit
