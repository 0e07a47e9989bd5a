// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/publish/staging_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "app/write/result/output_folder.h"
#include "tests/app/write/sample_run.h"

namespace etendue::staging_folder_test {
namespace {

namespace fs = std::filesystem;

using test::ScratchFolder;
using test::text_of;
using test::write_text;
using Names = std::vector<std::string>;

/// A directory of results in a directory of its own, so that what is beside it can be listed.
struct Results {
  ScratchFolder scratch;
  fs::path path = scratch.path() / "results";

  Results() { fs::create_directory(path); }
  Names names() const { return ScratchFolder::names_in(path); }
  Names beside() const { return ScratchFolder::names_in(scratch.path()); }
};

ino_t number_of(const fs::path& directory) {
  struct stat status {};
  EXPECT_EQ(stat(directory.c_str(), &status), 0);
  return status.st_ino;
}

/// A process that has ended.
pid_t ended_process() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return child;
}

void leave_part(const fs::path& folder, const std::string& name) {
  fs::create_directory(folder / name);
  write_text(folder / name / "fields.vtu", "half of it");
}

TEST(StagingFolder, IsHiddenBesideTheTargetAndRemovedAtItsEnd) {
  const Results results;
  {
    const StagingFolder staging(results.path);
    EXPECT_EQ(staging.path().parent_path(), results.path.parent_path());
    EXPECT_TRUE(staging.path().filename().string().starts_with(".results."));
    write_text(staging.path() / "one.csv", "1");
  }
  EXPECT_EQ(results.beside(), Names{"results"});
}

TEST(StagingFolder, ExchangeKeepsTheDirectoryItsModeAndForeignFiles) {
  const Results results;
  for (const char* name : {"old.csv", "both.csv", "notes.txt"}) write_text(results.path / name, "before");
  fs::permissions(results.path, fs::perms::owner_all | fs::perms::group_read);
  const ino_t number = number_of(results.path);
  {
    StagingFolder staging(results.path);
    write_text(staging.path() / "both.csv", "after");
    ASSERT_TRUE(staging.exchange({"old.csv", "both.csv"}, {"both.csv"}));
  }
  EXPECT_EQ(results.names(), (Names{"both.csv", "notes.txt"}));
  EXPECT_EQ(text_of(results.path / "both.csv"), "after");
  EXPECT_EQ(text_of(results.path / "notes.txt"), "before");
  EXPECT_EQ(number_of(results.path), number) << "who works in the directory stays in it";
  EXPECT_EQ(fs::status(results.path).permissions(), fs::perms::owner_all | fs::perms::group_read);
  EXPECT_EQ(results.beside(), Names{"results"});
}

TEST(StagingFolder, DoesNotExchangeADirectoryWithDirectories) {
  const Results results;
  fs::create_directory(results.path / "mine");
  write_text(results.path / "one.csv", "before");
  StagingFolder staging(results.path);
  write_text(staging.path() / "one.csv", "after");
  EXPECT_FALSE(staging.exchange({"one.csv"}, {"one.csv"}));
  EXPECT_EQ(text_of(results.path / "one.csv"), "before");
}

TEST(StagingFolder, WhatKilledRunsLeaveIsRemovedAtTheNextStart) {
  const Results results;
  const std::string process = std::to_string(ended_process());
  leave_part(results.scratch.path(), ".results." + process + ".0.part");
  leave_part(results.path, ".results." + process + ".3.part");
  write_text(results.path / (".fields.vtu." + process + ".part"), "of an earlier version");
  write_text(results.path / "notes.part", "of the user");
  leave_part(results.scratch.path(), ".other." + process + ".0.part");
  check_output_directory(results.path);
  EXPECT_EQ(results.names(), Names{"notes.part"});
  EXPECT_EQ(results.beside(), (Names{".other." + process + ".0.part", "results"}));
}

TEST(StagingFolder, OfARunThatLivesStays) {
  const Results results;
  const StagingFolder staging(results.path);
  write_text(results.path / (".fields.vtu." + std::to_string(getpid()) + ".part"), "");
  check_output_directory(results.path);
  EXPECT_TRUE(fs::exists(staging.path()));
  EXPECT_EQ(results.names().size(), 1u);
}

/// Publishes three files of one number, again and again, until it is killed.
[[noreturn]] void publish_for_ever(const fs::path& directory) {
  for (int number = 1;; ++number) {
    OutputFolder folder(directory);
    for (const char* name : {"a.csv", "b.csv", "summary.json"}) folder.add_text(name, std::to_string(number));
    folder.publish({"a.csv", "b.csv", "summary.json"});
  }
}

TEST(OutputFolder, IsWholeAfterAnyKill) {
  const Results results;
  write_text(results.path / "notes.txt", "mine");
  const Names whole = {"a.csv", "b.csv", "notes.txt", "summary.json"};
  for (int trial = 0; trial < 40; ++trial) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) publish_for_ever(results.path);
    while (!fs::exists(results.path / "summary.json")) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::microseconds(311 * trial));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    Names names = results.names();
    // A killed run may leave the trial of its directory, which the next start removes.
    std::erase_if(names, [](const std::string& name) {
      return name.starts_with(".results.") && name.ends_with(".part");
    });
    ASSERT_EQ(names, whole) << "kill " << trial;
    EXPECT_EQ(text_of(results.path / "a.csv"), text_of(results.path / "summary.json"));
    EXPECT_EQ(text_of(results.path / "b.csv"), text_of(results.path / "summary.json"));
  }
  check_output_directory(results.path);
  EXPECT_EQ(results.names(), whole);
  EXPECT_EQ(results.beside(), Names{"results"});
}

TEST(OutputFolder, TwoAtOnceDoNotMix) {
  const Results results;
  const auto publish = [&](const std::string& run) {
    for (int i = 0; i < 50; ++i) {
      OutputFolder folder(results.path);
      folder.add_text(run + ".csv", run);
      folder.add_text("summary.json", run);
      folder.lock();
      folder.publish({"a.csv", "b.csv", "summary.json"});
    }
  };
  const auto check = [&] {
    for (int i = 0; i < 50; ++i) check_output_directory(results.path);
  };
  { const std::jthread first(publish, "a"), second(publish, "b"), third(check); }
  const std::string last = text_of(results.path / "summary.json");
  EXPECT_EQ(results.names(), (Names{last + ".csv", "summary.json"}));
}

}  // namespace
}  // namespace etendue::staging_folder_test
