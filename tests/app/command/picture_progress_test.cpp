// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/picture_progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace etendue {
namespace {

std::string shown(ProgressStyle style) {
  std::ostringstream out;
  PictureProgress display(style, "front", out);
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

TEST(PictureProgress, CanBeSilent) { EXPECT_EQ(shown(ProgressStyle::none), ""); }

}  // namespace
}  // namespace etendue
