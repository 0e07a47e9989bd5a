// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/child_process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace etendue {
namespace {

TEST(ChildProcess, GivesBackLinesResultAndExitCode) {
  std::vector<std::string> lines;
  const ChildOutcome outcome = run_in_child(
      [](std::FILE* result) {
        std::puts("first");
        std::fputs("second", stderr);
        std::fputs("bytes", result);
        return 7;
      },
      [&](std::string_view line) { lines.emplace_back(line); });
  EXPECT_EQ(lines, (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(outcome.exit_code, 7);
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_EQ(outcome.result, "bytes");
}

TEST(ChildProcess, OutlivesAChildThatIsKilled) {
  const ChildOutcome outcome = run_in_child([](std::FILE*) { return std::raise(SIGKILL); }, {});
  EXPECT_EQ(outcome.signal, SIGKILL);
  EXPECT_EQ(outcome.result, "");
}

TEST(ChildProcess, GetsNoMoreMemoryThanThereIs) {
  const ChildOutcome outcome = run_in_child(
      [](std::FILE*) {
        constexpr std::size_t kBlock = std::size_t{1} << 28;
        for (std::size_t taken = 0; taken < 2 * physical_memory(); taken += kBlock) {
          void* volatile block = std::malloc(kBlock);  // never touched, so it costs nothing
          if (block == nullptr) return 1;
        }
        return 0;
      },
      {});
  EXPECT_NE(outcome.exit_code, 0);
}

TEST(ChildProcess, ReportsAnExceptionOfTheWork) {
  std::string text;
  const ChildOutcome outcome = run_in_child([](std::FILE*) -> int { throw std::runtime_error("gone wrong"); },
                                            [&](std::string_view line) { text = line; });
  EXPECT_EQ(outcome.exit_code, 255);
  EXPECT_EQ(text, "gone wrong");
}

}  // namespace
}  // namespace etendue
