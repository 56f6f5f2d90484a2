#include <springfit/comparison/rungs.h>

#include <algorithm>
#include <cmath>

namespace springfit
{
  namespace
  {
    /** Of a cell: the first model all of whose contributions are small. */
    unsigned int
    first_below(const std::vector<Eigen::MatrixXd> &contributions,
                const Eigen::Index cell,
                const unsigned int least,
                const double threshold)
    {
      const unsigned int n_models = contributions.front().cols();
      for (unsigned int k = least; k < n_models; ++k)
        if (std::all_of(contributions.begin(),
                        contributions.end(),
                        [&](const auto &of_case) {
                          return std::abs(of_case(cell, k)) <= threshold;
                        }))
          return k;
      return n_models - 1;
    }

    double
    largest_sum(const std::vector<Eigen::MatrixXd> &contributions,
                const std::vector<unsigned int> &rungs)
    {
      double largest = 0.;
      for (const auto &of_case : contributions)
        {
          double sum = 0.;
          for (std::size_t c = 0; c < rungs.size(); ++c)
            sum += of_case(c, rungs[c]);
          largest = std::max(largest, std::abs(sum));
        }
      return largest;
    }
  } // namespace

  std::vector<unsigned int>
  choose_rungs(const std::vector<Eigen::MatrixXd> &contributions,
               const std::vector<unsigned int> &least,
               const double tolerance)
  {
    const auto with_threshold = [&](const double threshold) {
      std::vector<unsigned int> rungs;
      for (std::size_t c = 0; c < least.size(); ++c)
        rungs.push_back(first_below(contributions, c, least[c], threshold));
      return rungs;
    };
    double threshold = 0.;
    for (const auto &of_case : contributions)
      threshold = std::max(threshold, of_case.cwiseAbs().maxCoeff());
    // Finer steps would save few cells.
    constexpr double factor           = 0.8;
    constexpr unsigned int most_steps = 150;
    auto rungs                        = with_threshold(threshold);
    for (unsigned int i = 0;
         i < most_steps && largest_sum(contributions, rungs) > tolerance;
         ++i)
      {
        threshold *= factor;
        rungs = with_threshold(threshold);
      }
    return rungs;
  }
} // namespace springfit
