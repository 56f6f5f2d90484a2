#include <springfit/core/error.h>
#include <springfit/motion/checkpoint.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

using namespace springfit;

namespace
{
  struct Checkpoint : testing::Test
  {
    const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "checkpoint.bin";
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(3, 7);

    void
    SetUp() override
    {
      CheckpointWriter writer;
      writer << 1. / 3. << std::uint64_t(42) << std::string("two\nlines")
             << matrix << -0.;
      writer.write(path);
    }
  };
} // namespace

TEST_F(Checkpoint, is_read_to_the_same_bits)
{
  CheckpointReader reader(path);
  double third, zero;
  std::uint64_t number;
  std::string text;
  Eigen::MatrixXd same;
  reader >> third >> number >> text >> same >> zero;
  EXPECT_EQ(third, 1. / 3.);
  EXPECT_EQ(number, 42u);
  EXPECT_EQ(text, "two\nlines");
  EXPECT_EQ(same, matrix);
  EXPECT_TRUE(std::signbit(zero));
  EXPECT_THROW(reader >> zero, InputError); // nothing is left
}

TEST_F(Checkpoint, is_refused_with_any_byte_changed_or_missing)
{
  std::ifstream file(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  const auto refuses = [&](const std::string &damaged) {
    std::ofstream(path, std::ios::binary) << damaged;
    EXPECT_THROW(CheckpointReader{path}, InputError);
  };
  for (std::size_t i = 0; i < bytes.size(); ++i)
    {
      std::string damaged = bytes;
      damaged[i] ^= 1;
      refuses(damaged);
      refuses(bytes.substr(0, i));
    }
  refuses(bytes + 'x');
}

// The published value of the test string "foobar".
TEST(Checksum, is_fnv_1a)
{
  EXPECT_EQ(checksum("foobar"), 0x85944171f73967e8u);
}
