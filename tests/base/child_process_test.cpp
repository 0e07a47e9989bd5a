// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/child_process.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/errors.h"

namespace etendue::child_process_test {
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

TEST(ChildProcess, EndsAfterItsSecondsOfTheProcessor) {
  const ChildOutcome outcome = run_in_child(
      [](std::FILE*) {
        limit_processor_seconds(1);
        for (volatile bool on = true; on;) {
        }
        return 0;
      },
      {});
  EXPECT_EQ(outcome.signal, SIGXCPU);
}

TEST(ChildProcess, IsEndedByAnExceptionOfItsReader) {
  const auto work = [](std::FILE*) {
    std::puts("a line");
    for (;;) pause();
    return 0;
  };
  EXPECT_THROW(run_in_child(work, [](std::string_view line) { throw std::runtime_error(std::string(line)); }),
               std::runtime_error);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);  // no child is left
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

TEST(ChildProcess, MayBeGivenLessMemory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer takes more address space than these limits";
#endif
  const ChildOutcome outcome = run_in_child(
      [](std::FILE*) {
        void* volatile block = std::malloc(std::size_t{1} << 28);
        return block == nullptr ? 1 : 0;
      },
      {}, std::size_t{1} << 26);
  EXPECT_EQ(outcome.exit_code, 1);
}

TEST(ChildProcess, GivesBackLargeResultsBesideLines) {
  const std::string block(1 << 20, 'x');
  int lines = 0;
  const ChildOutcome outcome = run_in_child(
      [&](std::FILE* result) {
        for (int i = 0; i < 8; ++i) {
          std::fwrite(block.data(), 1, block.size(), result);
          for (int line = 0; line < 1000; ++line) std::puts("a line that is long enough to fill a pipe soon");
        }
        return 0;
      },
      [&](std::string_view) { ++lines; });
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.result.size(), 8 * block.size());
  EXPECT_EQ(lines, 8000);
}

/// Lowers a limit of this process for a while.
class LoweredLimit {
 public:
  LoweredLimit(__rlimit_resource kind, rlim_t value) : kind_(kind) {
    getrlimit(kind, &before_);
    const rlimit lowered{value, before_.rlim_max};
    setrlimit(kind, &lowered);
  }
  ~LoweredLimit() { setrlimit(kind_, &before_); }
  LoweredLimit(const LoweredLimit&) = delete;
  LoweredLimit& operator=(const LoweredLimit&) = delete;

 private:
  __rlimit_resource kind_;
  rlimit before_{};
};

TEST(ChildProcess, NeedsNoTemporaryFile) {
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const ChildOutcome outcome = [] {
    const LoweredLimit no_files(RLIMIT_FSIZE, 0);
    return run_in_child([](std::FILE* result) { return std::fputs("bytes", result) < 0 ? 1 : 0; }, {});
  }();
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.result, "bytes");
}

TEST(ChildProcess, SaysThatThereAreNoHandles) {
  std::string message;
  {
    const LoweredLimit few_handles(RLIMIT_NOFILE, 3);
    try {
      run_in_child([](std::FILE*) { return 0; }, {});
    } catch (const FileError& error) {
      message = error.what();
    }
  }
  EXPECT_NE(message.find("child process: cannot get a pipe (Too many open files)"), std::string::npos)
      << message;
}

TEST(MemoryToRead, GrowsWithTheFileUpToThatOfTheMachine) {
  EXPECT_EQ(memory_to_read("/nowhere"), physical_memory());
  const std::size_t small = memory_to_read("/proc/self/exe");
  EXPECT_GT(small, std::size_t{1} << 30);
  EXPECT_LE(small, physical_memory());
  EXPECT_EQ(memory_to_read("/nowhere/case.foam"), physical_memory());
}

TEST(ChildProcess, ReportsAnExceptionOfTheWork) {
  std::string text;
  const ChildOutcome outcome = run_in_child([](std::FILE*) -> int { throw std::runtime_error("gone wrong"); },
                                            [&](std::string_view line) { text = line; });
  EXPECT_EQ(outcome.exit_code, 255);
  EXPECT_EQ(text, "gone wrong");
}

}  // namespace
}  // namespace etendue::child_process_test
