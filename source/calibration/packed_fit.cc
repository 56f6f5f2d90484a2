#include <springfit/calibration/packed_fit.h>
#include <springfit/springs/spring_kinds.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace springfit
{
  namespace
  {
    /** Writes a row of numbers. */
    class Writer
    {
    public:
      std::vector<double> numbers;

      void
      put(const double number)
      {
        numbers.push_back(number);
      }

      void
      put(const std::optional<double> &number)
      {
        put(number ? 1. : 0.);
        put(number.value_or(0.));
      }

      template <typename Number>
      void
      put(const std::vector<Number> &vector)
      {
        put(static_cast<double>(vector.size()));
        numbers.insert(numbers.end(), vector.begin(), vector.end());
      }
    };

    /** Reads it again, in the same order. */
    class Reader
    {
    public:
      explicit Reader(const std::vector<double> &numbers) : numbers_(numbers)
      {}

      double
      number()
      {
        return numbers_.at(next_++);
      }

      std::optional<double>
      optional()
      {
        const bool is_given = number() != 0.;
        const double value  = number();
        return is_given ? std::optional<double>(value) : std::nullopt;
      }

      template <typename Number>
      std::vector<Number>
      vector()
      {
        std::vector<Number> result(static_cast<std::size_t>(number()));
        for (Number &entry : result)
          entry = static_cast<Number>(number());
        return result;
      }

    private:
      const std::vector<double> &numbers_;
      std::size_t next_ = 0;
    };
  } // namespace


  std::vector<double>
  pack(const FitResult &result)
  {
    Writer writer;
    writer.put(result.frobenius_residual);
    writer.put(result.spectral_residual);
    writer.put(result.duality_gap);
    writer.put(result.smallest_eigenvalue);
    writer.put(static_cast<double>(result.n_negative));
    writer.put(result.states_residual);
    writer.put(result.by_other_engine ? 1. : 0.);
    writer.put(static_cast<double>(result.families.size()));
    for (const auto &family : result.families)
      {
        writer.put(static_cast<double>(number_of(*family.kind)));
        writer.put(family.members.nodes);
        for (const auto &column : family.members.columns)
          writer.put(column);
      }
    return writer.numbers;
  }


  FitResult
  unpack(const std::vector<double> &numbers)
  {
    Reader reader(numbers);
    FitResult result;
    result.frobenius_residual  = reader.number();
    result.spectral_residual   = reader.number();
    result.duality_gap         = reader.optional();
    result.smallest_eigenvalue = reader.optional();
    result.n_negative          = static_cast<unsigned int>(reader.number());
    result.states_residual     = reader.optional();
    result.by_other_engine     = reader.number() != 0.;
    const auto n_families      = static_cast<std::size_t>(reader.number());
    for (std::size_t f = 0; f < n_families; ++f)
      {
        Family family(
          *spring_kinds().at(static_cast<std::size_t>(reader.number())));
        family.members.nodes = reader.vector<unsigned int>();
        for (auto &column : family.members.columns)
          column = reader.vector<double>();
        result.families.push_back(std::move(family));
      }
    return result;
  }
} // namespace springfit
