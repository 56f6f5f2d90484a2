#include <springfit/calibration/packed_fit.h>

#include <Eigen/Core>

#include <cstddef>

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

      void
      put(const Eigen::VectorXd &vector)
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

      Eigen::VectorXd
      vector()
      {
        Eigen::VectorXd result(static_cast<Eigen::Index>(number()));
        for (double &entry : result)
          entry = number();
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
    writer.put(result.k);
    writer.put(result.angle_stiffness);
    writer.put(result.volume_stiffness);
    writer.put(static_cast<double>(result.couplings.size()));
    for (const auto &[a, b, stiffness] : result.couplings)
      {
        writer.put(static_cast<double>(a));
        writer.put(static_cast<double>(b));
        writer.put(stiffness);
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
    result.k                   = reader.vector();
    result.angle_stiffness     = reader.vector();
    result.volume_stiffness    = reader.optional();
    result.couplings.resize(static_cast<std::size_t>(reader.number()));
    for (auto &[a, b, stiffness] : result.couplings)
      {
        a         = static_cast<unsigned int>(reader.number());
        b         = static_cast<unsigned int>(reader.number());
        stiffness = reader.number();
      }
    return result;
  }
} // namespace springfit
