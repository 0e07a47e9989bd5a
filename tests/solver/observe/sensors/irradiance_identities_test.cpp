// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/uncollided/lights/light_irradiance.h"
#include "tests/solver/observe/sensors/block_mesh.h"
#include "tests/solver/observe/sensors/reference_rows.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::irradiance_identities_test {
namespace {

using std::numbers::pi;
using test::reference_rows;
using test::ReferenceRow;

/// What a meter may be off by, absolute: irradiances of the references are of the order of 1.
constexpr double allowed = 1e-6;

/// A regular polygon about an axis along z with the area of a disc, shining down with radiance 1.
SurfaceLight disc(const Vec3& centre, double radius) {
  constexpr int sides = 64;  // as many as that of a case file has
  const double step = 2 * pi / sides, corner = radius * std::sqrt(step / std::sin(step));
  SurfaceLight light{{}, {1}};
  const auto rim = [&](int i) {
    return Vec3(centre + corner * Vec3(std::cos(i * step), std::sin(i * step), 0));
  };
  for (int i = 0; i < sides; ++i)
    for (const Vec3& point : {centre, rim(i + 1), rim(i)}) light.triangles.push_back(point);
  return light;
}

SurfaceLight rectangle(double x0, double x1, double y0, double y1, double height) {
  const Vec3 a(x0, y0, height), b(x1, y0, height), c(x1, y1, height), d(x0, y1, height);
  return {{a, c, b, a, d, c}, {1}};
}

/// An empty, black domain in which walls called "sky" have radiance 1 and lights hang.
class Scene {
 public:
  Scene(TetrahedralMesh mesh, std::vector<Light> lights)
      : mesh_(std::move(mesh)),
        problem_(mesh_, {}, {uniform_medium(1, 0, 0, 0)}, walls(mesh_), AngularSpace::sphere,
                 std::move(lights)),
        setup_(problem_) {}

  UncollidedAtPoint at(const Vec3& point, const Vec3& normal) const {
    return LightIrradiance(setup_).at({CellLocator(mesh_).find(point).front().cell, point},
                                      normal.normalized());
  }

 private:
  static std::vector<Wall> walls(const TetrahedralMesh& mesh) {
    std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
    for (std::size_t w = 0; w < walls.size(); ++w) {
      walls[w].name = mesh.wall_names()[w];
      if (walls[w].name != "sky") continue;
      walls[w].radiance = {1};
      walls[w].uncollided = Uncollided::yes;
    }
    return walls;
  }

