// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_camera.h"

#include "app/case/keys/case_tables.h"
#include "app/case/read/file_name.h"
#include "app/case/read/read_false_color.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

void check_view(Section& section, const Camera& camera) {
  if (!section.find("position") || !section.find("look_at")) return;
  const Vec3 ahead = camera.look_at - camera.position;
  if (ahead.norm() == 0) return section.fault("look_at", "is where the camera stands; use another point");
  if (camera.up.norm() == 0) return section.fault("up", "has no direction; use a vector that is not zero");
  if (ahead.cross(camera.up).norm() < smallest_sine_of_up * ahead.norm() * camera.up.norm())
    section.fault("up",
                  "points along the view (nothing says what is up in the picture); use a vector across it");
}

/// The name of the projection, which follows from the other keys where it is not given.
std::string projection_of(Section& section) {
  const bool has_height = section.has("orthographic");
  const std::string name =
      section.text_if("projection").value_or(has_height ? "orthographic" : "perspective");
  if (name == "orthographic" && !has_height)
    section.fault("projection", "needs the height that the picture shows; add orthographic = height");
  if (name != "orthographic" && has_height) {
    section.fault("orthographic", "beside projection = \"" + name + "\"; use one of them");
    section.find("orthographic");
  }
  return name;
}

void read_lens(Section& section, Camera& camera) {
  const std::string name = projection_of(section);
  if (name == "orthographic") {
    if (section.has("field_of_view")) section.fault("orthographic", "beside field_of_view; use one of them");
    section.find("field_of_view");
    camera.orthographic = section.number_if("orthographic");
    return;
  }
  if (name == "fisheye") camera.projection = Projection::fisheye;
  if (name == "fisheye-equisolid") camera.projection = Projection::fisheye_equisolid;
  const bool is_fisheye = camera.projection != Projection::perspective;
  camera.field_of_view = section.number_if("field_of_view").value_or(is_fisheye ? 180 : 50);
  if (!is_fisheye && camera.field_of_view >= 180)
    section.fault("field_of_view",
                  "a perspective picture shows less than 180 degrees; use less, or "
                  "projection = \"fisheye\"");
}

void check_pixels(Section& section) {
  const TomlArray& pixels = section.value("pixels").array();
  const bool whole = std::ranges::all_of(
      pixels, [](const auto& item) { return std::holds_alternative<std::int64_t>(item->value); });
  if (pixels.size() != 2 || !whole) section.fault("pixels", "must be two whole numbers; use [across, down]");
}

CameraCase read_camera(Section& section) {
  CameraCase result;
  result.origin = section.origin();
  result.name = file_name(section, "name");
  camera_table().read(section, result);
  check_view(section, result.camera);
  read_lens(section, result.camera);
  check_pixels(section);
  if (section.has("false_color")) result.false_color = read_false_color(section.section("false_color"));
  return result;
}

}  // namespace

std::vector<CameraCase> read_cameras(Section& top) {
  std::vector<CameraCase> cameras;
  for (Section& section : top.list("camera")) {
    CameraCase camera = read_camera(section);
    if (!camera.name.empty() && std::ranges::count(cameras, camera.name, &CameraCase::name) > 0)
      section.fault("name", "another camera has this name; give each its own");
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

}  // namespace etendue
