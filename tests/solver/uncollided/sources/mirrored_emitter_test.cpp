// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/sources/mirrored_emitter.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/uncollided/lights/light_setup.h"
#include "solver/uncollided/sources/extended_source.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::mirrored_emitter_test {
namespace {

/// The cells of the region "source" as parts of a light.
std::vector<EmitterPart> source_cells(const TetrahedralMesh& mesh) {
  std::vector<EmitterPart> parts;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (mesh.region_names()[static_cast<std::size_t>(mesh.region(cell))] != "source") continue;
    EmitterPart& part = parts.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) part.corners[i] = mesh.point(VertexIndex(mesh.vertices(cell)[i]));
    part.brightness = {1};
    part.extinction = {1.5};
    part.cell = cell;
  }
  return parts;
}

/// A box of a medium that emits in a cube of another medium, in the corner of three sides that are mirrors;
/// or what these show, the whole of it.
class Scene {
 public:
  Scene(double from, double reflectance)
      : mesh_(mesh(from)), problem_(problem(mesh_, from, reflectance)), lights_(problem_) {}

  const LightPaths& paths() const { return lights_.paths(); }
  const ExtendedSource& source() const { return *lights_.sources().front()->as_wide()->as_extended(); }
  double fluence(const Vec3& point, LightDetail detail) const {
    LightBeams beams(1);
    source().add_beams({CellLocator(mesh_).find(point).front().cell, point}, Sight::attenuated, detail,
                       beams);
    double sum = 0;
    for (std::size_t i = 0; i < beams.size(); ++i) sum += beams.fluence(i)[0];
    return sum;
  }
  HomogeneousLight even(const Vec3& point, std::optional<int> without = {}) const {
    LightBeams beams(1);
    HomogeneousLight light(1);
    source().evaluate_homogeneous(point, std::vector<double>{0.7}, without, beams, light);
    return light;
  }
  std::vector<EmitterPart> cells() const { return source_cells(mesh_); }

 private:
  static TetrahedralMesh mesh(double from) {
    Geometry geometry;
    BoxPrimitive room, source;
    room.region = "room";
    room.min = from * Vec3::Ones();
    geometry.primitives.emplace_back(room);
    source.region = "source";
    source.min = 0.3 * from * Vec3::Ones();
    source.max = {0.3, 0.3, 0.3};
    geometry.primitives.emplace_back(source);
    return TetrahedralMesh(tetrahedralize(arrange(geometry), {{0.05, 0.05}, 1.4, {}}));
  }
  static Problem problem(const TetrahedralMesh& mesh, double from, double reflectance) {
    std::vector<Medium> media;
    for (const std::string& region : mesh.region_names()) {
      media.push_back(uniform_medium(1, region == "source" ? 1.5 : 0.4, 0, region == "source" ? 1 : 0));
      media.back().uncollided = region == "source" ? Uncollided::yes : Uncollided::no;
    }
    std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
    for (std::size_t w = 0; w < walls.size(); ++w)
      if (from == 0 && mesh.wall_names()[w].ends_with("min")) walls[w].specular = {reflectance};
    return Problem(mesh, {}, media, walls);
  }

  TetrahedralMesh mesh_;
  Problem problem_;
  LightSetup lights_;
};

const std::vector<Vec3> places = {
    {0.9, 0.8, 0.7}, {0.2, 0.25, 0.1}, {0.05, 0.6, 0.4}, {0.5, 0.5, 0}, {0, 0, 0.8}};

TEST(MirroredEmitter, IsOneBoxAboutTheCornerOfThreeMirrors) {
  const Scene corner(0, 1);
  const MirroredEmitter body(corner.paths(), corner.cells(), mirrors_touched(corner.paths(), corner.cells()));
  EXPECT_EQ(std::popcount(body.across), 3);
  ASSERT_EQ(body.shapes.size(), 1);
  EXPECT_EQ(body.shapes[0].first.edge_count(), 12);
  EXPECT_EQ(body.convex.size(), 6);
  EXPECT_LT((body.box.min() + 0.3 * Vec3::Ones()).norm(), 1e-12);
  EXPECT_NEAR(body.radius, 0.3 * std::sqrt(3.0), 1e-12);
}

