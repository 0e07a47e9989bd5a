// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "app/case/build/build.h"
#include "app/case/keys/case_tables.h"
#include "app/case/keys/resolve_path.h"
#include "base/text/edit_distance.h"
#include "solver/angular/sets/direction_set.h"

namespace etendue {
namespace {

constexpr std::string_view radiance_prefix = "radiance:";

std::vector<Vec3> line_points(Section line) {
  const auto from = line.point_if("from"), to = line.point_if("to");
  const auto count = line.number_if("count");
  if (!from || !to || !count) return {};
  std::vector<Vec3> points;
  const int last = static_cast<int>(*count) - 1;
  for (int i = 0; i <= last; ++i) points.push_back(*from + (*to - *from) * (static_cast<double>(i) / last));
  return points;
}

void read_points(Section& section, Probe& probe) {
  if (section.has("points") && section.has("line"))
    section.fault("given by points and by a line; use one of points or line");
  if (!section.has("points") && !section.has("line")) section.fault("no points; use points or line");
  if (const TomlNode* points = section.find("points"))
    for (const auto& point : points->array()) probe.points.push_back(to_vec3(*point));
  if (section.has("line")) {
    const std::vector<Vec3> points = line_points(section.section("line"));
    probe.points.insert(probe.points.end(), points.begin(), points.end());
  }
}

Probe read_probe(Section& section) {
  Probe probe;
  probe.origin = section.origin();
  probe.name = section.text_if("name").value_or("");
  read_points(section, probe);
  probe.normal = section.point_if("normal");
  if (!probe.normal) return probe;
  if (probe.normal->norm() > 0)
    probe.normal->normalize();
  else
    section.fault("normal", "has no direction; use a vector that is not zero");
  return probe;
}

// The ordinate of "radiance:K"; empty where K is no number.
std::optional<int> ordinate_of(std::string_view field) {
  const std::string_view digits = field.substr(radiance_prefix.size());
  int ordinate = -1;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), ordinate);
  const bool whole = error == std::errc() && end == digits.data() + digits.size();
  return whole && ordinate >= 0 ? std::optional(ordinate) : std::nullopt;
}

void read_field(TomlNode& node, OutputCase& output, Faults& faults) {
  static const std::vector<std::string> known = {"fluence", "net_flux", "media", "direction_error"};
  const std::string accepted =
      "use \"fluence\", \"net_flux\", \"media\", \"direction_error\" or \"radiance:K\" for the ordinate K";
  const std::string& field = node.text();
  if (std::ranges::count(output.fields, field) > 0) return report(node, "named twice; remove one", faults);
  output.fields.push_back(field);
  if (std::ranges::count(known, field) > 0) return;
  if (field.starts_with(radiance_prefix)) {
    const auto ordinate = ordinate_of(field);
    if (!ordinate) return report(node, "no ordinate after the colon; " + accepted, faults);
    if (std::ranges::count(output.radiance_ordinates, *ordinate) > 0)
      return report(node, fmt::format("names the ordinate {} twice; remove one", *ordinate), faults);
    return output.radiance_ordinates.push_back(*ordinate);
  }
  const std::string meant = closest_name(field, known);
  report(node, "is not known" + (meant.empty() ? "" : " (did you mean \"" + meant + "\"?)") + "; " + accepted,
         faults);
}

std::string case_name(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  return stem == "case" ? std::filesystem::absolute(file).parent_path().filename().string() : stem;
}

}  // namespace

std::vector<Probe> read_probes(Section& top) {
  std::vector<Probe> probes;
  for (Section& section : top.list("probe")) {
    Probe probe = read_probe(section);
    const bool taken = std::ranges::count(probes, probe.name, &Probe::name) > 0;
    if (taken && !probe.name.empty()) section.fault("name", "another probe has this name; give each its own");
    probes.push_back(std::move(probe));
  }
  return probes;
}

OutputCase read_output(Section section, const std::filesystem::path& case_file) {
  OutputCase output;
  output.origin = section.origin();
  if (const TomlNode* directory = section.find("directory"))
    output.directory = resolve_path(*directory, case_file.parent_path());
  else
    output.directory = case_name(case_file);
  section.resolve("directory", output.directory.string());
  output_table().read(section, output);
  output.fields.clear();
  const bool given = section.has("fields");
  section.value("fields");
  if (TomlNode* fields = section.find("fields"); fields && !(given && fields->faulty))
    for (auto& field : fields->array()) read_field(*field, output, section.faults());
  return output;
}

void check_rotations(Section directions, Section output, const Case& result) {
  const bool wanted = std::ranges::count(result.output.fields, "direction_error") > 0;
  if (result.rotations == 1) {
    if (wanted)
      output.fault("fields",
                   "\"direction_error\" is the spread over rotated sets; use directions.rotations, at "
                   "least 4");
    return;
  }
  if (!result.output.radiance_ordinates.empty())
    directions.fault("rotations",
                     "there is no radiance of one ordinate in a mean over rotated sets; use 1, or "
                     "no output field \"radiance:K\"");
  if (result.exact) directions.fault("rotations", "[exact] makes its source for one set; use 1");
}

void check_first_collided(Section directions, const Case& result) {
  if (!result.first_collided) return;
  if (!result.output.radiance_ordinates.empty())
    directions.fault("first_collided",
                     "light on a set of its own has no radiance along the ordinates of the other; use "
                     "no output field \"radiance:K\", or no first_collided");
  if (result.exact)
    directions.fault("first_collided", "[exact] leaves no light along rays; use no first_collided");
}

void check_ordinates(Section output, const Case& result) {
  if (result.output.radiance_ordinates.empty()) return;
  const int count = build_directions(result).count();
  for (auto& field : output.node().find("fields")->array()) {
    const std::string& text = field->text();
    if (field->faulty || !text.starts_with(radiance_prefix) || *ordinate_of(text) < count) continue;
    report(*field,
           fmt::format("no such ordinate ({} of order {} has {}); use 0 to {}", result.direction_set,
                       result.direction_order, count, count - 1),
           output.faults());
  }
}

}  // namespace etendue
