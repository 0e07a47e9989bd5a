// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/progress/stage_progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <sstream>
#include <string>
#include <thread>

#include "base/child_process.h"

namespace etendue::stage_progress_test {
namespace {

std::string shown(ProgressStyle style) {
  std::ostringstream out;
  StageProgress display(style, "picture front", out);
  for (int percent = 1; percent <= 100; ++percent) display.show(percent / 100.0, 0.11 * percent);
  display.finish();
  return out.str();
}

TEST(StageProgress, PlainLinesComeAtIntervals) {
  const std::string text = shown(ProgressStyle::plain);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);  // after 1.1 and 6.1 of 11 seconds
  EXPECT_EQ(text.rfind("  picture front: 10 %, about 10 s left\n", 0), 0U) << text;
}

TEST(StageProgress, DrawsOverItselfAndIsGoneInTheEnd) {
  const std::string text = shown(ProgressStyle::bar);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 0);
  EXPECT_TRUE(text.ends_with("\r\x1b[K"));
}

// What came before the first share was prepared once: half of 10 rows in 10 s after 90 s leave 10 s.
TEST(StageProgress, ReckonsWhatIsLeftFromItsFirstCall) {
  std::ostringstream out;
  StageProgress display(ProgressStyle::plain, "picture front", out);
  display.show(0.1, 90);
  display.show(0.5, 98);
  EXPECT_TRUE(out.str().ends_with("  picture front: 50 %, about 10 s left\n")) << out.str();
}

TEST(ShownStage, EndsWithinASecondOfASignalAndHasAMomentBefore) {
  std::ostringstream out;
  ShownStage stage({ProgressStyle::none, out, [] { return true; }}, "sensors");
  const StageObserver observer = stage.observer();
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_TRUE(observer(0.1));
  while (observer(0.2) && std::chrono::steady_clock::now() < begun + std::chrono::seconds(2))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(1));
}

// A copy of a process has one thread: what another one was about to do then is never done. Under the address
// sanitizer one of some thousand copies waited for ever for the thread that shows the stage.
TEST(ShownStage, LetsProcessesBeStarted) {
  std::ostringstream out;
  for (int repetition = 0; repetition < 500; ++repetition) {
    const ShownStage stage({ProgressStyle::plain, out, {}}, "meshing");
    const ChildOutcome child = run_in_child(
        [](std::FILE* result) { return std::fputs(std::string(100'000, 'x').c_str(), result) < 0 ? 1 : 0; },
        {});
    ASSERT_EQ(child.result.size(), 100'000U);
  }
}

TEST(StageProgress, CanBeSilent) { EXPECT_EQ(shown(ProgressStyle::none), ""); }

}  // namespace
}  // namespace etendue::stage_progress_test
