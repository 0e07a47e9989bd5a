// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/picture_progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace etendue {
namespace {

std::string shown(ProgressStyle style) {
  std::ostringstream out;
  PictureProgress display(style, "picture front", out);
  for (int percent = 1; percent <= 100; ++percent) display.show(percent / 100.0, 0.11 * percent);
  display.finish();
  return out.str();
}

TEST(PictureProgress, PlainLinesComeAtIntervals) {
  const std::string text = shown(ProgressStyle::plain);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);  // after 5 and 10 of 11 seconds
  EXPECT_EQ(text.rfind("  picture front: 46 %, about 6 s left\n", 0), 0U) << text;
}

TEST(PictureProgress, DrawsOverItselfAndIsGoneInTheEnd) {
  const std::string text = shown(ProgressStyle::bar);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 0);
  EXPECT_TRUE(text.ends_with("\r\x1b[K"));
}

// What came before the first share was prepared once: half of 10 rows in 10 s after 90 s leave 10 s.
TEST(PictureProgress, ReckonsWhatIsLeftFromItsFirstCall) {
  std::ostringstream out;
  PictureProgress display(ProgressStyle::plain, "picture front", out);
  display.show(0.1, 90);
  display.show(0.5, 98);
  EXPECT_TRUE(out.str().ends_with("  picture front: 50 %, about 10 s left\n")) << out.str();
}

TEST(PictureProgress, CanBeSilent) { EXPECT_EQ(shown(ProgressStyle::none), ""); }

}  // namespace
}  // namespace etendue
