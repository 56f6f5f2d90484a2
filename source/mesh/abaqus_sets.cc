#include <springfit/mesh/abaqus_sets.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace springfit
{
  namespace
  {
    template <typename Value>
    void
    add_range(std::vector<AbaqusItem> &items,
              std::size_t &n_missing,
              const AbaqusSet::Range &range,
              const unsigned int instance,
              const std::map<std::size_t, Value> &known,
              const std::set<std::size_t> &shapeless)
    {
      const std::size_t n_named = (range.last - range.first) / range.step + 1;
      std::size_t n_found       = 0;
      for (auto item = known.lower_bound(range.first);
           item != known.end() && item->first <= range.last;
           ++item)
        if ((item->first - range.first) % range.step == 0)
          {
            items.emplace_back(instance, item->first);
            ++n_found;
          }
      for (auto label = shapeless.lower_bound(range.first);
           label != shapeless.end() && *label <= range.last;
           ++label)
        if ((*label - range.first) % range.step == 0)
          ++n_found;
      n_missing += n_named - n_found;
    }

    /** Follows sets of sets. */
    class SetResolver
    {
    public:
      explicit SetResolver(const AbaqusModel &model) : model_(model)
      {}

      void
      add(const AbaqusSetKind kind,
          const unsigned int instance,
          const AbaqusSet::Reference &reference)
      {
        const std::string name = in_capitals(reference.name);
        if (add_own(kind, instance, name, reference))
          return;
        bool is_found = false;
        if (instance == 0)
          for (unsigned int i = 1; i < model_.instances.size(); ++i)
            is_found = add_own(kind, i, name, reference) || is_found;
        for (unsigned int i = 1; i < model_.instances.size(); ++i)
          {
            const std::string prefix =
              in_capitals(model_.instances[i].name) + '.';
            if (!is_found && name.rfind(prefix, 0) == 0)
              is_found =
                add_qualified(kind, i, name.substr(prefix.size()), reference);
          }
        if (!is_found)
          throw text_error(reference.place,
                           "there is no set of " +
                             std::string(kind == AbaqusSetKind::nodes
                                           ? "nodes"
                                           : "elements") +
                             " '" + reference.name + "'");
      }

      AbaqusMembers members;

    private:
      bool
      add_own(const AbaqusSetKind kind,
              const unsigned int instance,
              const std::string &name,
              const AbaqusSet::Reference &reference)
      {
        const AbaqusInstance &home = model_.instances[instance];
        const auto &sets =
          kind == AbaqusSetKind::nodes ? home.node_sets : home.element_sets;
        const auto set = sets.find(name);
        if (set == sets.end())
          return false;
        const auto key = std::make_tuple(kind, instance, name);
        if (open_.count(key) > 0)
          throw text_error(reference.place,
                           "the set '" + reference.name + "' contains itself");
        if (!done_.insert(key).second)
          return true;
        open_.insert(key);

        const std::set<std::size_t> none;
        for (const auto &range : set->second.ranges)
          if (kind == AbaqusSetKind::nodes)
            add_range(members.items,
                      members.n_missing,
                      range,
                      instance,
                      home.nodes,
                      none);
          else
            add_range(members.items,
                      members.n_missing,
                      range,
                      instance,
                      home.index_of_element,
                      home.shapeless);
        for (const auto &other : set->second.sets)
          add(kind, instance, other);
        for (const auto &other : set->second.element_sets)
          add_nodes_of(instance, other);
        open_.erase(key);
        return true;
      }

      bool
      add_qualified(const AbaqusSetKind kind,
                    const unsigned int instance,
                    const std::string &name,
                    const AbaqusSet::Reference &reference)
      {
        if (!std::isdigit(static_cast<unsigned char>(name[0])))
          return add_own(kind, instance, name, reference);
        const std::size_t label    = read_label(name, reference.place);
        const AbaqusInstance &home = model_.instances[instance];
        if (kind == AbaqusSetKind::nodes
              ? home.nodes.count(label) > 0
              : home.index_of_element.count(label) > 0)
          members.items.emplace_back(instance, label);
        else
          ++members.n_missing;
        return true;
      }

      void
      add_nodes_of(const unsigned int instance,
                   const AbaqusSet::Reference &elements)
      {
        for (const auto &[i, label] :
             members_of_set(model_, AbaqusSetKind::elements, instance, elements)
               .items)
          {
            const AbaqusInstance &home = model_.instances[i];
            for (const std::size_t node :
                 home.elements[home.index_of_element.at(label)].nodes)
              members.items.emplace_back(i, node);
          }
      }

      using Key = std::tuple<AbaqusSetKind, unsigned int, std::string>;

      const AbaqusModel &model_;
      std::set<Key> open_, done_;
    };
  } // namespace


  AbaqusMembers
  members_of_set(const AbaqusModel &model,
                 const AbaqusSetKind kind,
                 const unsigned int instance,
                 const AbaqusSet::Reference &reference)
  {
    SetResolver resolver(model);
    resolver.add(kind, instance, reference);
    auto &items = resolver.members.items;
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    return resolver.members;
  }
} // namespace springfit
