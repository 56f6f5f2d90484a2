#include <springfit/mesh/abaqus_elements.h>
#include <springfit/mesh/abaqus_entities.h>
#include <springfit/mesh/abaqus_fields.h>
#include <springfit/mesh/abaqus_groups.h>
#include <springfit/mesh/abaqus_model.h>
#include <springfit/mesh/abaqus_placement.h>

#include <algorithm>
#include <optional>

namespace springfit
{
  namespace
  {
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
          {"NGEN", &Reader::read_generated_nodes},
          {"SYSTEM", &Reader::read_system},
          {"ELEMENT", &Reader::read_elements},
          {"ELGEN", &Reader::read_generated_elements},
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
                           "Write out what it makes (Abaqus: a flattened input "
                           "file), or convert the mesh to .msh.");
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
        if (!parts_.empty() && used_parts_.empty() &&
            model_.instances.front().elements.empty())
          throw text_error(opened_,
                           "no *INSTANCE is made of the part that begins here, "
                           "nor of any other",
                           "Give the file an *ASSEMBLY with an *INSTANCE of "
                           "each part.");
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
        n_short_nodes_ += define_nodes(block, system_, current());
      }

      void
      read_generated_nodes(const AbaqusBlock &block)
      {
        generate_nodes(block, current());
      }

      void
      read_elements(const AbaqusBlock &block)
      {
        const std::string name = block.setting("TYPE");
        if (is_shapeless_abaqus_element(name))
          {
            n_shapeless_[in_capitals(name)] +=
              skip_shapeless_elements(block, current());
            return;
          }
        const AbaqusElementType *const type = find_abaqus_element_type(name);
        if (type == nullptr)
          throw text_error(block.place,
                           "the element type '" + name + "' is not known",
                           "Cells may be CPS3, CPE3, S3, CPS4, CPE4, S4, C3D4 "
                           "or C3D8 with their variants; remove what is no "
                           "part of the mesh.");
        define_elements(block, *type, ++n_blocks_, current());
      }

      void
      read_generated_elements(const AbaqusBlock &block)
      {
        generate_elements(block, current());
      }

      void
      read_node_set(const AbaqusBlock &block)
      {
        define_node_set(block, home_of(block));
      }

      void
      read_element_set(const AbaqusBlock &block)
      {
        define_element_set(block, home_of(block));
      }

      void
      read_surface(const AbaqusBlock &block)
      {
        if (!define_surface(block, home_of(block)))
          model_.warnings.push_back("the surface '" + block.setting("NAME") +
                                    "' is passed over: it is not one of sides "
                                    "of elements or of nodes");
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

        if (n_short_nodes_ > 0)
          model_.warnings.push_back(
            std::to_string(n_short_nodes_) +
            " nodes have fewer coordinates than others of their *NODE; those "
            "missing are taken for 0");
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
      std::size_t n_blocks_ = 0, n_short_nodes_ = 0;
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
