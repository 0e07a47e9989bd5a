// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_camera.h"

#include <gtest/gtest.h>

#include "tests/app/case/case_text.h"

namespace etendue::read_camera_test {
namespace {

const std::string camera = cube + "[[camera]]\nname = \"front\"\nposition = [0.5, -1, 0.5]\n";

TEST(ReadCamera, FillsInDefaults) {
  const Case input = case_of(camera + "look_at = [0.5, 0.5, 0.5]\n");
  ASSERT_EQ(input.cameras.size(), 1U);
  const CameraCase& front = input.cameras[0];
  EXPECT_EQ(front.name, "front");
  EXPECT_EQ(front.camera.position, Vec3(0.5, -1, 0.5));
  EXPECT_EQ(front.camera.up, Vec3(0, 0, 1));
  EXPECT_EQ(front.camera.field_of_view, 50);
  EXPECT_FALSE(front.camera.orthographic);
  EXPECT_EQ(front.camera.pixels, (std::array<int, 2>{800, 600}));
  EXPECT_EQ(front.camera.samples, 1);
  EXPECT_EQ(front.camera.shafts, 0);
  EXPECT_EQ(front.camera.shadow_rays, 128);
  EXPECT_FALSE(front.exposure);
  EXPECT_EQ(front.tone, Tone::linear);
  EXPECT_EQ(front.white.kind, White::Kind::equal);
}

TEST(ReadCamera, KnowsWhites) {
  const std::string view = camera + "look_at = [0, 0, 0]\n";
  EXPECT_EQ(case_of(view + "white = \"D65\"\n").cameras[0].white.kind, White::Kind::d65);
  const White lamp = case_of(view + "white = 2700\n").cameras[0].white;
  EXPECT_EQ(lamp.kind, White::Kind::black_body);
  EXPECT_EQ(lamp.kelvin, 2700);
  EXPECT_EQ(faults_of(view + "white = \"D50\"\n"),
            "slab.toml:11: camera[0].white = \"D50\": is not known; use \"equal\", "
            "\"D65\" or "
            "a number from 1000 to 1000000");
  EXPECT_EQ(faults_of(view + "white = 20\n"),
            "slab.toml:11: camera[0].white = 20: out of range; use \"equal\", \"D65\" or a number from 1000 "
            "to 1000000");
}

TEST(ReadCamera, TakesAllThatIsGiven) {
  const Case input = case_of(camera + R"(look_at = [0, 0, 0]
up = [0, 1, 1]
orthographic = 3
pixels = [20, 10]
samples = 9
shaft_points = 2
shadow_rays = 16
gather_rays = 64
exposure = 0.5
tone = "reinhard"
)");
  const CameraCase& front = input.cameras[0];
  EXPECT_EQ(front.camera.orthographic, 3);
  EXPECT_EQ(front.camera.pixels, (std::array<int, 2>{20, 10}));
  EXPECT_EQ(front.camera.samples, 9);
  EXPECT_EQ(front.camera.shafts, 2);
  EXPECT_EQ(front.camera.shadow_rays, 16);
  EXPECT_EQ(front.camera.gather, 64);
  EXPECT_EQ(front.exposure, 0.5);
  EXPECT_EQ(front.tone, Tone::reinhard);
}

TEST(ReadCamera, RefusesAViewWithoutADirection) {
  EXPECT_EQ(
      faults_of(camera + "look_at = [0.5, -1, 0.5]\n"),
      "slab.toml:10: camera[0].look_at = [0.5, -1, 0.5]: is where the camera stands; use another point");
  EXPECT_EQ(faults_of(camera + "look_at = [0.5, -1, 0]\n"),
            "slab.toml:7: camera[0].up = [0, 0, 1]: points along the view (nothing says what is up in the "
            "picture); use a vector across it");
  EXPECT_EQ(faults_of(camera + "look_at = [0, 0, 0]\nup = [0, 0, 0]\n"),
            "slab.toml:11: camera[0].up = [0, 0, 0]: has no direction; use a vector that is not zero");
}

TEST(ReadCamera, RefusesTwoLenses) {
  EXPECT_EQ(faults_of(camera + "look_at = [0, 0, 0]\nfield_of_view = 30\northographic = 1\n"),
            "slab.toml:12: camera[0].orthographic = 1: beside field_of_view; use one of them");
}

TEST(ReadCamera, TakesProjections) {
  const std::string aim = camera + "look_at = [0, 0, 0]\n";
  const auto read = [&](const std::string& keys) { return case_of(aim + keys).cameras.at(0).camera; };
  EXPECT_EQ(read("").projection, Projection::perspective);
  EXPECT_EQ(read("projection = \"fisheye\"\n").projection, Projection::fisheye);
  EXPECT_EQ(read("projection = \"fisheye\"\n").field_of_view, 180);
  EXPECT_EQ(read("projection = \"fisheye-equisolid\"\nfield_of_view = 120\n").projection,
            Projection::fisheye_equisolid);
  EXPECT_EQ(read("projection = \"orthographic\"\northographic = 2\n").orthographic, 2);
  EXPECT_EQ(faults_of(aim + "projection = \"orthographic\"\n"),
            "slab.toml:11: camera[0].projection = \"orthographic\": needs the height that the picture shows; "
            "add orthographic = height");
  EXPECT_EQ(faults_of(aim + "projection = \"fisheye\"\northographic = 2\n"),
            "slab.toml:12: camera[0].orthographic = 2: beside projection = \"fisheye\"; use one of them");
  EXPECT_EQ(faults_of(aim + "field_of_view = 180\n"),
            "slab.toml:11: camera[0].field_of_view = 180: a perspective picture shows less than 180 degrees; "
            "use less, or projection = \"fisheye\"");
}

TEST(ReadCamera, TakesFalseColors) {
  const std::string aim = camera + "look_at = [0, 0, 0]\n";
  EXPECT_FALSE(case_of(aim).cameras.at(0).false_color);
  const FalseColor scale = case_of(aim + "false_color = { quantity = \"radiance\", max = 100, log = true }\n")
                               .cameras.at(0)
                               .false_color.value();
  EXPECT_EQ(scale.quantity, FalseColorQuantity::radiance);
  EXPECT_EQ(scale.most, 100);
  EXPECT_FALSE(scale.least);
  EXPECT_TRUE(scale.logarithmic);
  EXPECT_EQ(faults_of(aim + "false_color = { quantity = \"radiance\", min = 5, max = 2 }\n"),
            "slab.toml:11: camera[0].false_color.min = 5: is not below max; use a smaller number");
  EXPECT_EQ(faults_of(aim + "false_color = { quantity = \"radiance\", min = 0, log = true }\n"),
            "slab.toml:11: camera[0].false_color.min = 0: a logarithmic scale does not reach 0; use a number "
            "above 0");
  EXPECT_EQ(
      faults_of(aim + "false_color = { max = 10 }\n"),
      "slab.toml:7: camera[0]: false_color: luminance needs bands that the eye sees; use bands.edges, or "
      "bands called red, green and blue, or quantity = \"radiance\"");
}

TEST(ReadCamera, RefusesPixelsThatAreNotTwoWholeNumbers) {
  EXPECT_EQ(faults_of(camera + "look_at = [0, 0, 0]\npixels = [800]\n"),
            "slab.toml:11: camera[0].pixels = [800]: must be two whole numbers; use [across, down]");
  EXPECT_EQ(faults_of(camera + "look_at = [0, 0, 0]\npixels = [80.5, 60]\n"),
            "slab.toml:11: camera[0].pixels = [80.5, 60]: must be two whole numbers; use [across, down]");
}

TEST(ReadCamera, RefusesSamplesThatFillNoSquare) {
  EXPECT_EQ(faults_of(camera + "look_at = [0, 0, 0]\nsamples = 3\n"),
            "slab.toml:11: camera[0].samples = 3: is not known (did you mean \"36\"?); use 1, 4, 9, 16, 25, "
            "36, 49 or 64");
}

TEST(ReadCamera, RefusesATone) {
  EXPECT_EQ(faults_of(camera + "look_at = [0, 0, 0]\ntone = \"reinhart\"\n"),
            "slab.toml:11: camera[0].tone = \"reinhart\": is not known (did you mean \"reinhard\"?); use "
            "\"linear\", \"reinhard\" or \"aces\"");
}

TEST(ReadCamera, NeedsNamesThatNameFilesAndDiffer) {
  EXPECT_EQ(faults_of(cube + "[[camera]]\nname = \"a/b\"\nposition = [0, 0, 0]\nlook_at = [1, 0, 0]\n"),
            "slab.toml:8: camera[0].name = \"a/b\": cannot name a file; use letters, digits, - and _");
  const std::string one = "[[camera]]\nname = \"a\"\nposition = [0, 0, 0]\nlook_at = [1, 0, 0]\n";
  EXPECT_EQ(faults_of(cube + one + one),
            "slab.toml:12: camera[1].name = \"a\": another camera has this name; give each its own");
}

TEST(ReadCamera, NeedsAPlaceAndAnAim) {
  EXPECT_EQ(faults_of(cube + "[[camera]]\nname = \"a\"\n"),
            "slab.toml:7: camera[0].position: missing; a list of three numbers\n"
            "slab.toml:7: camera[0].look_at: missing; a list of three numbers");
}

}  // namespace
}  // namespace etendue::read_camera_test
