// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_sensor.h"

#include <algorithm>
#include <map>
#include <numbers>

#include "app/case/read/file_name.h"
#include "app/case/read/read_camera.h"
#include "solver/uncollided/closed_form/outline.h"

namespace etendue {
namespace {

const std::map<std::string, SensorKind> kinds = {{"irradiance", SensorKind::irradiance},
                                                 {"exitance", SensorKind::exitance},
                                                 {"radiosity", SensorKind::radiosity},
                                                 {"fluence", SensorKind::fluence},
                                                 {"radiance", SensorKind::radiance},
                                                 {"cone", SensorKind::cone},
                                                 {"grid", SensorKind::grid},
                                                 {"flux", SensorKind::flux},
                                                 {"intensity", SensorKind::intensity},
                                                 {"region", SensorKind::region},
                                                 {"glare", SensorKind::glare}};

/// The keys that a kind of sensor takes, beside name, kind and rays.
const std::map<SensorKind, std::vector<std::string>> keys_of = {
    {SensorKind::irradiance, {"position", "normal", "daylight_factor"}},
    {SensorKind::exitance, {"position", "normal"}},
    {SensorKind::radiosity, {"position", "normal"}},
    {SensorKind::fluence, {"position"}},
    {SensorKind::radiance, {"position", "direction"}},
    {SensorKind::cone, {"position", "direction", "angle"}},
    {SensorKind::grid, {"position", "along", "across", "normal", "parts", "daylight_factor"}},
    {SensorKind::flux, {"polygon", "wall", "region", "beyond", "parts", "direction", "angle"}},
    {SensorKind::intensity, {"wall", "parts"}},
    {SensorKind::region, {"region", "direction", "angle"}},
    {SensorKind::glare, {"position", "direction", "up", "parts", "sources", "threshold"}}};

/// Of intensities: every 15 degrees around, every 5 from the axis.
constexpr int default_azimuths = 24, default_polar_angles = 19;

/// Pixels of half a degree across the view of an observer.
constexpr int default_view = 360;

/// Corners are in one plane to this part of the polygon's size.
constexpr double flat = 1e-6;

bool takes(SensorKind kind, const std::string& key) { return std::ranges::count(keys_of.at(kind), key) > 0; }

void refuse_other_keys(Section& section, const std::string& name, SensorKind kind) {
  for (const char* key : {"position", "normal", "direction", "angle", "along", "across", "parts", "polygon",
                          "wall", "region", "beyond", "daylight_factor", "up", "sources", "threshold"})
    if (!takes(kind, key)) section.unused(key, "a sensor of kind \"" + name + "\" does not take it");
}

/// A vector of any length; zero where it is absent or has none, which is a fault.
Vec3 unit_vector(Section& section, const std::string& key, const std::string& what) {
  if (!section.has(key)) {
    section.fault(key, "missing; use " + what);
    return Vec3::Zero();
  }
  const auto given = section.point_if(key);
  if (!given) return Vec3::Zero();
  if (given->norm() == 0) section.fault(key, "has no direction; use a vector that is not zero");
  return given->normalized();
}

void read_position(Section& section, Sensor& sensor) {
  if (!section.has("position")) return section.fault("position", "missing; use a point of the domain");
  sensor.position = section.point_if("position").value_or(Vec3::Zero());
}

void read_sides(Section& section, Sensor& sensor) {
  const std::array<std::string, 2> names = {"along", "across"};
  for (std::size_t i = 0; i < 2; ++i) {
    if (!section.has(names[i])) section.fault(names[i], "missing; use the side of the grid, as a vector");
    sensor.sides[i] = section.point_if(names[i]).value_or(Vec3::Zero());
  }
  const Vec3 normal = sensor.sides[0].cross(sensor.sides[1]);
  if (normal.norm() <= flat * sensor.sides[0].norm() * sensor.sides[1].norm())
    return section.fault("across", "points along the other side; use a vector across it");
  sensor.direction = section.has("normal") ? unit_vector(section, "normal", "a vector") : normal.normalized();
}

void read_parts(Section& section, Sensor& sensor) {
  sensor.count = {4, 4};
  if (sensor.kind == SensorKind::flux && section.has("wall")) sensor.count = {1, 1};
  if (sensor.kind == SensorKind::intensity) sensor.count = {default_azimuths, default_polar_angles};
  if (sensor.kind == SensorKind::glare) sensor.count = {default_view, default_view};
  const TomlNode* given = section.find("parts");
  if (given == nullptr) return;
  const TomlArray& parts = given->array();
  const bool whole = std::ranges::all_of(
      parts, [](const auto& item) { return std::holds_alternative<std::int64_t>(item->value); });
  const std::size_t wanted = sensor.kind == SensorKind::flux || sensor.kind == SensorKind::glare ? 1 : 2;
  if (!whole || parts.size() != wanted)
    return section.fault("parts", wanted == 2 ? "must be two whole numbers; use a list of two"
                                              : "must be one whole number; use a list of one");
  for (std::size_t i = 0; i < 2; ++i) sensor.count[i] = static_cast<int>(parts[i % wanted]->number());
}

void read_cone_angle(Section& section, Sensor& sensor) {
  if (!section.has("angle"))
    return section.fault("angle", "missing; use the half angle of the cone in degrees");
  sensor.half_angle = section.number("angle") * std::numbers::pi / 180;
}

/// The cone that light comes from, where there is one.
void read_optional_cone(Section& section, Sensor& sensor) {
  if (section.has("angle") != section.has("direction"))
    section.fault(section.has("angle") ? "direction" : "angle",
                  "missing; use direction and angle of a cone, or neither");
  if (!section.has("angle") || !section.has("direction")) return;
  read_cone_angle(section, sensor);
  sensor.direction = unit_vector(section, "direction", "where the light comes from");
}

/// Whether two sides of a flat polygon cross, or a corner lies on another side.
bool meets_itself(const std::vector<Vec3>& polygon, const Vec3& normal, double tolerance) {
  const std::size_t count = polygon.size();
  const auto corner = [&](std::size_t i) -> const Vec3& { return polygon[i % count]; };
  const auto parted = [&](std::size_t side, std::size_t other) {
    const Vec3 along = corner(side + 1) - corner(side);
    return normal.dot(along.cross(corner(other) - corner(side))) *
               normal.dot(along.cross(corner(other + 1) - corner(side))) <
           0;
  };
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 2; j < i + count; ++j) {
      if (distance_to_side(corner(j), corner(i), corner(i + 1)) <= tolerance) return true;
      if (j + 1 < i + count && parted(i, j) && parted(j, i)) return true;
    }
  return false;
}

void check_polygon(Section& section, const std::vector<Vec3>& polygon) {
  if (polygon.size() < 3) return section.fault("polygon", "has fewer than three corners; use three or more");
  const Vec3 normal = polygon_normal(polygon);
  double size = 0;
  for (const Vec3& corner : polygon) size = std::max(size, (corner - polygon[0]).norm());
  if (!(normal.norm() > 0.5)) return section.fault("polygon", "has no area; use corners that span one");
  for (const Vec3& corner : polygon)
    if (std::abs(normal.dot(corner - polygon[0])) > flat * size)
      return section.fault("polygon", "is not flat; use corners in one plane");
  if (meets_itself(polygon, normal, flat * size))
    section.fault("polygon",
                  "has sides that meet elsewhere than at their common corner; use several sensors");
}

/// What a flux goes through: a polygon, a wall, or the surface of a region.
void read_surface(Section& section, SensorCase& result) {
  const std::vector<std::string> ways = {"polygon", "wall", "region"};
  const auto given = std::ranges::count_if(ways, [&](const std::string& key) { return section.has(key); });
  if (given == 0)
    return section.fault("polygon", "missing; use a list of corners, or the name of a wall or region");
  result.wall = section.text_if("wall").value_or("");
  result.region = section.text_if("region").value_or("");
  result.beyond = section.text_if("beyond").value_or("");
  read_optional_cone(section, result.sensor);
  const TomlNode* corners = section.find("polygon");
  if (given > 1)
    return section.fault(
        section.has("region") ? "region" : "wall",
        "beside another (a flux goes through one thing); use one of polygon, wall and region");
  if (corners != nullptr) {
    for (const auto& corner : corners->array()) result.sensor.polygon.push_back(to_vec3(*corner));
    check_polygon(section, result.sensor.polygon);
  }
  if (!section.has("region") && section.has("beyond"))
    section.unused("beyond", "only the surface of a region has another side");
  if (section.has("region") && section.has("parts"))
    section.unused("parts", "through the surface of a region the faces of the mesh are summed up");
}

void read_glare(Section& section, Sensor& sensor) {
  sensor.up = to_vec3(section.value("up"));
  if (sensor.direction.cross(sensor.up).norm() <= smallest_sine_of_up * sensor.up.norm())
    section.fault("up", "points along the view, or nowhere; use a vector across the direction");
  sensor.glare_threshold = section.number("threshold");
  if (section.text("sources") == "lights") sensor.glare_sources = GlareSources::lights;
}

SensorCase read_sensor(Section& section) {
  SensorCase result;
  result.origin = section.origin();
  result.name = file_name(section, "name");
  Sensor& sensor = result.sensor;
  const std::string kind = section.text("kind");
  sensor.rays = section.integer("rays");
  const auto known = kinds.find(kind);
  if (known == kinds.end()) return result;
  sensor.kind = known->second;
  refuse_other_keys(section, kind, sensor.kind);
  if (takes(sensor.kind, "position")) read_position(section, sensor);
  if (takes(sensor.kind, "parts")) read_parts(section, sensor);
  if (takes(sensor.kind, "daylight_factor") && section.boolean("daylight_factor"))
    result.daylight_factor = section.origin("daylight_factor");
  if (sensor.kind == SensorKind::exitance || sensor.kind == SensorKind::radiosity)
    sensor.direction = unit_vector(section, "normal", "a vector into the domain");
  if (sensor.kind == SensorKind::irradiance)
    sensor.direction = unit_vector(section, "normal", "a vector to the side where light is measured");
  if (sensor.kind == SensorKind::radiance || sensor.kind == SensorKind::cone ||
      sensor.kind == SensorKind::glare)
    sensor.direction = unit_vector(section, "direction", "a vector to where the sensor looks");
  if (sensor.kind == SensorKind::cone) read_cone_angle(section, sensor);
  if (sensor.kind == SensorKind::glare) read_glare(section, sensor);
  if (sensor.kind == SensorKind::grid) read_sides(section, sensor);
  if (sensor.kind == SensorKind::flux) read_surface(section, result);
  if (sensor.kind == SensorKind::region) {
    result.region = section.text_if("region").value_or("");
    if (!section.has("region")) section.fault("region", "missing; use the name of a region");
    read_optional_cone(section, sensor);
  }
  if (sensor.kind == SensorKind::intensity) {
    result.wall = section.text_if("wall").value_or("");
    if (!section.has("wall")) section.fault("wall", "missing; use the name of a wall that light leaves by");
  }
  return result;
}

}  // namespace

std::vector<SensorCase> read_sensors(Section& top) {
  std::vector<SensorCase> sensors;
  for (Section& section : top.list("sensor")) {
    SensorCase sensor = read_sensor(section);
    if (!sensor.name.empty() && std::ranges::count(sensors, sensor.name, &SensorCase::name) > 0)
      section.fault("name", "another sensor has this name; give each its own");
    sensors.push_back(std::move(sensor));
  }
  return sensors;
}

}  // namespace etendue
