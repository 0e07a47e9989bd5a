// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include "app/case/build/build.h"
#include "app/case/build/daylight.h"
#include "app/case/build/mesh_names.h"
#include "app/case/case.h"
#include "app/case/keys/case_tables.h"
#include "app/case/keys/key_check.h"
#include "app/case/keys/override.h"
#include "app/case/keys/section.h"
#include "app/case/read/eye_check.h"
#include "app/case/read/first_collided_default.h"
#include "app/case/read/lights/read_light.h"
#include "app/case/read/materials/check_heat.h"
#include "app/case/read/materials/check_heat_in_time.h"
#include "app/case/read/materials/read_matter.h"
#include "app/case/read/read_accuracy.h"
#include "app/case/read/read_camera.h"
#include "app/case/read/read_exact.h"
#include "app/case/read/read_mesh.h"
#include "app/case/read/read_report.h"
#include "app/case/read/read_sensor.h"
#include "app/case/read/read_solve.h"
#include "app/case/read/read_time.h"
#include "app/case/read/seen_lights_check.h"
#include "app/case/temperatures.h"
#include "app/case/toml/render_toml.h"
#include "app/case/toml/toml_document.h"
#include "app/case/values/band_values.h"
#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

/// 0 where the directions were refused already.
int ordinate_count(const Case& input) {
  try {
    return build_directions(input).count();
  } catch (const InputError&) {
    return 0;
  }
}

Case read_tables(Section& top, const std::filesystem::path& file) {
  Case result;
  result.file = file;
  result.title = top.text("title");
  Section units = top.section("units");
  unit_table().read(units, result.units);
  result.mesh = read_mesh_section(top.section("mesh"), file.parent_path());
  Section bands = top.section("bands");
  result.molar_ratio = read_place_value(bands, "molar_ratio");
  result.bands = read_bands(std::move(bands), file.parent_path(), result.molar_ratio);
  if (result.molar_ratio && is_number(result.molar_ratio->values.front())) result.molar_ratio.reset();
  read_directions(top.section("directions"), result);
  for (auto& [name, medium] : top.section("media").named())
    if (const auto index = medium.number_if("refractive_index")) result.bands.refractive_index = *index;
  result.media =
      read_media(top.section("media"), {result.bands, result.molar_ratio, result.units, result.angular_space,
                                        file.parent_path(), [&result] { return ordinate_count(result); }});
  result.walls =
      read_walls(top.section("walls"),
                 {result.bands, result.molar_ratio, result.units, result.angular_space, file.parent_path(),
                  std::ranges::any_of(result.media, [](const auto& entry) {
                    return entry.second.conductivity.has_value() || entry.second.heat_capacity.has_value();
                  })});
  result.lights = read_lights(top, {result.bands, result.units, file.parent_path()});
  for (const auto& [name, wall] : result.walls)
    if (wall.beam) result.lights.push_back(*wall.beam);
  read_space(top.section("space"), result.solve);
  const bool has_tolerance = top.section("solve").has("tolerance");
  read_solve(top.section("solve"), file.parent_path(), result);
  read_photon_map(top.section("photon_map"), result);
  read_radiosity(top.section("radiosity"), top.section("solve").text("method") == "radiosity", result);
  result.probes = read_probes(top);
  result.cameras = read_cameras(top);
  result.sensors = read_sensors(top);
  if (top.has("exact")) read_exact(top.section("exact"), result);
  if (top.has("accuracy")) read_accuracy(top.section("accuracy"), !has_tolerance, result);
  if (top.has("time")) read_time(top.section("time"), file.parent_path(), result);
  result.output = read_output(top.section("output"), file);
  result.solve.keep_ordinates = result.output.radiance_ordinates;
  return result;
}

