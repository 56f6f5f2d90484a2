#include <springfit/core/atomic_file.h>
#include <springfit/core/cell_kind.h>
#include <springfit/core/number_list.h>
#include <springfit/core/plane_stress.h>
#include <springfit/core/words.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace springfit;

namespace
{
  using Words = std::vector<std::string>;

  TEST(Words, NearestIsByEditDistanceWithoutCase)
  {
    const Words known = {"frobenius", "spectral", "block"};
    EXPECT_EQ(nearest_word("frobenus", known), "frobenius");
    EXPECT_EQ(nearest_word("Spectrl", known), "spectral");
    EXPECT_EQ(nearest_word("BLOCK", known), "block");
    EXPECT_EQ(nearest_word("lbock", known), "block");
  }

  TEST(Words, NothingIsNearToAStrangeWord)
  {
    EXPECT_EQ(nearest_word("elephant", {"frobenius", "block"}), "");
    EXPECT_EQ(nearest_word("x", {"ab"}), "");
    EXPECT_EQ(nearest_word("block", {}), "");
  }

  TEST(Words, DidYouMean)
  {
    EXPECT_EQ(did_you_mean("blok", {"block"}), " Did you mean 'block'?");
    EXPECT_EQ(did_you_mean("elephant", {"block"}), "");
  }

  TEST(Words, Join)
  {
    EXPECT_EQ(join({"a", "b", "c"}), "a, b, c");
    EXPECT_EQ(join({"a", "b"}, " | "), "a | b");
    EXPECT_EQ(join({}), "");
  }

  TEST(Words, SplitAtCommas)
  {
    EXPECT_EQ(split_at_commas("a, b c ,\td"), (Words{"a", "b c", "d"}));
    EXPECT_EQ(split_at_commas("a,,b,"), (Words{"a", "b"}));
    EXPECT_EQ(split_at_commas("  "), Words{});
    EXPECT_EQ(split_at_commas(""), Words{});
  }

  TEST(Words, TablesGoBothWays)
  {
    for (const auto &[kind, word] : cell_kind_words())
      {
        EXPECT_EQ(word_of(cell_kind_words(), kind), word);
        EXPECT_EQ(value_of(cell_kind_words(), word, "Geometry/Cells"), kind);
      }
  }

  TEST(Words, AnUnknownWordNamesEntryAndNearest)
  {
    try
      {
        value_of(cell_kind_words(), "tetrahedrons", "Geometry/Cells");
        FAIL() << "accepted";
      }
    catch (const EntryError &error)
      {
        const std::string text = error.what();
        EXPECT_EQ(error.entry, "Geometry/Cells");
        EXPECT_NE(text.find("'tetrahedrons'"), std::string::npos);
        EXPECT_NE(text.find("Did you mean 'tetrahedra'?"), std::string::npos);
        EXPECT_NE(text.find("quadrilaterals"), std::string::npos);
      }
  }

  TEST(CellKind, Counts)
  {
    EXPECT_EQ(dimension(CellKind::triangle), 2);
    EXPECT_EQ(dimension(CellKind::quadrilateral), 2);
    EXPECT_EQ(dimension(CellKind::tetrahedron), 3);
    EXPECT_EQ(dimension(CellKind::hexahedron), 3);
    EXPECT_EQ(n_vertices(CellKind::triangle), 3);
    EXPECT_EQ(n_vertices(CellKind::quadrilateral), 4);
    EXPECT_EQ(n_vertices(CellKind::tetrahedron), 4);
    EXPECT_EQ(n_vertices(CellKind::hexahedron), 8);
    EXPECT_TRUE(is_simplex(CellKind::tetrahedron));
    EXPECT_FALSE(is_simplex(CellKind::hexahedron));
    EXPECT_EQ(singular(CellKind::hexahedron), "hexahedron");
  }


  class AtomicFile : public ::testing::Test
  {
  protected:
    void
    SetUp() override
    {
      std::filesystem::remove_all(folder);
      std::filesystem::create_directory(folder);
    }

    void
    TearDown() override
    {
      std::filesystem::remove_all(folder);
    }

    std::string
    content(const std::filesystem::path &path) const
    {
      std::ifstream file(path);
      return {std::istreambuf_iterator<char>(file), {}};
    }

