// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/bound_value.h"

#include <gtest/gtest.h>

#include "app/case/keys/case_tables.h"
#include "tests/app/case/case_text.h"

namespace etendue::bound_value_test {
namespace {

TEST(BoundValue, IsWrittenAsPeopleWriteIt) {
  EXPECT_EQ(to_toml(1e6), "1e6");
  EXPECT_EQ(to_toml(2e4), "2e4");
  EXPECT_EQ(to_toml(15000.0), "15000.0");
  EXPECT_EQ(to_toml(1e-6), "1e-6");
  EXPECT_EQ(to_toml(0.01), "0.01");
  EXPECT_EQ(to_toml(2.0), "2.0");
  EXPECT_EQ(to_toml(0.0), "0.0");
  EXPECT_EQ(to_toml(Vec3(0, 0, 1)), "[0, 0, 1]");
  EXPECT_EQ(to_toml(White{White::Kind::black_body, 5000}), "5000.0");
}

TEST(BoundTable, DeclaresTheDefaultOfTheMember) {
  EXPECT_EQ(find_key("solve", "max_sweeps")->default_value, std::to_string(SolveOptions{}.max_sweeps));
  EXPECT_EQ(find_key("solve", "method")->default_value, "\"auto\"");
  EXPECT_EQ(find_key("camera", "exposure")->default_value, "") << "an optional member";
  EXPECT_EQ(find_key("camera", "position")->default_value, "") << "a required key";
  EXPECT_EQ(find_key("radiosity", "patch_size")->default_value, "") << "a default that is described";
}

TEST(BoundTable, ReadsWhatIsGivenAndResolvesTheRest) {
  const Case input =
      case_of(cube + "[radiosity]\nsolution = \"shooting\"\n[solve]\nmethod = \"radiosity\"\n");
  ASSERT_TRUE(input.radiosity);
  EXPECT_EQ(input.radiosity->solution, RadiosityMethod::shooting);
  EXPECT_EQ(input.radiosity->path_rays, RadiosityCase{}.path_rays);
  EXPECT_NE(input.resolved_toml.find("path_rays = 1024"), std::string::npos);
  EXPECT_EQ(input.resolved_toml.find("patch_size"), std::string::npos);
}

}  // namespace
}  // namespace etendue::bound_value_test
