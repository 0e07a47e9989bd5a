// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/output_folder.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "tests/app/write/sample_run.h"

namespace etendue::output_folder_test {
namespace {

using test::ScratchFolder;
using test::text_of;
using test::write_text;
using Names = std::vector<std::string>;

std::string message_of_check(const std::filesystem::path& directory) {
  try {
    check_output_directory(directory);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(OutputFolder, IsMadeWithItsParents) {
  const ScratchFolder scratch;
  OutputFolder folder(scratch.path() / "a" / "b");
  EXPECT_TRUE(std::filesystem::is_directory(scratch.path() / "a" / "b"));
}

TEST(OutputFolder, ShowsNoFileBeforeAllArePublished) {
  const ScratchFolder scratch;
  OutputFolder folder(scratch.path());
  folder.add_text("one.csv", "1");
  folder.add_text("two.csv", "2");
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "one.csv"));
  folder.publish({});
  EXPECT_EQ(ScratchFolder::names_in(scratch.path()), (Names{"one.csv", "two.csv"}));
  EXPECT_EQ(text_of(scratch.path() / "two.csv"), "2");
}

TEST(OutputFolder, LeavesNothingWithoutPublishing) {
  const ScratchFolder scratch;
  {
    OutputFolder folder(scratch.path());
    folder.add_text("one.csv", "1");
  }
  EXPECT_EQ(ScratchFolder::names_in(scratch.path()), Names{});
}

TEST(OutputFolder, RemovesOutdatedFilesAndKeepsForeignOnes) {
  const ScratchFolder scratch;
  for (const char* name : {"old.csv", "both.csv", "notes.txt"}) write_text(scratch.path() / name, "before");
  OutputFolder folder(scratch.path());
  folder.add_text("both.csv", "after");
  folder.publish({"old.csv", "both.csv"});
  EXPECT_EQ(ScratchFolder::names_in(scratch.path()), (Names{"both.csv", "notes.txt"}));
  EXPECT_EQ(text_of(scratch.path() / "both.csv"), "after");
}

TEST(OutputFolder, BesideADirectoryOfTheUserFilesAreReplacedOneByOne) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch.path() / "mine");
  write_text(scratch.path() / "mine" / "notes.txt", "before");
  for (const char* name : {"old.csv", "both.csv", "summary.json"})
    write_text(scratch.path() / name, "before");
  OutputFolder folder(scratch.path());
  folder.add_text("both.csv", "after");
  folder.add_text("summary.json", "after");
  folder.publish({"old.csv", "both.csv", "summary.json"});
  EXPECT_EQ(ScratchFolder::names_in(scratch.path()), (Names{"both.csv", "mine", "summary.json"}));
  EXPECT_EQ(text_of(scratch.path() / "both.csv"), "after");
  EXPECT_EQ(text_of(scratch.path() / "summary.json"), "after");
  EXPECT_EQ(text_of(scratch.path() / "mine" / "notes.txt"), "before");
}

TEST(OutputFolder, RemovesWhatARunHasLeftThatWasKilledWhileItReplacedFiles) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch.path() / "mine");
  for (const char* name : {"old.csv", "both.csv", "notes.txt"}) write_text(scratch.path() / name, "before");
  write_text(scratch.path() / ".replaced-files", "old.csv\nboth.csv\n../notes.txt\nsummary.json\n");
  OutputFolder folder(scratch.path());
  folder.add_text("both.csv", "after");
  folder.add_text("summary.json", "after");
  folder.publish({});
  EXPECT_EQ(ScratchFolder::names_in(scratch.path()),
            (Names{"both.csv", "mine", "notes.txt", "summary.json"}));
}

TEST(OutputFolder, RefusesToReplaceADirectoryAndChangesNothing) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch.path() / "two.csv");
  write_text(scratch.path() / "one.csv", "before");
  {
    OutputFolder folder(scratch.path());
    folder.add_text("one.csv", "after");
    folder.add_text("two.csv", "after");
    EXPECT_THROW(folder.publish({}), FileError);
  }
  EXPECT_EQ(ScratchFolder::names_in(scratch.path()), (Names{"one.csv", "two.csv"}));
  EXPECT_EQ(text_of(scratch.path() / "one.csv"), "before");
}

TEST(OutputFolder, CheckNamesAFileInTheWay) {
  const ScratchFolder scratch;
  write_text(scratch.path() / "file", "");
  EXPECT_NE(message_of_check(scratch.path() / "file").find("file: the output directory cannot be made"),
            std::string::npos);
  EXPECT_NE(message_of_check(scratch.path() / "file" / "below").find("Not a directory"), std::string::npos);
}

TEST(OutputFolder, CheckNamesAPlaceWhereNoDirectoryCanBe) {
  EXPECT_NE(message_of_check("/proc/etendue/results").find("/proc/etendue/results: the output directory"),
            std::string::npos);
}

TEST(OutputFolder, CheckLeavesNothingBehind) {
  const ScratchFolder scratch;
  check_output_directory(scratch.path() / "a" / "b");
  check_output_directory(scratch.path());
  EXPECT_EQ(ScratchFolder::names_in(scratch.path()), Names{});
}

}  // namespace
}  // namespace etendue::output_folder_test
