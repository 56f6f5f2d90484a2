#include <springfit/comparison/tradeoff.h>
#include <springfit/output/tradeoff_table.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace springfit;

namespace
{
  TradeoffRow
  row(const std::string &fit, const double e_rms, const double step)
  {
    TradeoffRow result{};
    result.model         = "springs";
    result.fit           = fit;
    result.enrichment    = "none";
    result.kinematics    = "linear";
    result.cells         = "hexahedra";
    result.cell_size     = 0.005;
    result.e_rms         = e_rms;
    result.implicit_step = step;
    return result;
  }

  // In s and per cent: the third is beaten by the second in both.
  std::vector<TradeoffRow>
  four_rows()
  {
    return {row("cheap", 8., 0.001),
            row("good", 3., 0.002),
            row("beaten", 4., 0.003),
            row("best", 0.5, 0.01)};
  }

  Demand
  demand(const double accuracy, const double budget)
  {
    return {accuracy, budget, Purpose::implicit_motion, 0.01};
  }
} // namespace

TEST(Tradeoff, MarksTheFront)
{
  auto rows = four_rows();
  rows.push_back(rows[1]); // as good as another: both are
  rows.push_back(row("fails", 1., 0.));
  rows.back().e_rms.reset();
  mark_front(Purpose::implicit_motion, 0.01, rows);
  std::vector<bool> front;
  for (const auto &one : rows)
    front.push_back(one.is_on_front);
  EXPECT_EQ(front, (std::vector<bool>{true, true, false, true, true, false}));
}

TEST(Tradeoff, AdvisesTheCheapestThatMeetsBoth)
{
  const auto rows = four_rows();
  EXPECT_EQ(advise(rows, demand(5., 0.)).chosen, 1u);
  EXPECT_EQ(advise(rows, demand(10., 0.)).chosen, 0u);
  EXPECT_EQ(advise(rows, demand(0.5, 0.01)).chosen, 3u);

  const auto too_slow = advise(rows, demand(1., 0.005));
  EXPECT_FALSE(too_slow.chosen);
  EXPECT_EQ(too_slow.cheapest_accurate, 3u);
  EXPECT_EQ(too_slow.most_accurate_affordable, 1u);

  const auto too_strict = advise(rows, demand(0.1, 0.0005));
  EXPECT_FALSE(too_strict.chosen || too_strict.cheapest_accurate ||
               too_strict.most_accurate_affordable);
  EXPECT_EQ(too_strict.most_accurate, 3u);
  EXPECT_FALSE(advise({}, demand(1., 1.)).most_accurate);
}

TEST(Tradeoff, CountsTheStepsThatStabilityAsksFor)
{
  TradeoffRow one = row("springs", 1., 1.);
  EXPECT_FALSE(cost(one, Purpose::explicit_motion, 0.01));
  one.explicit_step = 2e-5;
  one.stable_step   = 1e-3; // 0.01 s are 11.1 steps of 0.9 ms
  EXPECT_DOUBLE_EQ(*cost(one, Purpose::explicit_motion, 0.01), 12 * 2e-5);
  one.stable_step = 1.;
  EXPECT_DOUBLE_EQ(*cost(one, Purpose::explicit_motion, 0.01), 2e-5);
}

TEST(Tradeoff, SaysWhereErrorsCancel)
{
  auto rows = four_rows();
  for (const double part : {0.25, 0.5})
    {
      rows.push_back(row("good", part == 0.5 ? 9. : 2., 0.02));
      rows.back().cell_size *= part;
    }
  EXPECT_EQ(finer_and_worse(rows, 1), 5u); // the next one, not the finest
  EXPECT_FALSE(finer_and_worse(rows, 3));
  EXPECT_FALSE(finer_and_worse(rows, 5));
  const Demand wanted = demand(5., 0.01);
  EXPECT_NE(sentence(rows, wanted, advise(rows, wanted), 0.01)
              .find(
                "On cells of 2.5 mm its error is 9 %: on these softness and "
                "locking cancel in part"),
            std::string::npos);
}

TEST(Tradeoff, SaysWhatCannotBeHad)
{
  const auto rows = four_rows();
  const auto say  = [&](const double accuracy, const double budget) {
    const Demand wanted = demand(accuracy, budget);
    return sentence(rows, wanted, advise(rows, wanted), 0.01);
  };
  EXPECT_NE(say(5., 0.01).find("Take good, linear, hexahedra of 5 mm (3 % "
                               "from the reference, 2 ms"),
            std::string::npos);
  EXPECT_EQ(say(5., 0.01).find("cancel"), std::string::npos);
  EXPECT_NE(say(1., 0.005).find("2 times that"), std::string::npos);
  EXPECT_NE(say(0.1, 0.).find("No model is within 0.1 %: the most accurate is "
                              "best"),
            std::string::npos);
}
