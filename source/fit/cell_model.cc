#include <springfit/fit/cell_model.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    Family &
    family_of_kind(Families &families, const SpringKind &kind)
    {
      const auto found =
        std::find_if(families.begin(), families.end(), [&](const Family &f) {
          return f.kind == &kind;
        });
      if (found != families.end())
        return *found;
      families.emplace_back(kind);
      return families.back();
    }

    /** The member with the same nodes, or the number of members. */
    std::size_t
    member_with_nodes(const Family &family, const unsigned int *nodes)
    {
      std::size_t m = 0;
      while (
        m < family.size() &&
        !std::equal(nodes, nodes + family.kind->n_nodes(), family.nodes(m)))
        ++m;
      return m;
    }

    void
    add_scaled(const CellModel &model, const double factor, Families &sum)
    {
      for (const auto &family : model.families)
        {
          const auto &columns = family.kind->columns();
          if (columns[0].role != Column::Role::stiffness)
            throw std::logic_error("'" + family.kind->word() +
                                   "' have no stiffness to be added");
          Family &to = family_of_kind(sum, *family.kind);
          for (std::size_t m = 0; m < family.size(); ++m)
            {
              auto numbers = family.numbers(m);
              for (double &stiffness : numbers[0])
                stiffness *= factor;
              const unsigned int *nodes = family.nodes(m);
              const std::size_t same    = member_with_nodes(to, nodes);
              if (same < to.size())
                for (std::size_t w = 0; w < numbers[0].size(); ++w)
                  to.members.columns[0][numbers[0].size() * same + w] +=
                    numbers[0][w];
              else
                to.add({nodes, nodes + family.kind->n_nodes()}, numbers);
            }
        }
    }
  } // namespace

  Eigen::VectorXd
  CellModel::k() const
  {
    return spring_stiffness(families);
  }

  CellModel
  between(const CellModel &a, const CellModel &b, const double t)
  {
    CellModel sum;
    add_scaled(a, 1. - t, sum.families);
    add_scaled(b, t, sum.families);
    return sum;
  }
} // namespace springfit