    std::size_t
    n_files() const
    {
      return std::distance(std::filesystem::directory_iterator(folder), {});
    }

    const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "springfit_atomic_file_test";
  };

  TEST_F(AtomicFile, IsWrittenAndReplaced)
  {
    write_file(folder / "a", [](std::ostream &out) { out << "first"; });
    write_file(folder / "a", [](std::ostream &out) { out << "second"; });
    EXPECT_EQ(content(folder / "a"), "second");
    EXPECT_EQ(n_files(), 1u);
  }

  TEST_F(AtomicFile, AFailureLeavesTheOldFileAlone)
  {
    write_file(folder / "a", [](std::ostream &out) { out << "first"; });
    EXPECT_THROW(write_file(folder / "a",
                            [](std::ostream &out) {
                              out << "half";
                              out.setstate(std::ios::badbit);
                            }),
                 RunError);
    EXPECT_EQ(content(folder / "a"), "first");
    EXPECT_EQ(n_files(), 1u);
  }

  TEST_F(AtomicFile, AFolderThatIsNotThereIsAnError)
  {
    EXPECT_THROW(write_file(folder / "none" / "a", [](std::ostream &) {}),
                 RunError);
  }

  std::vector<double>
  uniform(const std::string &text)
  {
    return parse_number_list(text, Spacing::uniform, "Section/Entry");
  }

  std::vector<double>
  logarithmic(const std::string &text)
  {
    return parse_number_list(text, Spacing::logarithmic, "Section/Entry");
  }

  TEST(NumberList, NumbersAndRanges)
  {
    EXPECT_EQ(uniform("0.3"), std::vector<double>({0.3}));
    EXPECT_EQ(uniform(" 3, -1e-2 ,2"), std::vector<double>({3., -0.01, 2.}));
    EXPECT_EQ(uniform("0 to 0.5 in 3, 7"),
              std::vector<double>({0., 0.25, 0.5, 7.}));
    EXPECT_EQ(uniform("0.1 to 0.7 in 2"), std::vector<double>({0.1, 0.7}));

    const auto decades = logarithmic("1 to 1e4 in 5");
    ASSERT_EQ(decades.size(), 5u);
    for (unsigned int i = 0; i < 5; ++i)
      EXPECT_NEAR(decades[i], std::pow(10., i), 1e-12 * decades[i]);
    EXPECT_EQ(logarithmic("0, -1"), std::vector<double>({0., -1.}));
  }

  TEST(NumberList, RefusesWhatIsEmptyOrUnreadable)
  {
    for (const std::string text : {"",
                                   " ",
                                   "1 to 0 in 3",
                                   "1 to 1 in 3",
                                   "0 to 1 in 0",
                                   "0 to 1 in 1",
                                   "0 to 1 in 2.5",
                                   "0 to 1 in 1e9",
                                   "0 to 1 in -2",
                                   "0 to 1",
                                   "0 to 1 by 3",
                                   "0 1",
                                   "one",
                                   "1e400",
                                   "nan",
                                   "0.3 Pa"})
      EXPECT_THROW(uniform(text), EntryError) << text;
    EXPECT_THROW(logarithmic("0 to 1 in 2"), EntryError);
  }

  TEST(PlaneStress, TheStretchAcrossLeavesNoStress)
  {
    const double mu = 0.8;
    for (const double nu : {0., 0.3, 0.49})
      for (const double log_J_plane : {-2., -0.3, 0., 0.5, 3.})
        {
          const double lambda       = 2. * mu * nu / (1. - 2. * nu);
          const double lambda_plane = 2. * lambda * mu / (lambda + 2. * mu);
          const auto c = squared_stretch_across(log_J_plane, lambda_plane, mu);
          ASSERT_TRUE(c);
          EXPECT_NEAR(mu * (*c - 1.) +
                        lambda * (log_J_plane + 0.5 * std::log(*c)),
                      0.,
                      1e-12 * (lambda + mu));
        }
    // The limit nu = 0.5 keeps the volume.
    EXPECT_NEAR(*squared_stretch_across(std::log(2.), 2. * mu, mu),
                0.25,
                1e-14);
    // Auxetic sheets have no such stretch under much compression.
    EXPECT_FALSE(squared_stretch_across(-10., -0.5 * mu, mu));
  }
} // namespace
