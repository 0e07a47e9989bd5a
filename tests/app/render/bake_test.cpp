// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/app/run/small_case.h"

namespace etendue::bake_test {
namespace {

using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::small_case;
using test::text_of;

TEST(Bake, WritesWhatTheWallsReceiveSendAndSee) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const std::filesystem::path results = folder.results();
  for (const std::string quantity : {"irradiance", "radiosity", "occlusion"}) {
    std::vector<std::string> arguments = {"bake", folder.results(), "--quantity", quantity};
    if (quantity == "occlusion") arguments.insert(arguments.end(), {"--sky", "zmax"});
    const Outcome bake = etendue_says(arguments);
    ASSERT_EQ(bake.code, ExitCode::done) << bake.err;
    EXPECT_TRUE(bake.out.starts_with("reading " + folder.results() + "\n")) << bake.out;
    EXPECT_TRUE(has(bake.out, "baked " + quantity + " at ")) << bake.out;
    const std::string ply = text_of(results / (quantity + ".ply"));
    const std::string number = quantity == "occlusion" ? "sky_visibility" : quantity + "_green";
    EXPECT_TRUE(has(ply, "property float " + number + "\n"));
    EXPECT_EQ(text_of(results / (quantity + ".glb")).substr(0, 4), "glTF");
    EXPECT_TRUE(has(text_of(results / (quantity + ".vtp")), "Name=\"" + number + "\""));
    EXPECT_TRUE(has(text_of(results / "summary.json"), quantity + ".glb")) << "a later run removes it";
    arguments.insert(arguments.end(), {"--texture", "64"});
    ASSERT_EQ(etendue_says(arguments).code, ExitCode::done);
    EXPECT_EQ(text_of(results / (quantity + ".texture.png")).substr(1, 3), "PNG");
    EXPECT_EQ(text_of(results / (quantity + ".texture.glb")).substr(0, 4), "glTF");
    EXPECT_FALSE(text_of(results / (quantity + ".texture.exr")).empty());
    arguments.insert(arguments.end(), {"--threads", "3"});
    ASSERT_EQ(etendue_says(arguments).code, ExitCode::done);
    EXPECT_EQ(text_of(results / (quantity + ".ply")), ply);
  }
}

TEST(Bake, SaysWhatItCannotDo) {
  const CaseFolder folder;
  EXPECT_TRUE(has(etendue_says({"bake", folder.results()}).err, "holds no case of an earlier run"));
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const Outcome closed = etendue_says({"bake", folder.results(), "--quantity", "occlusion"});
  EXPECT_EQ(closed.code, ExitCode::input_error);
  EXPECT_TRUE(
      has(closed.err,
          "bake: no wall is open to the sky (all outer ones shine or reflect); use --sky with one of "))
      << closed.err;
  const Outcome unknown =
      etendue_says({"bake", folder.results(), "--quantity", "occlusion", "--sky", "roof"});
  EXPECT_TRUE(has(unknown.err, "bake: --sky = roof: no such wall; use ")) << unknown.err;
  const Outcome useless = etendue_says({"bake", folder.results(), "--sky", "zmax"});
  EXPECT_TRUE(has(useless.err, "--sky: is for an occlusion")) << useless.err;
}

}  // namespace
}  // namespace etendue::bake_test
