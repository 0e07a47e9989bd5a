// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/parallel/require_threads.h"

#include <gtest/gtest.h>

#include "base/child_process.h"
#include "base/errors.h"

namespace etendue::require_threads_test {
namespace {

TEST(RequireThreads, AcceptsWhatTheSystemStarts) {
  EXPECT_NO_THROW(require_threads(1));
  EXPECT_NO_THROW(require_threads(4));
}

TEST(RequireThreads, SaysHowManyThereAre) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer takes more address space than these limits";
#endif
  std::string said;
  const ChildOutcome outcome = run_in_child(
      [](std::FILE*) {
        try {
          require_threads(4096);
        } catch (const FileError& error) {
          std::puts(error.what());
          return 3;
        }
        return 0;
      },
      [&](std::string_view line) { said = line; }, std::size_t{1} << 28);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_TRUE(said.starts_with("4096 threads: the system starts only ")) << said;
  EXPECT_NE(said.find("use fewer (solve.threads or --threads)"), std::string::npos) << said;
}

}  // namespace
}  // namespace etendue::require_threads_test
