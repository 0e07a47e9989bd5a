// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>

#include "tests/app/run/small_case.h"

namespace etendue::hostile_input_test {
namespace {

using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::small_case;

std::string camera_of(const std::string& name, const std::string& pixels) {
  return "[[camera]]\nname = \"" + name + "\"\nposition = [0.5, 0.5, 0.9]\nlook_at = [0.5, 0.5, 0.1]\n" +
         "up = [0, 1, 0]\npixels = " + pixels + "\n";
}

std::string sensor_of(const std::string& name) {
  return "[[sensor]]\nname = \"" + name +
         "\"\nkind = \"irradiance\"\nposition = [0.5, 0.5, 0.5]\nnormal = [0, 0, 1]\n";
}

/// Outcome of `check` with no more than this address space [bytes].
Outcome check_within(rlim_t memory, const std::string& file) {
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  const rlimit lowered{memory, before.rlim_max};
  setrlimit(RLIMIT_AS, &lowered);
  const Outcome outcome = etendue_says({"check", file});
  setrlimit(RLIMIT_AS, &before);
  return outcome;
}

/// The exit code of the program by a shell.
int code_of(const std::string& command) { return WEXITSTATUS(std::system(command.c_str())); }

TEST(HostileInput, ListsTwentyFaultsAndCountsTheRest) {
  std::string text = small_case();
  for (int i = 0; i < 5000; ++i) text += "key_" + std::to_string(i) + " = 1\n";
  const Outcome outcome = etendue_says({"check", CaseFolder(text).file()});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 21);
  EXPECT_TRUE(has(outcome.err, "\nand 4980 more, which are not listed\n")) << outcome.err;
}

TEST(HostileInput, NamesThatCannotNameFilesAreRefusedBeforeTheRun) {
  for (const std::string& name : {std::string(300, 'v'), std::string("v\\u0000w"), std::string("v\\nw"),
                                  std::string("../v"), std::string(".v")})
    for (const std::string& part : {camera_of(name, "[4, 4]"), sensor_of(name)}) {
      const Outcome outcome = etendue_says({"check", CaseFolder(small_case() + part).file()});
      EXPECT_EQ(outcome.code, ExitCode::input_error) << name;
      EXPECT_TRUE(has(outcome.err, "name a file; use ")) << outcome.err;
    }
}

TEST(HostileInput, PicturesBeyondTheMemoryAreRefusedBeforeTheRun) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer takes more address space than these limits";
#endif
  const CaseFolder folder(small_case() + camera_of("front", "[32768, 32768]"));
  const Outcome outcome = check_within(rlim_t{1} << 35, folder.file());
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(
      has(outcome.err, "case.toml:27: camera[0]: a picture of 32768 x 32768 pixels and 3 bands needs "))
      << outcome.err;
  EXPECT_TRUE(has(outcome.err, "use fewer pixels")) << outcome.err;
}

TEST(HostileInput, ProbesBeyondTheMemoryAreRefusedBeforeTheRun) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer takes more address space than these limits";
#endif
  const CaseFolder folder(small_case() +
                          "[[probe]]\nname = \"row\"\nline = { from = [0, 0, 0], to = [1, 1, 1], "
                          "count = 10000000 }\n");
  const Outcome outcome = check_within(rlim_t{3} << 30, folder.file());
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "probe[1]: 10000000 points and 3 bands need about ")) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "use fewer points")) << outcome.err;
}

TEST(HostileInput, AnEndlessCaseFileIsAFileError) {
  const Outcome outcome = etendue_says({"check", "/dev/zero"});
  EXPECT_EQ(outcome.code, ExitCode::file_error);
  EXPECT_TRUE(has(outcome.err, "/dev/zero: is larger than 64 MB")) << outcome.err;
}

TEST(HostileInput, AnEmptyOutputIsRefused) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"run", "case.toml", "--output", ""},
                                                {"render", "results", "--output", ""},
                                                {"mesh", "case.toml", "-o", ""}}) {
    const Outcome outcome = etendue_says(words);
    EXPECT_EQ(outcome.code, ExitCode::input_error);
    EXPECT_TRUE(has(outcome.err, ": --output: is empty; name a directory")) << outcome.err;
  }
}

TEST(HostileInput, LimitsOfTheSystemAreFileErrorsWithTheirCause) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer takes more address space than these limits";
#endif
  const CaseFolder folder;
  const std::string run = std::string(ETENDUE_PROGRAM) + " run " + folder.file() + " --no-estimate";
  const auto code_within = [&](const std::string& limit, const std::string& options) {
    return code_of("( ulimit " + limit + "; " + run + options + " ) > " + folder.file() + ".said 2>&1");
  };
  const auto said = [&] { return test::text_of(folder.file() + ".said"); };
  EXPECT_EQ(code_within("-f 8", ""), 3);
  EXPECT_TRUE(has(said(), "File too large")) << said();
  EXPECT_EQ(code_within("-n 5", ""), 3);
  EXPECT_TRUE(has(said(), "Too many open files")) << said();
  EXPECT_EQ(code_within("-v 2000000", " --threads 4096"), 3);
  EXPECT_TRUE(has(said(), "4096 threads: the system starts only ")) << said();
  EXPECT_FALSE(std::filesystem::exists(folder.results() + "/summary.json"));
}

}  // namespace
}  // namespace etendue::hostile_input_test
