// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/sources/extended_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/angular/sets/rotation.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::extended_source_test {
namespace {

using std::numbers::pi;

/// A disc about z in the plane z = height that shines downwards with radiance 1; the polygon has its area.
std::vector<EmitterPart> disc(const Vec3& centre, double radius, int sides) {
  const double angle = 2 * pi / sides;
  const double corner = radius * std::sqrt(angle / std::sin(angle));
  const auto rim = [&](int i) {
    return Vec3(centre + corner * Vec3(std::cos(i * angle), std::sin(i * angle), 0));
  };
  std::vector<EmitterPart> parts;
  for (int i = 0; i < sides; ++i) parts.push_back({{centre, rim(i + 1), rim(i)}, {1.0}, {}});
  return parts;
}

double irradiance(const LightBeams& beams, const Vec3& normal) {
  double sum = 0;
  for (std::size_t i = 0; i < beams.size(); ++i)
    sum += std::max(0.0, -beams.direction(i).dot(normal)) * beams.fluence(i)[0];
  return sum;
}

// On the axis at a distance where the disc has the half angle a: E = pi L sin^2 a.
TEST(ExtendedSource, DiscLightsItsAxisAsItsHalfAngleSays) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0, 0, 0), uniform_wall(1, 0, 0, 0));
  const LightPaths paths(problem);
  const CellLocator locator(mesh);
  const double radius = 0.3;
  const ExtendedSource source(
      "disc", {1}, EmitterTree(EmitterShape::triangles, disc({0.5, 0.5, 0.9}, radius, 256)), paths);
  for (const double distance : {0.01, 0.1, 0.3, 0.6, 0.85}) {
    const Vec3 point(0.5, 0.5, 0.9 - distance);
    LightBeams beams(1);
    source.add_beams({locator.find(point)[0].cell, point}, Sight::attenuated, fine_light, beams);
    const double sine = radius / std::hypot(radius, distance);
    EXPECT_NEAR(irradiance(beams, Vec3::UnitZ()) / (pi * sine * sine), 1, 1e-3) << distance;
  }
}

// In the plane of a tilted disc, to rounding, nothing of its light arrives: on it, on its rim and beside it.
TEST(ExtendedSource, DiscSeenEdgeOnIsDark) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0, 0, 0), uniform_wall(1, 0, 0, 0));
  const LightPaths paths(problem);
  const CellLocator locator(mesh);
  const Vec3 centre(0.214, 0.8706, 0.362);
  const Rotation turn = rotation_about(Vec3(0.8161, -0.08868, -1).normalized() - Vec3::UnitZ(), 180);
  std::vector<EmitterPart> parts = disc(Vec3::Zero(), 0.08582, 64);
  for (EmitterPart& part : parts)
    for (std::size_t i = 0; i < 3; ++i) part.corners[i] = centre + turn * part.corners[i];
  const std::vector<EmitterPart> corners = parts;
  const ExtendedSource source("disc", {1}, EmitterTree(EmitterShape::triangles, std::move(parts)), paths);
  for (const EmitterPart& part : corners)
    for (const auto& [a, b] :
         {std::pair{0.3, 0.3}, {0.5, 0.5}, {0.5, 0.0}, {0.0, 0.5}, {1.0, 0.0}, {0.8, 0.7}}) {
      const Vec3 point =
          part.corners[0] + a * (part.corners[1] - part.corners[0]) + b * (part.corners[2] - part.corners[0]);
      LightBeams beams(1);
      source.add_beams({locator.find(point)[0].cell, point}, Sight::attenuated, fine_light, beams);
      EXPECT_NEAR(irradiance(beams, turn * Vec3::UnitZ()), 0, 1e-9);
    }
}

/// A ball of radius 0.15 in the unit cube: a hole whose wall shines with radiance 1, or a medium that would
/// if it were thick enough.
enum class Ball { wall, matter };
const Vec3 ball_centre(0.5, 0.5, 0.7);
constexpr double radius_of_ball = 0.15;

class SceneWithBall {
 public:
  /// The extinction of its medium times the radius.
  SceneWithBall(Ball kind, int facets, double thickness)
      : mesh_(mesh_with(kind, facets)), problem_(problem_on(mesh_, thickness)), lights_(problem_) {}

