#include <springfit/core/error.h>
#include <springfit/motion/contact_section.h>
#include <springfit/response/expression.h>
#include <springfit/response/statements.h>

#include <cmath>
#include <sstream>

namespace springfit
{
  namespace
  {
    /** Numbers that depend on time. */
    template <int dim>
    class NumbersInTime
    {
    public:
      NumbersInTime(const Statement &statement,
                    const std::size_t n,
                    const std::string &entry,
                    const std::string &advice)
      {
        if (statement.values.size() != n || !statement.load_case.empty())
          throw EntryError(entry,
                           "'" + statement.place + "' has " +
                             std::to_string(statement.values.size()) +
                             " numbers, not " + std::to_string(n) + '.',
                           advice);
        for (const auto &value : statement.values)
          {
            expressions_.push_back(
              Expression<dim>::of_place_and_time(value, entry, advice));
            if (expressions_.back().depends_on_place())
              throw EntryError(entry,
                               "'" + value + "' depends on the place.",
                               advice);
          }
      }

      Eigen::VectorXd
      at(const double time) const
      {
        Eigen::VectorXd numbers(expressions_.size());
        for (std::size_t i = 0; i < expressions_.size(); ++i)
          numbers[i] = expressions_[i].value({}, time);
        return numbers;
      }

    private:
      std::vector<Expression<dim>> expressions_;
    };

    template <int dim>
    std::function<Shape(double)>
    plane(const Statement &statement)
    {
      const std::string entry = "Contact/Planes";
      const std::string advice =
        "Give a name, a colon, a point in m and the outward normal, between "
        "commas and of t, if need be.";
      const NumbersInTime<dim> numbers(statement, 2 * dim, entry, advice);
      return [numbers, entry, advice, name = statement.place](const double t) {
        const Eigen::VectorXd values = numbers.at(t);
        const Eigen::VectorXd normal = values.tail(dim);
        if (!(normal.norm() > 0.))
          throw EntryError(entry, "'" + name + "' has no normal.", advice);
        return Plane{values.head(dim), normal.normalized()};
      };
    }

    template <int dim>
    std::function<Shape(double)>
    sphere(const Statement &statement)
    {
      const std::string entry = "Contact/Spheres";
      const std::string advice =
        "Give a name, a colon, the centre and the radius in m, between commas "
        "and of t, if need be.";
      const NumbersInTime<dim> numbers(statement, dim + 1, entry, advice);
      return [numbers, entry, advice, name = statement.place](const double t) {
        const Eigen::VectorXd values = numbers.at(t);
        if (values[dim] < 0.)
          {
            std::ostringstream what;
            what << "the radius of '" << name << "' is " << values[dim]
                 << " m at the time " << t << " s.";
            throw EntryError(entry, what.str(), advice);
          }
        return Sphere{values.head(dim), values[dim]};
      };
    }
  } // namespace

  template <int dim>
  Contact<dim>::Contact() : dealii::ParameterAcceptor("Contact")
  {
    add_parameter("Planes",
                  planes_,
                  std::string("Solid half spaces that push at nodes, between "
                              "semicolons: a name, a point on it in m and its "
                              "outward normal, \"") +
                    (dim == 2 ? "floor: 0, -0.01, 0, 1"
                              : "floor: 0, 0, -0.01, 0, 0, 1") +
                    "\". All numbers may be expressions of t in s.");
    add_parameter("Spheres",
                  spheres_,
                  std::string("Solid balls that push at nodes: a name, the "
                              "centre and the radius in m, \"ball: ") +
                    (dim == 2 ? "0.01, 0.03 - 0.1 * t, 0.005"
                              : "0.01, 0.01, 0.03 - 0.1 * t, 0.005") +
                    "\". All numbers may be expressions of t in s.");
    add_parameter("Stiffness",
                  stiffness_,
                  "Force on a node per depth, N/m. 0 takes ten times the mean "
                  "stiffness of the body's nodes.");
  }

  template <int dim>
  std::vector<Obstacle>
  Contact<dim>::obstacles() const
  {
    if (!(stiffness_ >= 0. && std::isfinite(stiffness_)))
      throw EntryError("Contact/Stiffness",
                       "it is negative or not finite.",
                       "Give a number in N/m, or 0 for an automatic one.");
    std::vector<Obstacle> obstacles;
    for (const auto &statement : parse_statements(planes_, "Contact/Planes"))
      obstacles.push_back({statement.place, plane<dim>(statement), stiffness_});
    for (const auto &statement : parse_statements(spheres_, "Contact/Spheres"))
      obstacles.push_back(
        {statement.place, sphere<dim>(statement), stiffness_});
    return obstacles;
  }

  template class Contact<2>;
  template class Contact<3>;
} // namespace springfit
