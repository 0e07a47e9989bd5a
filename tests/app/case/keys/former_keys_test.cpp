// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/key_check.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/case/case_text.h"

namespace etendue::former_keys_test {
namespace {

const std::string camera =
    cube + "[[camera]]\nname = \"front\"\nposition = [0, 0, 9]\nlook_at = [0, 0, 0]\nup = [0, 1, 0]\n";

TEST(FormerKeys, AreReadAndNoted) {
  const Case input = case_of(camera + "gather = 64\nglossy = 3\nshafts = 2\n", {"mesh.split=1"});
  ASSERT_EQ(input.cameras.size(), 1U);
  EXPECT_EQ(input.cameras[0].camera.gather, 64);
  EXPECT_EQ(input.cameras[0].camera.glossy, 3);
  EXPECT_EQ(input.cameras[0].camera.shafts, 2);
  EXPECT_EQ(input.mesh.refine, 1);
  ASSERT_EQ(input.deprecations.size(), 4U);
  EXPECT_EQ(input.deprecations.back(), "--set: mesh.split: deprecated name; use refine (accepted until 0.2)");
  const auto gather = std::ranges::find_if(input.deprecations, [](const std::string& line) {
    return line.find("slab.toml:12: camera[0].gather: deprecated name; use gather_rays") != std::string::npos;
  });
  EXPECT_NE(gather, input.deprecations.end());
}

TEST(FormerKeys, AreNotInTheResolvedCase) {
  const std::string before = case_of(camera + "gather = 64\n").resolved_toml;
  EXPECT_EQ(before, case_of(camera + "gather_rays = 64\n").resolved_toml);
  EXPECT_EQ(before.find("gather ="), std::string::npos);
  EXPECT_TRUE(case_of(before).deprecations.empty());
}

TEST(FormerKeys, AreRefusedBesideTheNewName) {
  EXPECT_EQ(
      faults_of(camera + "gather_rays = 64\ngather = 144\n"),
      "slab.toml:13: camera[0].gather = 144: given beside gather_rays, its new name; remove one of them");
}

TEST(FormerKeys, AreOverriddenByEitherName) {
  const std::string before = camera + "gather = 64\n", after = camera + "gather_rays = 64\n";
  for (const std::string& text : {before, after})
    for (const char* assignment : {"camera[0].gather=144", "camera[0].gather_rays=144"}) {
      const Case input = case_of(text, {assignment});
      ASSERT_EQ(input.cameras.size(), 1U);
      EXPECT_EQ(input.cameras[0].camera.gather, 144) << assignment;
    }
}

TEST(FormerKeys, KeepTheirChecksAndTheNameThatWasWritten) {
  EXPECT_EQ(faults_of(camera + "gather = 65\n"),
            "slab.toml:12: camera[0].gather = 65: is not known (did you mean \"64\"?); use 0, 64, 144, 256, "
            "576 or 1024");
}

}  // namespace
}  // namespace etendue::former_keys_test
