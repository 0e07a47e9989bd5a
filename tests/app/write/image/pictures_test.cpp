// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/write/json/summary.h"
#include "app/write/results.h"
#include "base/errors.h"
#include "tests/app/write/sample_run.h"

namespace etendue::pictures_test {
namespace {

using test::SampleRun;
using test::ScratchFolder;
using test::text_of;
using testing::ElementsAre;

Picture small_picture() { return {{2, 1}, 1, {0.5, 2}}; }

TEST(Pictures, JoinTheFilesOfARun) {
  const ScratchFolder folder;
  SampleRun run({"grey"});
  run.input.output.directory = folder.path();
  run.input.file = "case.toml";
  run.input.resolved_toml = "title = \"a\"\n";
  write_results(run.result());
  const CameraCase camera{"front", {}, 1.0, Tone::linear, {}, {}};
  EXPECT_THAT(add_pictures(folder.path(), run.input, {{camera, small_picture()}}),
              ElementsAre("front.exr", "front.png"));
  const std::vector<std::string> files = files_of_earlier_run(folder.path());
  EXPECT_EQ(std::count(files.begin(), files.end(), "front.png"), 1);
  add_pictures(folder.path(), run.input, {{camera, small_picture()}});
  EXPECT_EQ(files_of_earlier_run(folder.path()), files) << "taken again they are not listed twice";
  // What else the summary says stays, so that another picture can be taken.
  const auto saved = case_of_earlier_run(folder.path());
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->toml, "title = \"a\"\n");
  EXPECT_EQ(saved->file, std::filesystem::absolute("case.toml"));
}

TEST(Pictures, DoNotJoinTheFilesOfAnotherRun) {
  const ScratchFolder folder;
  SampleRun run({"grey"});
  run.input.output.directory = folder.path();
  write_results(run.result());
  test::make_of_another_process(folder.path());
  const std::vector<std::string> before = ScratchFolder::names_in(folder.path());
  const CameraCase camera{"front", {}, 1.0, Tone::linear, {}, {}};
  EXPECT_THROW(add_pictures(folder.path(), run.input, {{camera, small_picture()}}, 1.0), FileError);
  EXPECT_EQ(ScratchFolder::names_in(folder.path()), before);
}

TEST(Pictures, NeedNoRunBesideThem) {
  const ScratchFolder folder;
  SampleRun run({"grey"});
  const CameraCase camera{"front", {}, 1.0, Tone::linear, {}, {}};
  add_pictures(folder.path(), run.input, {{camera, small_picture()}});
  EXPECT_THAT(ScratchFolder::names_in(folder.path()), ElementsAre("front.exr", "front.png"));
  EXPECT_FALSE(case_of_earlier_run(folder.path()));
}

TEST(Pictures, TakeNoToneIntoTheLinearFile) {
  const ScratchFolder folder;
  SampleRun run({"grey"});
  const CameraCase a{"a", {}, 1.0, Tone::linear, {}, {}}, b{"b", {}, 0.1, Tone::aces, {}, {}};
  add_pictures(folder.path(), run.input, {{a, small_picture()}, {b, small_picture()}});
  EXPECT_EQ(text_of(folder.path() / "a.exr"), text_of(folder.path() / "b.exr"));
  EXPECT_NE(text_of(folder.path() / "a.png"), text_of(folder.path() / "b.png"));
}

}  // namespace
}  // namespace etendue::pictures_test
