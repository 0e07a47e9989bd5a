// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/parallel/stage_observer.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "base/parallel/parallel_for.h"

namespace etendue::stage_observer_test {
namespace {

TEST(StageCounter, TellsTheObserverSharesThatGrowToOne) {
  std::vector<double> shares;
  StageCounter counter(300, [&](double share) {
    shares.push_back(share);
    return true;
  });
  parallel_for(300, 3, 1, [&](std::size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return counter.add();
  });
  ASSERT_GE(shares.size(), 2U);
  EXPECT_EQ(shares.back(), 1);
  for (const double share : shares) EXPECT_TRUE(share > 0 && share <= 1);
  EXPECT_FALSE(counter.stopped());
}

TEST(StageCounter, StopsAllThreadsWhereTheObserverSaysSo) {
  std::atomic<int> done = 0;
  StageCounter counter(1000000, [](double) { return false; });
  const bool whole = parallel_for(1000000, 3, 1, [&](std::size_t) {
    ++done;
    return counter.add();
  });
  EXPECT_FALSE(whole);
  EXPECT_TRUE(counter.stopped());
  EXPECT_LT(done, 1000);
}

TEST(StageCounter, AsksSeldom) {
  int asked = 0;
  StageCounter counter(1000000, [&](double) {
    ++asked;
    return true;
  });
  for (int i = 0; i < 1000000; ++i) counter.add();
  EXPECT_LT(asked, 200);
}

TEST(StageCounter, GoesOnWithoutAnObserver) {
  StageCounter counter(2, {});
  EXPECT_TRUE(counter.add(5));
}

}  // namespace
}  // namespace etendue::stage_observer_test
