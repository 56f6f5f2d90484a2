#include <springfit/core/error.h>
#include <springfit/response/statements.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace springfit;

TEST(Statements, have_a_case_a_place_and_values)
{
  const auto found = parse_statements(
    "press on top, \"a; b\": 0, max(1, 2), -2; floor : z;where x < 1e-6: x=t ;"
    " base;",
    "Loads/Supports");
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].load_case, "press");
  EXPECT_EQ(found[0].place, "top, \"a; b\"");
  EXPECT_EQ(found[0].values,
            (std::vector<std::string>{"0", "max(1, 2)", "-2"}));
  EXPECT_EQ(found[1].load_case, "");
  EXPECT_EQ(found[1].place, "floor");
  EXPECT_EQ(found[1].values, std::vector<std::string>{"z"});
  EXPECT_EQ(condition_of(found[2].place), "x < 1e-6");
  EXPECT_EQ(found[2].values, std::vector<std::string>{"x=t"});
  EXPECT_EQ(condition_of(found[3].place), "");
  EXPECT_TRUE(found[3].values.empty());
  EXPECT_TRUE(parse_statements("  ", "Loads/Forces").empty());
}

TEST(Statements, without_a_place_are_refused)
{
  for (const std::string text : {": 1, 2", "a: b: c", "a; : 1"})
    EXPECT_THROW(parse_statements(text, "Loads/Forces"), EntryError) << text;
}
