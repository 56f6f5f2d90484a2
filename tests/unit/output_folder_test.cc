#include <springfit/core/error.h>
#include <springfit/core/output_folder.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <string>

namespace
{
  using namespace springfit;
  namespace fs = std::filesystem;

  /** A folder of its own for each test, beside nothing else. */
  class Folder : public ::testing::Test
  {
  protected:
    Folder()
      : base(fs::temp_directory_path() /
             (std::string("springfit_folder_") +
              ::testing::UnitTest::GetInstance()->current_test_info()->name()))
      , out(base / "out")
      , start(fs::current_path())
    {
      fs::remove_all(base);
      fs::create_directories(base);
    }

    ~Folder() override
    {
      fs::current_path(start);
      fs::remove_all(base);
    }

    static bool
    is_result(const std::string &name)
    {
      return fs::path(name).extension() == ".csv";
    }

    static void
    write(const fs::path &file, const std::string &text)
    {
      std::ofstream(file) << text;
    }

    static std::string
    read(const fs::path &file)
    {
      std::string text;
      std::ifstream(file) >> text;
      return text;
    }

    static std::set<std::string>
    names(const fs::path &folder)
    {
      std::set<std::string> all;
      for (const auto &entry : fs::directory_iterator(folder))
        all.insert(entry.path().filename());
      return all;
    }

    /** A run that writes a record and one table. */
    static void
    run(const fs::path &folder, const std::string &table)
    {
      OutputFolder output(folder, is_result);
      write(output.draft() / "used.prm", table);
      write(output.draft() / (table + ".csv"), table);
      output.publish();
    }

    const fs::path base, out, start;
  };

  TEST_F(Folder, ARunReplacesTheFilesOfAnEarlierOneAndNothingElse)
  {
    run(out, "first");
    EXPECT_EQ(names(out), (std::set<std::string>{"first.csv", "used.prm"}));
    write(out / "notes.txt", "mine");
    fs::create_directory(out / "pictures");
    write(out / "pictures" / "a.csv", "mine");
    fs::create_symlink("nowhere", out / "link");
    write(out / "first.csv.part", "of_a_killed_run");
    run(out, "second");
    EXPECT_EQ(names(out),
              (std::set<std::string>{
                "second.csv", "used.prm", "notes.txt", "pictures", "link"}));
    EXPECT_EQ(read(out / "used.prm"), "second");
    EXPECT_EQ(read(out / "notes.txt"), "mine");
    EXPECT_EQ(read(out / "pictures" / "a.csv"), "mine");
    EXPECT_EQ(names(base), (std::set<std::string>{"out"}));
  }

  TEST_F(Folder, WithoutARunInItAllFilesAreTheUsers)
  {
    fs::create_directory(out);
    write(out / "mine.csv", "mine");
    run(out, "first");
    EXPECT_EQ(read(out / "mine.csv"), "mine");
    EXPECT_EQ(read(out / "first.csv"), "first");
  }

  TEST_F(Folder, WhatIsNotPublishedChangesNothing)
  {
    run(out, "first");
    {
      OutputFolder output(out, is_result);
      EXPECT_TRUE(output.holds_results());
      write(output.draft() / "used.prm", "second");
    }
    EXPECT_EQ(read(out / "used.prm"), "first");
    EXPECT_EQ(names(out), (std::set<std::string>{"first.csv", "used.prm"}));
    EXPECT_EQ(names(base), (std::set<std::string>{"out"}));
  }

  TEST_F(Folder, ARecordAloneIsNoResult)
  {
    OutputFolder output(out, is_result);
    write(output.draft() / "used.prm", "");
    write(output.draft() / "log.txt", "");
    write(output.draft() / "fit.csv", "");
    output.keep_record_only();
    output.publish();
    EXPECT_FALSE(output.holds_results());
    EXPECT_EQ(names(out), (std::set<std::string>{"log.txt", "used.prm"}));
  }

  TEST_F(Folder, ASecondRunIsRefused)
  {
    OutputFolder output(out, is_result);
    ASSERT_TRUE(output.is_locked());
    try
      {
        OutputFolder second(out, is_result);
        FAIL();
      }
    catch (const EntryError &error)
      {
        EXPECT_NE(std::string(error.what())
                    .find("another run is writing into "
                          "the folder '" +
                          out.string() + "'"),
                  std::string::npos);
      }
    output.publish(); // and the folder that was the draft is held as well
    EXPECT_THROW(OutputFolder(out, is_result), EntryError);
  }

  TEST_F(Folder, ALinkLeadsToTheFolder)
  {
    run(out, "first");
    fs::create_directory_symlink("out", base / "link");
    run(base / "link", "second");
    EXPECT_TRUE(fs::is_symlink(base / "link"));
    EXPECT_EQ(names(out), (std::set<std::string>{"second.csv", "used.prm"}));
  }

  TEST_F(Folder, TheWorkingDirectoryStaysTheSameFolder)
  {
    run(out, "first");
    fs::current_path(out);
    write("notes.txt", "mine");
    run(".", "second");
    EXPECT_EQ(names("."),
              (std::set<std::string>{"notes.txt", "second.csv", "used.prm"}));
    EXPECT_EQ(read("used.prm"), "second");
  }

  TEST_F(Folder, AKilledRunIsTidiedUp)
  {
    run(out, "first");
    // Killed before the exchange, and after it.
    const auto draft = base / ".out.springfit-part";
    fs::create_directories(draft / "pictures");
    write(draft / "old.csv", "old");
    write(draft / "used.prm", "old");
    write(draft / "notes.txt", "mine");
    run(out, "second");
    EXPECT_EQ(names(out),
              (std::set<std::string>{
                "second.csv", "used.prm", "notes.txt", "pictures"}));
    EXPECT_EQ(names(base), (std::set<std::string>{"out"}));
  }

  TEST_F(Folder, MovingIsFinishedByTheNextRun)
  {
    run(out, "first");
    const auto moving = out / ".springfit-new";
    fs::create_directory(moving);
    write(moving / "stale_files", "first.csv\n");
    write(moving / "second.csv", "second");
    write(out / "moved.csv", "moved_before_the_kill");
    {
      OutputFolder next(out, is_result); // and it fails
    }
    EXPECT_EQ(names(out),
              (std::set<std::string>{"moved.csv", "second.csv", "used.prm"}));
  }

  TEST_F(Folder, AFolderInTheWayIsRefused)
  {
    fs::create_directories(out / "log.txt");
    EXPECT_THROW(OutputFolder(out, is_result), EntryError);
    EXPECT_EQ(names(out), (std::set<std::string>{"log.txt"}));
  }
} // namespace