  double irradiance(const Vec3& point) const {
    const PointInCell at{CellLocator(mesh_).find(point).front().cell, point};
    return lights_.at(at, (ball_centre - point).normalized()).irradiance[0];
  }
  /// That of its facets by Lambert (1760).
  double irradiance_of_facets(const Vec3& point) const {
    const Vec3 up = (ball_centre - point).normalized();
    double sum = 0;
    for (const auto& facet : facets_of(mesh_)) {
      std::array<Vec3, 3> separation;
      for (std::size_t i = 0; i < 3; ++i) separation[i] = facet[i] - point;
      if ((separation[1] - separation[0]).cross(separation[2] - separation[0]).dot(separation[0]) >= 0)
        continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &a = separation[i], &b = separation[(i + 1) % 3];
        sum += std::atan2(a.cross(b).norm(), a.dot(b)) * b.cross(a).normalized().dot(up) / 2;
      }
    }
    return sum;
  }

 private:
  static TetrahedralMesh mesh_with(Ball kind, int facets) {
    Geometry geometry;
    BoxPrimitive room;
    room.region = "room";
    geometry.primitives.emplace_back(room);
    SpherePrimitive ball;
    ball.center = ball_centre;
    ball.radius = radius_of_ball;
    ball.facets = facets;
    ball.hole = kind == Ball::wall;
    (ball.hole ? ball.name : ball.region) = "ball";
    geometry.primitives.emplace_back(ball);
    std::vector<double> volumes(kind == Ball::wall ? 1 : 2, 0.02);
    return TetrahedralMesh(tetrahedralize(arrange(geometry), {volumes, 1.4, {}}));
  }
  static Problem problem_on(const TetrahedralMesh& mesh, double thickness) {
    std::vector<Medium> media;
    for (const std::string& region : mesh.region_names()) {
      const double extinction = region == "ball" ? thickness / radius_of_ball : 0;
      media.push_back(uniform_medium(1, extinction, 0, extinction));
      if (region == "ball") media.back().uncollided = Uncollided::yes;
    }
    std::vector<Wall> walls;
    for (const std::string& name : mesh.wall_names()) {
      walls.push_back(uniform_wall(1, name.starts_with("ball") ? 1 : 0, 0, 0));
      if (name.starts_with("ball")) walls.back().uncollided = Uncollided::yes;
    }
    return Problem(mesh, {}, media, walls);
  }
  /// Of the ball, counterclockwise as seen from outside of it.
  static std::vector<std::array<Vec3, 3>> facets_of(const TetrahedralMesh& mesh) {
    std::vector<std::array<Vec3, 3>> facets;
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      const FaceIndex face(f);
      if (f >= mesh.boundary_face_count() &&
          mesh.region(mesh.owner(face)) == mesh.region(mesh.neighbour(face)))
        continue;
      std::array<Vec3, 3> corners;
      bool on_ball = true;
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = mesh.point(VertexIndex(mesh.vertices(face)[i]));
        on_ball = on_ball && std::abs((corners[i] - ball_centre).norm() - radius_of_ball) < 1e-9;
      }
      if (!on_ball) continue;
      if ((corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[0] - ball_centre) < 0)
        std::swap(corners[1], corners[2]);
      facets.push_back(corners);
    }
    return facets;
  }

  TetrahedralMesh mesh_;
  Problem problem_;
  LightSetup lights_;
};

/// Near the ball and far from it.
std::vector<Vec3> places() { return {{0.5, 0.5, 0.5}, {0.52, 0.49, 0.1}, {0.1, 0.2, 0.9}}; }

/// What a ball of a medium brings to a meter that faces it, over what one of radiance 1 does, pi sin^2 a: the
/// integral of 1 - exp(-2 s sqrt(R^2 - d^2 sin^2)) over the ball's disc.
double part_of_black(double thickness) {
  const double x = 2 * thickness;
  return 1 - 2 * (1 - (1 + x) * std::exp(-x)) / (x * x);
}

// E = pi L sin^2 a of a ball of half angle a: its facets bring what Lambert says, and four times as many are
// four times as near.
TEST(ExtendedSource, WallOfABallShinesAsItsHalfAngleSays) {
  const SceneWithBall coarse(Ball::wall, 80, 0), fine(Ball::wall, 320, 0);
  for (const Vec3& place : places()) {
    const double exact = pi * std::pow(radius_of_ball / (place - ball_centre).norm(), 2);
    EXPECT_NEAR(coarse.irradiance(place) / coarse.irradiance_of_facets(place), 1, 1e-5);
    EXPECT_NEAR(fine.irradiance(place) / fine.irradiance_of_facets(place), 1, 1e-5);
    EXPECT_NEAR(fine.irradiance(place) / exact, 1, 0.02);
    EXPECT_GT((exact - coarse.irradiance(place)) / (exact - fine.irradiance(place)), 3.5);
  }
}

