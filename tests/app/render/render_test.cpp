// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/run/small_case.h"

namespace etendue::render_test {
namespace {

using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::ScratchFolder;
using test::small_case;
using test::text_of;
using test::write_text;

const std::string camera = R"(
[[camera]]
name = "front"
position = [0.5, -1.5, 0.5]
look_at = [0.5, 0.5, 0.5]
pixels = [16, 12]
)";

const std::string lamp = R"(
[[light]]
name = "bulb"
kind = "point"
position = [0.4, 0.4, 0.7]
power = 3
)";

/// The small case with anisotropic scattering, a lamp and a camera.
std::string hazy_case() {
  std::string text = small_case();
  const std::string scattering = "scattering = 1.0\n";
  text.insert(text.find(scattering), "phase = { model = \"henyey-greenstein\", g = 0.5 }\n");
  return text + lamp + camera;
}

TEST(Render, MakesThePicturesOfTheRunAgain) {
  const CaseFolder folder(hazy_case());
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  EXPECT_TRUE(has(run.out, "picture front: 16 x 12 pixels, 1 ray each")) << run.out;
  const std::filesystem::path results = folder.results();
  const std::string exr = text_of(results / "front.exr"), png = text_of(results / "front.png");
  std::filesystem::remove(results / "front.exr");
  std::filesystem::remove(results / "front.png");
  for (const std::string threads : {"1", "3"}) {
    const Outcome render = etendue_says({"render", folder.results(), "--threads", threads});
    ASSERT_EQ(render.code, ExitCode::done) << render.err;
    EXPECT_EQ(text_of(results / "front.exr"), exr) << threads;
    EXPECT_EQ(text_of(results / "front.png"), png) << threads;
  }
}

// The result keeps how much the rotated sets differ, so that the layer of the directions comes out again.
TEST(Render, HasTheErrorLayersOfTheRun) {
  const CaseFolder folder(hazy_case());
  const Outcome run = etendue_says(
      {"run", folder.file(), "--set", "directions.rotations=2", "--set", "camera.0.errors=true"});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const std::filesystem::path results = folder.results();
  const std::string exr = text_of(results / "front.exr");
  EXPECT_TRUE(has(exr, "error.directions.red"));
  std::filesystem::remove(results / "front.exr");
  ASSERT_EQ(etendue_says({"render", folder.results()}).code, ExitCode::done);
  EXPECT_EQ(text_of(results / "front.exr"), exr);
}

TEST(Render, TakesCamerasOfAnotherCase) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const std::string other = (folder.path() / "other.toml").string();
  // Without the probe, whose meter decided what the run kept.
  std::string text = small_case() + camera;
  const std::size_t probe = text.find("[[probe]]");
  write_text(other, text.erase(probe, text.find("[output]") - probe));
  const std::string pictures = (folder.path() / "pictures").string();
  const Outcome render =
      etendue_says({"render", folder.results(), "--case", other, "--camera", "front", "--output", pictures});
  ASSERT_EQ(render.code, ExitCode::done) << render.err;
  EXPECT_EQ(ScratchFolder::names_in(pictures), (std::vector<std::string>{"front.exr", "front.png"}));
}

TEST(Render, IsRemovedWithTheRunItBelongsTo) {
  const CaseFolder folder(hazy_case());
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  write_text(folder.file(), small_case());
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const std::vector<std::string> names = ScratchFolder::names_in(folder.results());
  EXPECT_EQ(std::count(names.begin(), names.end(), "front.png"), 0);
}

TEST(Render, NamesTheCamerasThereAre) {
  const CaseFolder folder(hazy_case());
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const Outcome outcome = etendue_says({"render", folder.results(), "--camera", "back"});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_EQ(outcome.err, "command line: render: --camera = back: no such camera; use front\n");
}

TEST(Render, NeedsACamera) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const Outcome outcome = etendue_says({"render", folder.results()});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_EQ(outcome.err,
            "command line: render: the case has no [[camera]]; add one and name the case with --case\n");
}

