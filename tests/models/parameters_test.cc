#include <springfit/core/parameter_text.h>

#include <gtest/gtest.h>

using namespace springfit;

TEST(Parameters, OtherValuesStandInTheSameText)
{
  const std::string text = "# a scene\n"
                           "set Study = compare\n"
                           "subsection Geometry\n"
                           "  set Study     = no\n"
                           "  set Cell size = \n"
                           "end\n";
  EXPECT_EQ(with_entries(text,
                         {{"Study", "dynamics"},
                          {"Geometry/Cell size", "0.1, 0.2"}}),
            "# a scene\n"
            "set Study = dynamics\n"
            "subsection Geometry\n"
            "  set Study     = no\n"
            "  set Cell size = 0.1, 0.2\n"
            "end\n");
  EXPECT_EQ(with_entries(text, {}), text);
}
