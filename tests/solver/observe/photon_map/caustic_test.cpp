// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Light that a mirror or a glossy wall throws onto a floor: no camera's ray finds it from there, the photon
// map does.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <vector>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "solver/materials/surfaces/microfacets.h"
#include "solver/materials/surfaces/phong.h"
#include "solver/materials/surfaces/ward.h"
#include "tests/solver/observe/photon_map/map_samples.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::caustic_test {
namespace {

using std::numbers::pi;

constexpr double beam = 3;            // irradiance across the light, which travels along x
constexpr double share = 0.9;         // of the mirror, and the reflectance of lobes
constexpr double floor_share = 0.01;  // so little that what comes back to the floor does not count

// A sheet that falls at 45 degrees: a mirror turns the light straight down.
const Vec3 top(0.3, 0.2, 0.9), down(0.4, 0, -0.4), across(0, 0.6, 0);
const Vec3 normal = Vec3(-1, 0, -1).normalized();

const TetrahedralMesh& room() {
  static const TetrahedralMesh mesh = [] {
    Geometry geometry;
    BoxPrimitive box;
    box.region = "air";
    geometry.primitives.emplace_back(box);
    geometry.sheets.push_back(
        {{top, top + down, top + down + across, top + across}, "sheet", "sheet.back", {}});
    return TetrahedralMesh(tetrahedralize(arrange(geometry), {{0.002}, 1.4, {}}));
  }();
  return mesh;
}

/// Light enters by the wall at x = 0; all but the sheet and the floor is black.
Problem lit_sheet(double specular, const std::shared_ptr<const Reflectance>& lobe) {
  std::vector<Wall> walls;
  int window = -1;
  for (const std::string& name : room().wall_names()) {
    if (name == "xmin") window = static_cast<int>(walls.size());
    const bool sheet = name.starts_with("sheet");
    walls.push_back(uniform_wall(1, 0, name == "zmin" ? floor_share : 0, sheet ? specular : 0));
    if (sheet && lobe != nullptr) walls.back().glossy = {lobe};
    walls.back().name = name;
  }
  return Problem(room(), {}, {uniform_medium(1, 0, 0, 0)}, walls, AngularSpace::sphere,
                 {{"sun", BeamLight{Vec3::UnitX(), {beam}, {window}}, {}}});
}

std::vector<FaceIndex> floor_faces() {
  std::vector<FaceIndex> faces;
  for (std::int32_t f = 0; f < room().boundary_face_count(); ++f)
    if (room().wall_names()[static_cast<std::size_t>(room().wall(FaceIndex(f)))] == "zmin")
      faces.emplace_back(f);
  return faces;
}

/// Of the floor at a point: all parts of the sheet send f_r times what falls on them.
double irradiance_by(const Reflectance& lobe, const Vec3& point) {
  constexpr int parts = 60;
  double sum = 0;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j) {
      const Vec3 from = top + (i + 0.5) / parts * down + (j + 0.5) / parts * across,
                 separation = point - from;
      const Vec3 travel = separation.normalized();
      sum += lobe.between(Vec3::UnitX(), travel, normal) * travel.dot(normal) * -travel.z() /
             separation.squaredNorm();
    }
  return beam * -normal.x() * sum * down.cross(across).norm() / (parts * parts);
}

TEST(Caustic, OfAMirrorIsAsBrightAsTheLightAndEndsWithIt) {
  const Problem problem = lit_sheet(share, nullptr);
  const MapRadiance map = map_of(problem, 60000, 100);
  MapRadiance::Workspace work;
  std::vector<FaceIndex> lit;
  for (const FaceIndex face : floor_faces()) {
    const Vec3 off = room().centroid(face) - Vec3(0.5, 0.5, 0);
    const double x = std::abs(off.x()) - 0.2, y = std::abs(off.y()) - 0.3;
    // A disc of 100 hits has the radius 0.05.
    if (x < -0.06 && y < -0.06) lit.push_back(face);
    if (x > 0.1 || y > 0.1) {
      EXPECT_LT(map.irradiance(face, room().centroid(face), 0, work).value, 0.2 * beam);
    }
  }
  ASSERT_GT(lit.size(), 10u);
  const Deviation found =
      deviation(static_cast<int>(lit.size()), floor_share / pi * share * beam, [&](int i) {
        const FaceIndex face = lit[static_cast<std::size_t>(i)];
        return map.reflected(face, room().centroid(face), Vec3::UnitZ(), 0, work);
      });
  EXPECT_NEAR(found.mean, 0, 0.4);
  EXPECT_NEAR(found.rms, 1, 0.3);
}

TEST(Caustic, OfAGlossySheetIsThatOfItsParts) {
  const std::vector<std::shared_ptr<const Reflectance>> lobes = {
      std::make_shared<Phong>(share, 40), std::make_shared<Microfacets>(share, 0.2, FacetFresnel::constant),
      std::make_shared<Ward>(share, 0.2)};
  const std::vector<FaceIndex> faces = floor_faces();
  for (const auto& lobe : lobes) {
    const Problem problem = lit_sheet(0, lobe);
    const MapRadiance map = map_of(problem, 60000, 100);
    MapRadiance::Workspace work;
    double brightest = 0;
    for (const FaceIndex face : faces)
      brightest = std::max(brightest, irradiance_by(*lobe, room().centroid(face)));
    // A caustic still, if blurred.
    EXPECT_GT(brightest, 0.4 * share * beam);
    EXPECT_LT(brightest, share * beam);
    std::vector<FaceIndex> bright;
    std::vector<double> exact;
    for (const FaceIndex face : faces)
      if (const double value = irradiance_by(*lobe, room().centroid(face)); value > 0.2 * brightest) {
        bright.push_back(face);
        exact.push_back(value);
      }
    ASSERT_GT(bright.size(), 30u);
    const Deviation found = deviation(static_cast<int>(bright.size()), 1, [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      Estimate estimate = map.reflected(bright[k], room().centroid(bright[k]), Vec3::UnitZ(), 0, work);
      const double scale = floor_share / pi * exact[k];
      estimate.value /= scale;
      estimate.error /= scale;
      return estimate;
    });
    EXPECT_NEAR(found.mean, 0, 0.4);
    EXPECT_NEAR(found.rms, 1, 0.3);
    EXPECT_LT(found.error, 0.12);
  }
}

}  // namespace
}  // namespace etendue::caustic_test
