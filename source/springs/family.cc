#include <springfit/springs/family.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace springfit
{
  namespace
  {
    /** Keeps the places alone. */
    class OperatorOfPlaces : public TangentOperator
    {
    public:
      OperatorOfPlaces(const SpringKind &kind, const Members &members)
        : kind_(kind), members_(members)
      {}

      void
      linearise(const Eigen::MatrixXd &state) override
      {
        x_ = state;
      }

      void
      add_product(const Eigen::MatrixXd &u,
                  Eigen::MatrixXd &product) const override
      {
        kind_.add_tangent_product(members_, x_, u, product);
      }

    private:
      const SpringKind &kind_;
      const Members &members_;
      Eigen::MatrixXd x_;
    };
  } // namespace


  SpringKind::SpringKind(std::string word,
                         std::string law,
                         std::vector<std::string> node_names,
                         std::vector<Column> columns)
    : word_(std::move(word))
    , law_(std::move(law))
    , node_names_(std::move(node_names))
    , columns_(std::move(columns))
  {}

  const std::string &
  SpringKind::word() const
  {
    return word_;
  }

  const std::string &
  SpringKind::law() const
  {
    return law_;
  }

  const std::vector<std::string> &
  SpringKind::node_names() const
  {
    return node_names_;
  }

  const std::vector<Column> &
  SpringKind::columns() const
  {
    return columns_;
  }

  unsigned int
  SpringKind::n_nodes() const
  {
    return node_names_.size();
  }

  bool
  SpringKind::rest_values_average() const
  {
    return false;
  }

  bool
  SpringKind::bears_inversion() const
  {
    return false;
  }

  void
  SpringKind::canonicalise(std::vector<unsigned int> &,
                           std::vector<std::vector<double>> &,
                           const Eigen::MatrixXd &) const
  {}

  std::unique_ptr<TangentOperator>
  SpringKind::tangent_operator(const Members &members) const
  {
    return std::make_unique<OperatorOfPlaces>(*this, members);
  }


  Family::Family(const SpringKind &kind) : kind(&kind)
  {
    members.columns.resize(kind.columns().size());
  }

  std::size_t
  Family::size() const
  {
    return members.nodes.size() / kind->n_nodes();
  }

  const unsigned int *
  Family::nodes(const std::size_t member) const
  {
    return members.nodes.data() + kind->n_nodes() * member;
  }

  void
  Family::add(const std::vector<unsigned int> &nodes,
              const std::vector<std::vector<double>> &numbers)
  {
    members.nodes.insert(members.nodes.end(), nodes.begin(), nodes.end());
    for (std::size_t c = 0; c < numbers.size(); ++c)
      members.columns[c].insert(members.columns[c].end(),
                                numbers[c].begin(),
                                numbers[c].end());
  }

  std::vector<std::vector<double>>
  Family::numbers(const std::size_t member) const
  {
    std::vector<std::vector<double>> numbers;
    for (std::size_t c = 0; c < members.columns.size(); ++c)
      {
        const unsigned int width = kind->columns()[c].width;
        const auto first         = members.columns[c].begin() + width * member;
        numbers.emplace_back(first, first + width);
      }
    return numbers;
  }


  Family
  selected(const Family &family, const std::vector<std::size_t> &members)
  {
    Family some(*family.kind);
    for (const std::size_t m : members)
      some.add({family.nodes(m), family.nodes(m) + family.kind->n_nodes()},
               family.numbers(m));
    return some;
  }

  Family
  scaled(Family family, const double scale)
  {
    if (scale != 1.)
      for (std::size_t c = 0; c < family.members.columns.size(); ++c)
        for (double &number : family.members.columns[c])
          number *= std::pow(scale, family.kind->columns()[c].power);
    return family;
  }

  bool
  all_finite(const Family &family)
  {
    return std::all_of(family.members.columns.begin(),
                       family.members.columns.end(),
                       [](const std::vector<double> &column) {
                         return std::all_of(column.begin(),
                                            column.end(),
                                            [](const double number) {
                                              return std::isfinite(number);
                                            });
                       });
  }
} // namespace springfit
