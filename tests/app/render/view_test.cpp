// SPDX-License-Identifier: AGPL-3.0-or-later
//
// scripts/view draws what a run wrote.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/app/run/small_case.h"
#include "tests/support/checkout.h"

namespace etendue::view_test {
namespace {

using test::CaseFolder;
using test::etendue_says;

/// A run of a small case, and pictures of it.
class View : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done); }

  /// Whether the script drew a PNG file with something in it.
  bool draws(const std::string& arguments) const {
    const std::filesystem::path picture = folder.path() / "picture.png";
    std::filesystem::remove(picture);
    const std::string command = test::checkout("scripts/view") + " " + (folder.path() / "results").string() +
                                "/" + arguments + " --pixels 300 200 --output " + picture.string() + " 2>" +
                                (folder.path() / "view.log").string();
    if (std::system(command.c_str()) != 0 || !std::filesystem::exists(picture)) return false;
    const std::string bytes = test::text_of(picture);
    return bytes.compare(1, 3, "PNG") == 0 && bytes.size() > 3000;
  }
  std::string complaint() const { return test::text_of(folder.path() / "view.log"); }

  CaseFolder folder;
};

TEST_F(View, DrawsWallsPlanesAndTheFlow) {
  EXPECT_TRUE(draws("walls.vtp")) << complaint();
  EXPECT_TRUE(draws("walls.vtp --array irradiance")) << complaint();
  EXPECT_TRUE(draws("fields.vtu --slice z 0.4 --log")) << complaint();
  EXPECT_TRUE(draws("fields.vtu --flow")) << complaint();
}

TEST_F(View, SaysWhatThereIsInstead) {
  EXPECT_FALSE(draws("fields.vtu --band ultraviolet"));
  EXPECT_NE(complaint().find("no band ultraviolet; there are "), std::string::npos) << complaint();
  EXPECT_FALSE(draws("walls.vtp --name roof"));
  EXPECT_NE(complaint().find("no wall roof; there are "), std::string::npos) << complaint();
  EXPECT_FALSE(draws("fields.vtu --slice z 7"));
  EXPECT_NE(complaint().find("does not cut it"), std::string::npos) << complaint();
}

}  // namespace
}  // namespace etendue::view_test
