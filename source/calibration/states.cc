#include <springfit/calibration/states.h>
#include <springfit/core/error.h>
#include <springfit/core/words.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <regex>
#include <sstream>

namespace springfit
{
  namespace
  {
    using Words = std::vector<std::string>;

    // Of what materials and meshes bear, with room to spare.
    constexpr double largest = 10.;

    /** Reads one state; its errors quote all of it. */
    class StateParser
    {
    public:
      StateParser(const std::string &state,
                  const int dim,
                  const std::string &entry)
        : state_(state), dim_(dim), entry_(entry)
      {}

      Eigen::MatrixXd
      deformation_gradient() const
      {
        std::istringstream stream(state_);
        const Words words{std::istream_iterator<std::string>(stream), {}};
        if (words[0] == "stretch")
          return stretch(words);
        if (words[0] == "shear")
          return shear(words);
        throw error("begins with '" + words[0] + "', which is not known." +
                    did_you_mean(words[0], {"stretch", "shear"}));
      }

      EntryError
      error(const std::string &what) const
      {
        return EntryError(entry_,
                          "'" + state_ + "' " + what,
                          "Give " + states_help() + '.');
      }

    private:
      /** stretch x 1.3 y 0.9 */
      Eigen::MatrixXd
      stretch(const Words &words) const
      {
        if (words.size() < 3 || words.size() % 2 == 0)
          throw error("is no stretch.");
        Eigen::MatrixXd F = Eigen::MatrixXd::Identity(dim_, dim_);
        std::vector<int> axes;
        for (std::size_t w = 1; w < words.size(); w += 2)
          {
            if (words[w].size() != 1)
              throw error("names no direction '" + words[w] + "'.");
            const int d = axis(words[w][0]);
            if (std::find(axes.begin(), axes.end(), d) != axes.end())
              throw error("stretches the direction " + words[w] + " twice.");
            axes.push_back(d);
            F(d, d) = number(words[w + 1]);
            if (!(F(d, d) > 0.))
              throw error("has a stretch that is not positive: it is the "
                          "deformed length divided by that at rest.");
            if (!(F(d, d) >= 1. / largest && F(d, d) <= largest))
              throw error("has a stretch that is not between 0.1 and 10.");
          }
        return F;
      }

      /** shear xy 0.3 */
      Eigen::MatrixXd
      shear(const Words &words) const
      {
        if (words.size() != 3)
          throw error("is no shear.");
        if (words[1].size() != 2 || words[1][0] == words[1][1])
          throw error("does not name two different directions, such as xy.");
        Eigen::MatrixXd F  = Eigen::MatrixXd::Identity(dim_, dim_);
        const double shear = number(words[2]);
        F(axis(words[1][0]), axis(words[1][1])) = shear;
        if (!(std::abs(shear) <= largest))
          throw error("has a shear that is not between -10 and 10.");
        return F;
      }

      int
      axis(const char letter) const
      {
        const std::string axes = dim_ == 2 ? "xy" : "xyz";
        const auto position    = axes.find(letter);
        if (position == std::string::npos)
          throw error(std::string("names a direction '") + letter +
                      "', which there is not in " + std::to_string(dim_) +
                      "-d.");
        return static_cast<int>(position);
      }

      double
      number(const std::string &word) const
      {
        // Not the hexadecimal numbers and the words that strtod() reads.
        static const std::regex decimal(
          "[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?");
        if (!std::regex_match(word, decimal))
          throw error("has '" + word + "' in place of a decimal number.");
        return std::strtod(word.c_str(), nullptr);
      }

      const std::string state_;
      const int dim_;
      const std::string entry_;
    };
  } // namespace

  const std::string &
  states_help()
  {
    static const std::string help =
      "states between commas, such as \"stretch x 1.3, stretch x 1.3 y 0.9, "
      "shear xy 0.3\"";
    return help;
  }

  std::vector<Eigen::MatrixXd>
  parse_states(const std::string &text, const int dim, const std::string &entry)
  {
    std::vector<Eigen::MatrixXd> states;
    for (const auto &state : split_at_commas(text))
      {
        const StateParser parser(state, dim, entry);
        const Eigen::MatrixXd F = parser.deformation_gradient();
        if (F.isIdentity(0.))
          throw parser.error("is the state at rest, which is always taken.");
        if (std::find(states.begin(), states.end(), F) != states.end())
          throw parser.error("is given twice.");
        states.push_back(F);
      }
    return states;
  }
} // namespace springfit
