#include <springfit/springs/by_table.h>

#include <algorithm>
#include <cstddef>

namespace springfit
{
  Families
  by_table(const Families &families)
  {
    Families tables;
    for (const Family &family : families)
      {
        const auto same =
          std::find_if(tables.begin(), tables.end(), [&](const Family &table) {
            return table.kind->word() == family.kind->word() &&
                   table.kind->law() == family.kind->law();
          });
        if (same == tables.end())
          tables.push_back(family);
        else
          for (std::size_t m = 0; m < family.size(); ++m)
            same->add({family.nodes(m),
                       family.nodes(m) + family.kind->n_nodes()},
                      family.numbers(m));
      }
    return tables;
  }
} // namespace springfit