// Behind a mirror that keeps a part of the light the image is another body.
TEST(MirroredEmitter, IsAloneWhereMirrorsKeepLight) {
  const Scene corner(0, 0.9);
  EXPECT_EQ(mirrors_touched(corner.paths(), corner.cells()), 0);
}

// Light would come through the black half of the floor otherwise.
TEST(MirroredEmitter, IsAloneWhereAMirrorEndsBelowIt) {
  Geometry geometry;
  for (const std::string region : {"room", "source"})
    for (const std::string half : {"left", "right"}) {
      BoxPrimitive box;
      box.region = region;
      box.min = {half == "left" ? 0.0 : 0.5, 0, 0};
      box.max = {half == "left" ? 0.5 : 1.0, 1, 1};
      if (region == "source") box.min[half == "left" ? 0 : 1] = 0.2;
      if (region == "source") box.max = {half == "left" ? 0.5 : 0.8, 0.7, 0.3};
      box.walls["zmin"] = half;
      geometry.primitives.emplace_back(box);
    }
  const TetrahedralMesh mesh(tetrahedralize(arrange(geometry), {{0.02, 0.02}, 1.4, {}}));
  for (const double right : {0.0, 1.0}) {
    std::vector<Medium> media(mesh.region_names().size(), uniform_medium(1, 0.4, 0, 1));
    for (Medium& medium : media) medium.uncollided = Uncollided::yes;
    std::vector<Wall> walls;
    for (const std::string& name : mesh.wall_names())
      walls.push_back(uniform_wall(1, 0, 0, name == "left" ? 1 : name == "right" ? right : 0));
    const Problem problem(mesh, {}, media, walls);
    const LightSetup lights(problem);
    EXPECT_EQ(std::popcount(mirrors_touched(lights.paths(), source_cells(mesh))), right == 1 ? 1 : 0);
  }
}

TEST(MirroredEmitter, BringsWhatTheWholeBringsWithoutMirrors) {
  const Scene corner(0, 1), whole(-1, 1);
  for (const Vec3& place : places) {
    const HomogeneousLight a = corner.even(place), b = whole.even(place);
    EXPECT_NEAR(a.fluence[0] / b.fluence[0], 1, 1e-9);
    EXPECT_LT((a.flux[0] - b.flux[0]).norm(), 1e-9 * b.fluence[0]);
    // The same pieces, but for the diagonals of their faces.
    EXPECT_NEAR(corner.fluence(place, fine_light) / whole.fluence(place, fine_light), 1, 1e-4);
  }
}

// On a mirror that sends all back half of what arrives is behind it.
TEST(MirroredEmitter, IsWithoutTheImagesBehindAMirrorHalfOfWhatIsSeenFromIt) {
  const Scene corner(0, 1);
  for (int mirror = 0; mirror < 3; ++mirror) {
    Vec3 place(0.6, 0.5, 0.4);
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(corner.paths().mirrors().normal(mirror)[axis]) > 0.9) place[axis] = 0;
    EXPECT_NEAR(corner.even(place, mirror).fluence[0] / corner.even(place).fluence[0], 0.5, 1e-9);
  }
}

// Of images that are bodies of their own, with nearly the same reflectance, as much arrives.
TEST(MirroredEmitter, BringsAsMuchAsItsImagesOneByOne) {
  const Scene one(0, 1), eight(0, 1 - 1e-12);
  for (const Vec3& place : places) {
    EXPECT_NEAR(one.even(place).fluence[0] / eight.even(place).fluence[0], 1, 1e-9);
    EXPECT_NEAR(one.fluence(place, fine_light) / eight.fluence(place, fine_light), 1, 1e-4);
  }
}

}  // namespace
}  // namespace etendue::mirrored_emitter_test
