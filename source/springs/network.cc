#include <springfit/springs/negative.h>
#include <springfit/springs/network.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace springfit
{
  namespace
  {
    bool
    is_spring(const Family &family)
    {
      return family.kind->n_nodes() == 2;
    }

    bool
    nearly_equal(const double a, const double b)
    {
      return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
    }

    using Numbers = std::vector<std::vector<double>>;

    /** Whether @p b can be added to @p a, and then adds it. */
    bool
    merge(const SpringKind &kind, Numbers &a, const Numbers &b)
    {
      const auto &columns     = kind.columns();
      std::size_t n_different = 0, different = 0;
      for (std::size_t c = 0; c < columns.size(); ++c)
        if (columns[c].role != Column::Role::stiffness &&
            !nearly_equal(a[c][0], b[c][0]))
          {
            ++n_different;
            different = c;
          }
      const double k = a[0][0] + b[0][0];
      if (n_different == 1 && kind.rest_values_average() &&
          std::abs(k) > 1e-6 * (std::abs(a[0][0]) + std::abs(b[0][0])))
        a[different][0] =
          (a[0][0] * a[different][0] + b[0][0] * b[different][0]) / k;
      else if (n_different > 0)
        return false;
      a[0][0] = k;
      return true;
    }

    /** The members sorted by their nodes; equal ones stay in their order. */
    std::vector<std::size_t>
    sorted_members(const Family &family)
    {
      const std::size_t n = family.kind->n_nodes();
      std::vector<std::size_t> order(family.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(),
                       order.end(),
                       [&](const std::size_t a, const std::size_t b) {
                         const unsigned int *x = family.nodes(a);
                         const unsigned int *y = family.nodes(b);
                         return std::lexicographical_compare(x,
                                                             x + n,
                                                             y,
                                                             y + n);
                       });
      return order;
    }

    Family
    merged(const Family &family)
    {
      const std::size_t n = family.kind->n_nodes();
      Family result(*family.kind);
      const auto order = sorted_members(family);
      for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end)
        {
          const unsigned int *nodes = family.nodes(order[begin]);
          std::vector<Numbers> members;
          for (; end < order.size() &&
                 std::equal(nodes, nodes + n, family.nodes(order[end]));
               ++end)
            {
              const Numbers numbers = family.numbers(order[end]);
              if (std::none_of(members.begin(),
                               members.end(),
                               [&](Numbers &other) {
                                 return merge(*family.kind, other, numbers);
                               }))
                members.push_back(numbers);
            }
          for (const auto &numbers : members)
            result.add({nodes, nodes + n}, numbers);
        }
      return result;
    }
  } // namespace

  double
  energy(const Families &families, const Eigen::MatrixXd &x)
  {
    double sum = 0.;
    for (const auto &family : families)
      sum += family.kind->energy(family.members, x);
    return sum;
  }

  void
  add_forces(const Families &families,
             const Eigen::MatrixXd &x,
             Eigen::MatrixXd &forces)
  {
    for (const auto &family : families)
      family.kind->add_forces(family.members, x, forces);
  }

  void
  add_tangent_product(const Families &families,
                      const Eigen::MatrixXd &x,
                      const Eigen::MatrixXd &u,
                      Eigen::MatrixXd &product)
  {
    for (const auto &family : families)
      family.kind->add_tangent_product(family.members, x, u, product);
  }

  void
  add_tangent(const Families &families,
              const Eigen::MatrixXd &x,
              TangentMatrix &tangent)
  {
    for (const auto &family : families)
      family.kind->add_tangent(family.members, x, tangent);
  }

  void
  add_to_pattern(const Families &families, NodePattern &pattern)
  {
    for (const auto &family : families)
      for (std::size_t m = 0; m < family.size(); ++m)
        pattern.add_clique(family.nodes(m), family.kind->n_nodes());
  }

  Eigen::SparseMatrix<double>
  tangent(const Families &families, const Eigen::MatrixXd &x)
  {
    NodePattern pattern(x.cols());
    add_to_pattern(families, pattern);
    TangentMatrix matrix(x.rows(), pattern);
    add_tangent(families, x, matrix);
    return matrix.matrix();
  }

  bool
  all_finite(const Families &families)
  {
    return std::all_of(families.begin(),
                       families.end(),
                       [](const Family &family) { return all_finite(family); });
  }

  namespace
  {
    /** The column of constants. */
    const std::vector<double> &
    constants_of(const Family &family)
    {
      const Column &column = family.kind->columns().front();
      if (column.role != Column::Role::stiffness || column.width != 1)
        throw std::logic_error("the energy of '" + family.kind->word() +
                               "' is not linear in a single constant");
      return family.members.columns.front();
    }
  } // namespace

  Eigen::VectorXd
  constants_of(const Families &families)
  {
    std::vector<double> all;
    for (const auto &family : families)
      {
        const auto &constants = constants_of(family);
        all.insert(all.end(), constants.begin(), constants.end());
      }
    return Eigen::Map<const Eigen::VectorXd>(all.data(), all.size());
  }

  Families
  with_constants(Families families, const Eigen::VectorXd &constants)
  {
    if (constants.size() != constants_of(families).size())
      throw std::logic_error("there are other springs than constants");
    const double *next = constants.data();
    for (auto &family : families)
      {
        std::copy_n(next,
                    family.size(),
                    family.members.columns.front().begin());
        next += family.size();
      }
    return families;
  }

  std::size_t
  n_springs(const Families &families)
  {
    std::size_t n = 0;
    for (const auto &family : families)
      if (is_spring(family))
        n += family.size();
    return n;
  }

  Eigen::VectorXd
  spring_stiffness(const Families &families)
  {
    Eigen::VectorXd k(n_springs(families));
    Eigen::Index first = 0;
    for (const auto &family : families)
      if (is_spring(family))
        {
          const auto &of_family = family.members.columns.front();
          std::copy(of_family.begin(), of_family.end(), k.begin() + first);
          first += of_family.size();
        }
    return k;
  }

  unsigned int
  n_negative(const Families &families)
  {
    return n_negative(spring_stiffness(families));
  }

  bool
  bear_inversion(const Families &families)
  {
    return std::all_of(families.begin(),
                       families.end(),
                       [](const Family &family) {
                         return family.kind->bears_inversion();
                       });
  }

  bool
  are_under_tension(const Families &families)
  {
    return std::any_of(families.begin(),
                       families.end(),
                       [](const Family &family) {
                         return is_spring(family) &&
                                family.kind->bears_inversion();
                       });
  }

  bool
  has_springs_alone(const Families &families)
  {
    return std::all_of(families.begin(), families.end(), is_spring);
  }


  Families
  within(const Families &families,
         const std::vector<std::vector<unsigned int>> &cells)
  {
    std::vector<std::vector<std::size_t>> cells_of_nodes;
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (const unsigned int v : cells[c])
        {
          if (v >= cells_of_nodes.size())
            cells_of_nodes.resize(v + 1);
          cells_of_nodes[v].push_back(c);
        }
    const auto is_within = [&](const unsigned int *nodes,
                               const unsigned int n) {
      return nodes[0] < cells_of_nodes.size() &&
             std::any_of(cells_of_nodes[nodes[0]].begin(),
                         cells_of_nodes[nodes[0]].end(),
                         [&](const std::size_t c) {
                           return std::all_of(
                             nodes, nodes + n, [&](const unsigned int v) {
                               return std::find(cells[c].begin(),
                                                cells[c].end(),
                                                v) != cells[c].end();
                             });
                         });
    };

    Families result;
    for (const auto &family : families)
      {
        std::vector<std::size_t> members;
        for (std::size_t m = 0; m < family.size(); ++m)
          if (is_within(family.nodes(m), family.kind->n_nodes()))
            members.push_back(m);
        result.push_back(selected(family, members));
      }
    return result;
  }


  NetworkBuilder::NetworkBuilder(Eigen::MatrixXd nodes)
    : nodes_(std::move(nodes)), mass_(nodes_.cols(), 0.)
  {}

  void
  NetworkBuilder::add(const Family &family,
                      const std::vector<unsigned int> &nodes)
  {
    auto found =
      std::find_if(families_.begin(), families_.end(), [&](const Family &f) {
        return f.kind == family.kind;
      });
    if (found == families_.end())
      found = families_.insert(families_.end(), Family(*family.kind));

    const unsigned int n = family.kind->n_nodes();
    for (std::size_t m = 0; m < family.size(); ++m)
      {
        std::vector<unsigned int> of_member(n);
        for (unsigned int a = 0; a < n; ++a)
          of_member[a] = nodes[family.nodes(m)[a]];
        Numbers numbers = family.numbers(m);
        family.kind->canonicalise(of_member, numbers, nodes_);
        found->add(of_member, numbers);
      }
  }

  void
  NetworkBuilder::add_masses(const std::vector<unsigned int> &nodes,
                             const Eigen::Ref<const Eigen::VectorXd> &masses)
  {
    for (std::size_t v = 0; v < nodes.size(); ++v)
      mass_[nodes[v]] += masses[v];
  }

  SpringNetwork
  NetworkBuilder::build() const
  {
    SpringNetwork network{nodes_, {}, mass_};
    for (const auto &family : families_)
      network.families.push_back(family.kind->is_shared() ? merged(family)
                                                          : family);
    return network;
  }
} // namespace springfit