/// Where media and opaque walls have temperatures, walls refract by the index of the media.
void check_refracting_walls(const Case& input, Faults& faults) {
  const bool is_hot =
      std::ranges::any_of(input.media,
                          [](const auto& entry) {
                            return entry.second.temperature.has_value() || entry.second.follows_from_heat();
                          }) ||
      std::ranges::any_of(input.walls, [](const auto& entry) {
        const WallCase& wall = entry.second;
        return wall.refractive_index == 1 && (wall.temperature || wall.heat_flux || wall.convection);
      });
  for (const auto& [name, wall] : input.walls)
    if (is_hot && wall.refractive_index != 1 && wall.refractive_index != input.bands.refractive_index)
      faults.push_back(fault_at(
          wall.origin, "",
          fmt::format("has the refractive_index {:g} in a case with temperatures whose media have {:g}; give "
                      "them the same (what is behind the wall has 1)",
                      wall.refractive_index, input.bands.refractive_index)));
}

/// A refractive index of a medium is for the speed of light there alone.
void check_slow_media(const Case& input, Faults& faults) {
  for (const auto& [name, medium] : input.media)
    if (!input.time && !has_temperatures(input) && medium.refractive_index != 1)
      faults.push_back(fault_at(
          medium.origin, "",
          "has a refractive_index in a case without [time] and temperatures; that of a wall refracts"));
}

/// Without light in time nothing has a course.
void check_courses(const Case& input, Faults& faults) {
  if (input.time) return;
  for (const InTime& own : own_courses(input))
    faults.push_back(fault_at(own.origin, "\"" + own.text + "\"", "is of no use in a case without [time]"));
}

/// Adds the files of the mesh that are not there to other faults, unless those are of the mesh too.
void check_mesh_files(const MeshCase& mesh, Faults& faults) {
  const auto is_of_mesh = [](const Fault& fault) { return fault.text.starts_with("mesh"); };
  if (faults.empty() || std::ranges::any_of(faults, is_of_mesh)) return;
  const auto check = [&](const InputFile& file) {
    if (!std::filesystem::exists(file.path))
      faults.push_back(fault_at(file.origin, "\"" + file.path.filename().string() + "\"",
                                "is no file; name one that is there"));
  };
  if (mesh.file) check(*mesh.file);
  if (mesh.surface) check(*mesh.surface);
  if (mesh.labels) check(mesh.labels->file);
}

Case read_root(TomlNode root, const std::filesystem::path& file, const Overrides& overrides) {
  Faults faults;
  std::vector<std::string> deprecations;
  // Names of the file first: an override by either name replaces its value.
  rename_former_keys(root, deprecations, faults);
  for (const std::string& assignment : overrides) apply_override(root, assignment, faults);
  rename_former_keys(root, deprecations, faults);
  check_keys(root, faults);
  Section top(root, "", faults);
  Case result = read_tables(top, file);
  // Only a sound direction set can be counted, and only sound primitives have names.
  if (faults.empty()) {
    check_ordinates(top.section("output"), result);
    check_rotations(top.section("directions"), top.section("output"), result);
    check_first_collided(top.section("directions"), result);
    check_possible_names(result, faults);
    check_daylight_factors(result, faults);
    check_refracting_walls(result, faults);
    check_heat(result, faults);
    check_heat_in_time(result, faults);
    check_slow_media(result, faults);
    check_courses(result, faults);
    check_seen_by_eye(result, faults);
    check_sensors_see_lights(result, faults);
  }
  if (faults.empty()) choose_first_collided(top.section("directions").has("first_collided"), result);
  report_unused(root, faults);
  check_mesh_files(result.mesh, faults);
  if (!faults.empty()) throw InputError(std::move(faults));
  result.deprecations = std::move(deprecations);
  result.resolved_toml = render_toml(root);
  return result;
}

}  // namespace

Case read_case(const std::filesystem::path& file, const Overrides& overrides) {
  return read_root(read_toml(file), file, overrides);
}

Case read_case_text(std::string_view text, const std::filesystem::path& file, const Overrides& overrides) {
  return read_root(parse_toml(text, file.string()), file, overrides);
}

}  // namespace etendue