TEST(Render, NeedsAResult) {
  const ScratchFolder folder;
  const Outcome outcome = etendue_says({"render", folder.path().string()});
  EXPECT_EQ(outcome.code, ExitCode::file_error);
  EXPECT_EQ(outcome.err,
            (folder.path() / "summary.json").string() +
                ": holds no case of an earlier run; name the directory of its results, or the case "
                "with --case\n");
}

TEST(Render, RefusesTheResultOfAnotherCase) {
  const CaseFolder folder(hazy_case());
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const Outcome outcome =
      etendue_says({"render", folder.results(), "--set", "walls.floor.radiance=[2, 1, 1]"});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "is a solution of another case ([walls] differ)")) << outcome.err;
}

TEST(Run, RefusesACameraInFlatland) {
  const std::string flat = R"([mesh]
max_volume = 0.1
[[mesh.box]]
region = "air"
min = [0, 0, 0]
max = [1, 1, 1]
[media.air]
[walls.zmin]
specular = 1
[walls.zmax]
specular = 1
[walls."*"]
[directions]
set = "flatland"
order = 8
)";
  const CaseFolder folder(flat + camera);
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(
      has(outcome.err, "case.toml:17: camera[0]: a camera in flatland (not in this version); remove it"))
      << outcome.err;
}

// Channels of errors stand beside the others, whatever the picture; those of directions in a run with
// rotations.
TEST(Run, EstimatesWhatPixelsAreOffBy) {
  const CaseFolder folder(small_case() + camera + "errors = true\n");
  ASSERT_EQ(etendue_says({"run", folder.file(), "--set", "directions.rotations=4"}).code, ExitCode::done);
  const std::filesystem::path picture = std::filesystem::path(folder.results()) / "front.exr";
  for (const std::string channel : {"error.cells.red", "error.directions.blue", "radiance.green"})
    EXPECT_TRUE(has(text_of(picture), channel)) << channel;
  ASSERT_EQ(etendue_says({"render", folder.results()}).code, ExitCode::done);
  EXPECT_TRUE(has(text_of(picture), "error.cells.red"));
  EXPECT_TRUE(has(text_of(picture), "error.directions.red"));
}

TEST(Run, RefusesACameraBesideFormulasOfTheDirection) {
  const CaseFolder folder(small_case() + camera);
  for (const char* change : {"media.smoke.absorption='1+wz'", "media.smoke.emission='1+wz'"}) {
    const Outcome outcome = etendue_says({"run", folder.file(), "--set", change});
    EXPECT_EQ(outcome.code, ExitCode::input_error) << change;
    EXPECT_TRUE(has(outcome.err, "which rays do not see (not in this version); remove it")) << outcome.err;
  }
  const Outcome wall = etendue_says({"run", folder.file(), "--set", "walls.floor.radiance='1+x*wz'"});
  EXPECT_EQ(wall.code, ExitCode::done) << wall.err;
}

TEST(Run, PhotographsLeavesAndRefusesKernels) {
  std::string text = small_case() + camera;
  const std::string matter = "absorption = [0.1, 0.2, 0.3]\nscattering = 1.0\n";
  text.replace(text.find(matter), matter.size(),
               "leaves = { area_density = 1, reflectance = 0.4, transmittance = 0.1 }\n");
  const CaseFolder folder(text);
  const Outcome leaves = etendue_says({"run", folder.file()});
  EXPECT_EQ(leaves.code, ExitCode::done) << leaves.err;
  text.replace(text.find("leaves = "), text.find('\n', text.find("leaves = ")) - text.find("leaves = "),
               "absorption = 1\nkernel = \"0.01*(1 + wx*vx)\"");
  const CaseFolder other(text);
  const Outcome kernel = etendue_says({"run", other.file()});
  EXPECT_EQ(kernel.code, ExitCode::input_error);
  EXPECT_TRUE(
      has(kernel.err, "a camera beside a kernel, which rays do not see (not in this version); remove it"))
      << kernel.err;
}

}  // namespace
}  // namespace etendue::render_test