  TetrahedralMesh mesh_;
  Problem problem_;
  LightSetup setup_;
};

using Lines = std::array<std::vector<double>, 3>;

/// A large dark box over the plane z = 0 with one light in it.
Scene dark(std::variant<PointLight, BeamLight, SurfaceLight> light) {
  return {block_mesh(Lines{{{-9, 9}, {-9, 9}, {0, 9}}}, [](const Vec3&, const Vec3&) { return "black"; }),
          {{"light", std::move(light), {}}}};
}

Scene open_sky() {
  return {block_mesh(Lines{{{-2, 3}, {-4, 1}, {0, 2}}},
                     [](const Vec3&, const Vec3& out) { return out.z() < -0.5 ? "floor" : "sky"; }),
          {}};
}

Scene well(double a, double b, double depth) {
  return {block_mesh(Lines{{{0, a}, {0, b}, {0, depth}}},
                     [](const Vec3&, const Vec3& out) { return out.z() > 0.5 ? "sky" : "black"; }),
          {}};
}

/// A sphere is seen as its outline: the circle in which the lines of sight touch it.
SurfaceLight outline(double radius, double distance) {
  const double share = radius / distance;
  return disc({0, 0, distance * (1 - share * share)}, radius * std::sqrt(1 - share * share));
}

double irradiance_of(const ReferenceRow& row) {
  const std::vector<double>& p = row.parameters;
  const Vec3 up = Vec3::UnitZ(), origin = Vec3::Zero();
  const auto tilted = [](double degrees) {
    return Vec3(std::sin(degrees * pi / 180), 0, std::cos(degrees * pi / 180));
  };
  const auto under = [&](const SurfaceLight& light, const Vec3& at = Vec3::Zero()) {
    return dark(light).at(at, Vec3::UnitZ()).irradiance[0];
  };
  if (row.name == "disc_on_axis" && p[0] == 90) return open_sky().at(origin, up).irradiance[0];
  if (row.name == "disc_on_axis") return under(disc(up, std::tan(p[0] * pi / 180)));
  if (row.name == "disc_off_axis_parallel_plane") return under(disc({0, 0, p[1]}, p[0]), {p[2], 0, 0});
  if (row.name == "sphere_source_facing") return under(outline(p[0], p[1]));
  if (row.name == "rect_source_centred")
    return under(rectangle(-p[0] / 2, p[0] / 2, -p[1] / 2, p[1] / 2, p[2]));
  if (row.name == "rect_source_corner") return under(rectangle(0, p[0], 0, p[1], p[2]));
  if (row.name == "point_source")  // "I=1 W/sr at distance 2, incidence 0 deg"
    return dark(PointLight{{0, 0, p[1]}, {4 * pi * p[0]}, Vec3::UnitZ(), {}, {}})
        .at(origin, tilted(p[2]))
        .irradiance[0];
  if (row.name == "hemisphere_tilted_receiver")  // "uniform upper hemisphere L=1, receiver tilted 30 deg"
    return open_sky().at(origin, tilted(p[1])).irradiance[0];
  if (row.name == "lambert_polygon") return under({{Vec3(-1, -1, 1), Vec3(0, 1, 2), Vec3(1, -1, 1)}, {1}});
  return std::numeric_limits<double>::quiet_NaN();
}

// A uniform hemisphere brings pi L, a disc pi L sin^2(alpha), a rectangle L times its projected solid angle.
// The sky of Moon and Spencer is no light: SensorReader.SeesASkyByFormula has it.
TEST(LightIrradiance, IsThatOfTheClosedForms) {
  int rows = 0;
  for (const ReferenceRow& row : reference_rows("irradiance.csv")) {
    if (row.name == "cos_sky_moon_spencer") continue;
    EXPECT_NEAR(irradiance_of(row), row.values.at(0), allowed)
        << row.name << " " << testing::PrintToString(row.parameters);
    ++rows;
  }
  EXPECT_EQ(rows, 26);
}

/// The sky over a floor with a wall of infinite length on it.
Scene beside_a_wall(double height) {
  return {block_mesh(Lines{{{0, 50}, {-1e4, 1e4}, {0, height, 50}}},
                     [=](const Vec3& centroid, const Vec3& out) {
                       const bool wall = out.x() < -0.5 && centroid.z() < height;
                       return out.z() < -0.5 || wall ? "black" : "sky";
                     }),
          {}};
}

/// 0, 1, 10, ... and their negatives: cells are small where the meter stands.
std::vector<double> to_both_sides(double far) {
  std::vector<double> lines = {0};
  for (double at = 1; at < 2 * far; at *= 10) {
    lines.push_back(at);
    lines.insert(lines.begin(), -at);
  }
  return lines;
}

Scene trench(double width, double depth) {
  return {block_mesh(Lines{{{0, width}, to_both_sides(1e4), {0, depth}}},
                     [](const Vec3&, const Vec3& out) { return out.z() > 0.5 ? "sky" : "black"; }),
          {}};
}

/// Between two planes that meet in the y axis, as a very large prism. Its edge is cut off: what stands there
/// is as black as the planes.
Scene between_planes(double angle) {
  const auto place = [=](const Vec3& p) {
    return Vec3(p.x() * std::cos(p.z() * angle), p.y(), p.x() * std::sin(p.z() * angle));
  };
  const auto name = [=](const Vec3&, const Vec3& out) {
    const Vec3 second(-std::sin(angle), 0, std::cos(angle)),
        apart(std::cos(angle / 2), 0, std::sin(angle / 2));
    return -out.z() > 1 - 1e-9 || out.dot(second) > 1 - 1e-9 || out.dot(apart) < -0.5 ? "black" : "sky";
  };
  std::vector<double> outwards = {0.5};
  for (double at = 2; at < 4e6; at *= 10) outwards.push_back(at);
  return {block_mesh(Lines{{outwards, to_both_sides(1e6), {0, 1}}}, name, place), {}};
}

/// Parts of the sky that are seen, of its irradiance and of the hemisphere.
std::array<double, 2> visibility_of(const ReferenceRow& row) {
  const std::vector<double>& p = row.parameters;
  const auto parts = [](const Scene& scene, const Vec3& at) -> std::array<double, 2> {
    const UncollidedAtPoint light = scene.at(at, Vec3::UnitZ());
    return {light.irradiance[0] / pi, light.fluence[0] / (2 * pi)};
  };
  if (row.name == "cylinder_well_bottom_centre") return parts(dark(disc({0, 0, p[1]}, p[0])), Vec3::Zero());
  if (row.name == "box_well_bottom_centre") return parts(well(p[0], p[1], p[2]), {p[0] / 2, p[1] / 2, 0});
  if (row.name == "box_well_bottom_corner") return parts(well(p[0], p[1], p[2]), Vec3::Zero());
  if (row.name == "floor_point_near_infinite_wall") return parts(beside_a_wall(p[0]), {p[1], 0, 0});
  if (row.name == "infinite_trench_bottom_centre") return parts(trench(p[0], p[1]), {p[0] / 2, 0, 0});
  if (row.name == "wedge_two_infinite_planes") return parts(between_planes(p[0] * pi / 180), {1, 0, 0});
  if (row.name == "sphere_above_plane_point_below") {  // what its outline hides; touching, it hides all
    const auto sky = parts(open_sky(), Vec3::Zero());
    const auto hidden = p[0] == p[1] ? sky : parts(dark(outline(p[0], p[1])), Vec3::Zero());
    return {sky[0] - hidden[0], sky[1] - hidden[1]};
  }
  return {std::numeric_limits<double>::quiet_NaN(), 0};
}

TEST(LightIrradiance, IsThatOfTheVisibleSky) {
  int rows = 0;
  for (const ReferenceRow& row : reference_rows("ambient_occlusion.csv")) {
    const auto found = visibility_of(row);
    EXPECT_NEAR(found[0], row.values.at(0), allowed)
        << row.name << " " << testing::PrintToString(row.parameters);
    EXPECT_NEAR(found[1], row.values.at(1), allowed)
        << row.name << " " << testing::PrintToString(row.parameters);
    ++rows;
  }
  EXPECT_EQ(rows, 21);
}

}  // namespace
}  // namespace etendue::irradiance_identities_test
