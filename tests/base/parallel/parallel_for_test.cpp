// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/parallel/parallel_for.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace etendue::parallel_for_test {
namespace {

struct Count {
  int calls = 0;
};

TEST(ParallelFor, DoesEachOnce) {
  for (const int threads : {1, 2, 5}) {
    std::vector<int> done(1000, 0);
    EXPECT_TRUE(parallel_for(
        done.size(), threads, 8, [] { return Count{}; },
        [&](std::size_t i, Count& work) {
          ++done[i];
          return ++work.calls > 0;
        }));
    EXPECT_EQ(done, std::vector<int>(1000, 1)) << threads;
  }
}

TEST(ParallelFor, MakesAWorkspaceForEachThreadThatWorks) {
  std::atomic<int> made = 0;
  parallel_for(
      100, 3, 1,
      [&] {
        ++made;
        return Count{};
      },
      [](std::size_t, Count&) { return true; });
  EXPECT_GE(made, 1);
  EXPECT_LE(made, 3);
}

TEST(ParallelFor, ThrowsWhatABodyThrewAndBeginsNoMore) {
  for (const int threads : {1, 3}) {
    std::atomic<int> begun = 0;
    try {
      parallel_for(
          100000, threads, 1, [] { return Count{}; },
          [&](std::size_t i, Count&) -> bool {
            ++begun;
            throw std::runtime_error(std::to_string(i));
          });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error&) {
    }
    EXPECT_LE(begun, threads);
  }
}

TEST(ParallelFor, ThrowsWhatAWorkspaceThrew) {
  EXPECT_THROW(
      parallel_for(
          4, 2, 1, []() -> Count { throw std::bad_alloc(); }, [](std::size_t, Count&) { return true; }),
      std::bad_alloc);
}

TEST(ParallelFor, StopsWhereItIsAskedTo) {
  std::vector<int> done(100, 0);
  EXPECT_FALSE(parallel_for(
      done.size(), 1, 1, [] { return Count{}; },
      [&](std::size_t i, Count&) {
        done[i] = 1;
        return i < 9;
      }));
  EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 10);
}

}  // namespace
}  // namespace etendue::parallel_for_test
