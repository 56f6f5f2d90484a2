#include <springfit/comparison/rungs.h>

#include <gtest/gtest.h>

using namespace springfit;

namespace
{
  // Three cells, three models from cheap to exact.
  Eigen::MatrixXd
  contributions()
  {
    Eigen::MatrixXd values(3, 3);
    values << 4., 1., 0., //
      0.5, 0.4, 0.,       //
      -0.2, -0.1, 0.;
    return values;
  }

  using Rungs = std::vector<unsigned int>;
} // namespace

TEST(Rungs, StayWhereTheSumIsSmallEnough)
{
  EXPECT_EQ(choose_rungs({contributions()}, {0, 0, 0}, 5.), (Rungs{0, 0, 0}));
}

TEST(Rungs, RaiseTheWorstCellsFirst)
{
  EXPECT_EQ(choose_rungs({contributions()}, {0, 0, 0}, 2.), (Rungs{1, 0, 0}));
  EXPECT_EQ(choose_rungs({contributions()}, {0, 0, 0}, 0.5), (Rungs{2, 0, 0}));
  EXPECT_EQ(choose_rungs({contributions()}, {0, 0, 0}, 0.), (Rungs{2, 2, 2}));
}

TEST(Rungs, NeverGoBelowWhatACellHas)
{
  EXPECT_EQ(choose_rungs({contributions()}, {0, 1, 2}, 5.), (Rungs{0, 1, 2}));
}

TEST(Rungs, SuitAllLoadCases)
{
  Eigen::MatrixXd other = Eigen::MatrixXd::Zero(3, 3);
  other(2, 0)           = 3.;
  EXPECT_EQ(choose_rungs({contributions(), other}, {0, 0, 0}, 2.),
            (Rungs{1, 0, 1}));
}