// The same of an emitting ball, from thin to thick, as of a light of pi sin^2 a times what its chords send;
// from far away too, where its parts are small but not thin.
TEST(ExtendedSource, EmittingBallShinesAsItsHalfAngleSays) {
  for (const double thickness : {0.1, 1.0, 3.0, 10.0}) {
    const SceneWithBall coarse(Ball::matter, 80, thickness), fine(Ball::matter, 320, thickness);
    for (const Vec3& place : places()) {
      const double exact =
          pi * std::pow(radius_of_ball / (place - ball_centre).norm(), 2) * part_of_black(thickness);
      EXPECT_NEAR(fine.irradiance(place) / exact, 1, 0.035) << thickness << " " << place.transpose();
      EXPECT_GT((exact - coarse.irradiance(place)) / (exact - fine.irradiance(place)), 2.5) << thickness;
    }
  }
}

// A ball that emits q everywhere without absorbing: the fluence in its middle is 4 pi q R, and outside at a
// distance d the net flux is q V / d^2 for every d.
TEST(ExtendedSource, BallShinesAsFromItsMiddle) {
  const TetrahedralMesh mesh = cube_with_ball(5e-3);
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0), uniform_medium(1, 0, 0, 0)},
                        std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0)));
  const LightPaths paths(problem);
  std::vector<EmitterPart> parts;
  double volume = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    if (mesh.region_names()[static_cast<std::size_t>(mesh.region(CellIndex(c)))] != "ball") continue;
    EmitterPart part{{}, {1.0}, {0.0}};
    for (std::size_t i = 0; i < 4; ++i)
      part.corners[i] = mesh.point(VertexIndex(mesh.vertices(CellIndex(c))[i]));
    parts.push_back(part);
    volume += mesh.volume(CellIndex(c));
  }
  const ExtendedSource source("ball", {4 * pi * volume}, EmitterTree(EmitterShape::tetrahedra, parts), paths);
  const CellLocator locator(mesh);
  for (const Vec3& point : {Vec3(0.5, 0.5, 0.98), Vec3(0.06, 0.1, 0.1), Vec3(0.5, 0.97, 0.2)}) {
    LightBeams beams(1);
    source.add_beams({locator.find(point)[0].cell, point}, Sight::attenuated, fine_light, beams);
    Vec3 flux = Vec3::Zero();
    for (std::size_t i = 0; i < beams.size(); ++i) flux += beams.fluence(i)[0] * beams.direction(i);
    const Vec3 away = point - Vec3(0.5, 0.5, 0.5);
    EXPECT_NEAR(flux.norm() * away.squaredNorm() / volume, 1, 3e-3);
    EXPECT_NEAR(flux.dot(away.normalized()) / flux.norm(), 1, 1e-4);
  }
  LightBeams beams(1);
  const Vec3 middle(0.5, 0.5, 0.5);
  source.add_beams({locator.find(middle)[0].cell, middle}, Sight::attenuated, fine_light, beams);
  double fluence = 0;
  for (std::size_t i = 0; i < beams.size(); ++i) fluence += beams.fluence(i)[0];
  EXPECT_NEAR(fluence / (4 * pi * std::cbrt(3 * volume / (4 * pi))), 1, 0.01);
}

// The means of a frame and of its halves lie in its opening.
TEST(EmitterTree, HasItsPointsInTheLight) {
  std::vector<EmitterPart> parts;
  const auto add_square = [&](double x, double y) {
    const Vec3 a(x, y, 1), b(x + 1, y, 1), c(x + 1, y + 1, 1), d(x, y + 1, 1);
    parts.push_back({{a, c, b}, {1.0}, {}});
    parts.push_back({{a, d, c}, {1.0}, {}});
  };
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      if (i == 0 || j == 0 || i == 7 || j == 7) add_square(i, j);
  const EmitterTree tree(EmitterShape::triangles, parts);
  int hollow = 0, whole = 0;
  const auto in_light = [](const Vec3& p) {
    return p.minCoeff() > -1e-9 && std::max(p.x(), p.y()) < 8 + 1e-9 &&
           (std::min(p.x(), p.y()) < 1 + 1e-9 || std::max(p.x(), p.y()) > 7 - 1e-9);
  };
  const std::function<void(const EmitterTree::Node&)> look = [&](const EmitterTree::Node& node) {
    EXPECT_TRUE(in_light(node.middle));
    for (std::size_t i = 0; i < node.point_count; ++i) EXPECT_TRUE(in_light(node.points[i]));
    if (node.part >= 0) return;
    ++(node.hollow ? hollow : whole);
    for (const int child : node.children) look(tree.node(child));
  };
  look(tree.root());
  EXPECT_GT(hollow, 0);
  EXPECT_GT(whole, 10);
}

}  // namespace
}  // namespace etendue::extended_source_test
