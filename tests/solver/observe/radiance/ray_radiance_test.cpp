// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/radiance/ray_radiance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "solver/materials/kernels/micro_flakes.h"
#include "solver/observe/camera/picture.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::ray_radiance_test {
namespace {

using std::numbers::pi;

/// A solved problem and a way to look into it.
struct Scene {
  Scene(const Problem& asked, DirectionSet set, const SolveOptions& how = tight_options())
      : problem(asked),
        directions(std::move(set)),
        options(how),
        lights(problem),
        solution(solve_split(lights, directions, options)),
        radiance(lights, directions, options, solution.state, 1) {}

  double along(const Vec3& from, const Vec3& direction, int shafts = 0) const {
    RayRadiance::Workspace work(radiance);
    std::vector<double> value(radiance.bands());
    const Vec3 unit = direction.normalized();
    radiance.along(*radiance.enter(from, unit), unit, {.shafts = shafts}, work, value);
    return value[0];
  }

  const Problem& problem;
  DirectionSet directions;
  SolveOptions options;
  LightSetup lights;
  Solution solution;
  RayRadiance radiance;
};

int wall_of(const TetrahedralMesh& mesh, const std::string& name) {
  return static_cast<int>(std::ranges::find(mesh.wall_names(), name) - mesh.wall_names().begin());
}

Camera camera_into_the_cube() {
  Camera camera;
  camera.position = {0.4, -1.3, 0.6};
  camera.look_at = {0.5, 0.5, 0.5};
  camera.pixels = {24, 18};
  camera.field_of_view = 40;
  return camera;
}

Problem with_lights(const TetrahedralMesh& mesh, const Medium& medium, const Wall& wall,
                    std::vector<Light> lights) {
  std::vector<Medium> media(mesh.region_names().size(), medium);
  std::vector<Wall> walls(mesh.wall_names().size(), wall);
  for (std::size_t i = 0; i < walls.size(); ++i) walls[i].name = mesh.wall_names()[i];
  return Problem(mesh, {}, media, walls, AngularSpace::sphere, std::move(lights));
}

bool is_on(const Picture& picture, double expected, double tolerance, int& seen) {
  seen = 0;
  bool all = true;
  for (const double value : picture.radiance)
    if (value != 0) {
      all = all && std::abs(value - expected) < tolerance;
      ++seen;
    }
  return all;
}

// In a furnace every ray brings the same radiance, whatever scatters and reflects.
TEST(RayRadiance, IsConstantInAFurnace) {
  const TetrahedralMesh mesh = cube_mesh(0.03);
  for (const PhaseFunction& phase :
       {PhaseFunction(PhaseIsotropic{}), PhaseFunction(PhaseHenyeyGreenstein{0.6}),
        PhaseFunction(PhaseHenyeyGreenstein{0.95})}) {
    const Problem furnace =
        uniform_problem(mesh, uniform_medium(1, 0.7, 2, 0.7 * 3, phase), uniform_wall(1, 0.3 * 3, 0.4, 0.3));
    const Scene scene(furnace, directions_ldfe_sq(1));
    const Picture picture = take_picture(scene.radiance, camera_into_the_cube(), 1);
    int seen = 0;
    EXPECT_TRUE(is_on(picture, 3, 3e-6, seen)) << phase_name(phase);
    EXPECT_GT(seen, 300);
    Camera gathering = camera_into_the_cube();
    gathering.gather = 64;
    EXPECT_TRUE(is_on(take_picture(scene.radiance, gathering, 1), 3, 3e-6, seen)) << phase_name(phase);
  }
}

TEST(RayRadiance, IsConstantInAFurnaceOfConstantElements) {
  const TetrahedralMesh mesh = cube_mesh(0.03);
  const Problem furnace = uniform_problem(
      mesh, uniform_medium(1, 0.7, 2, 0.7 * 3, PhaseHenyeyGreenstein{0.6}), uniform_wall(1, 0.3 * 3, 0.7, 0));
  SolveOptions options = tight_options();
  options.order = SpaceOrder::constant;
  const Scene scene(furnace, directions_product(4), options);
  EXPECT_NEAR(scene.along({0.4, 0.3, 0.2}, {0.3, 0.5, -0.2}), 3, 3e-6);
}

Medium matter(const DirectionalScattering& scattering, double reference, double albedo, double emission) {
  Medium medium = uniform_medium(1, 2 * reference * (1 - albedo), 2 * reference * albedo, emission);
  medium.directional = {scattering};
  return medium;
}

// Leaves and flakes of density 2: light that they send on in equal parts leaves a constant constant. Their
// extinction depends on the direction, and so does how they emit in a furnace: they have none there.
TEST(RayRadiance, SeesLeavesAndFlakesInAWhiteFurnace) {
  const TetrahedralMesh mesh = cube_mesh(0.03);
  const LeafCanopy leaves{LeafAngles::planophile, 0.6, 0.4};
  const MicroFlakes flakes{Vec3(1, 2, 2) / 3, 1, 0.3, 1};
  const std::vector<Medium> media = {matter(leaves, 0.5, 1, 0),
                                     matter(flakes, mean_flake_projection(flakes), 1, 0)};
  for (const Medium& medium : media) {
    const Problem furnace = uniform_problem(mesh, medium, uniform_wall(1, 3, 0, 0));
    const Scene scene(furnace, directions_ldfe_sq(1));
    for (const Vec3& towards : {Vec3(0.3, 0.5, -0.2), Vec3(0, 0, 1), Vec3(-1, 0.1, 0)})
      EXPECT_NEAR(scene.along({0.4, 0.3, 0.2}, towards), 3, 3e-6);
  }
}

// Black level leaves of density 2 let e^(-2 |mu| s) through, which flat light passes unhindered.
TEST(RayRadiance, PassesLevelLeavesAsTheyLie) {
  const TetrahedralMesh mesh = cube_mesh(0.03);
  const Medium black = matter(LeafCanopy{LeafAngles::horizontal, 0, 0}, 0.5, 0, 0);
  const Problem canopy = uniform_problem(mesh, black, uniform_wall(1, 3, 0, 0));
  const Scene scene(canopy, directions_ldfe_sq(1));
  for (const double mu : {1.0, 0.6, 0.0}) {
    const Vec3 towards(std::sqrt(1 - mu * mu), 0, mu);
    const double path_length = mu == 1.0 ? 0.8 : std::min(0.6 / towards.x(), mu > 0 ? 0.8 / mu : 1e9);
    EXPECT_NEAR(scene.along({0.4, 0.3, 0.2}, towards), 3 * std::exp(-2 * mu * path_length), 1e-9) << mu;
  }
}

// L = q/sigma (1 - e^(-sigma l)) of an emitting slab (Chandrasekhar 1960, eq. I.69), to rounding.
TEST(RayRadiance, IsThatOfAnEmittingSlab) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  const Problem slab = uniform_problem(mesh, uniform_medium(1, 2.5, 0, 1.5), uniform_wall(1, 0, 0, 0));
  const Scene scene(slab, directions_product(2));
  for (const double x : {0.13, 0.31, 0.77}) {
    EXPECT_NEAR(scene.along({x, -2, 0.4}, Vec3::UnitY()), 1.5 / 2.5 * (1 - std::exp(-2.5)), 1e-13);
    EXPECT_NEAR(scene.along({x, -1, -1 + 0.01}, {0, 1, 1}),
                1.5 / 2.5 * (1 - std::exp(-2.5 * std::sqrt(2) * 0.99)), 1e-12);
  }
}

// The integral of (1 + 2 y) e^(-s y) over the slab, s its extinction.
TEST(RayRadiance, IsThatOfASlabWithLinearEmission) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  Medium medium = uniform_medium(1, 2.5, 0, 0);
  medium.emission = {Coefficient(Expression("1 + 2*y", {"x", "y", "z"}))};
  const Problem slab = uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0));
  const Scene scene(slab, directions_product(2));
  const double s = 2.5, expected = (1 - std::exp(-s)) / s + 2 * (1 - (1 + s) * std::exp(-s)) / (s * s);
  for (const double x : {0.13, 0.31, 0.77})
    EXPECT_NEAR(scene.along({x, -2, 0.4}, Vec3::UnitY()), expected, 1e-13);
}

// The same seen in a mirror: through the slab, and through it once more.
TEST(RayRadiance, GoesOnAtAMirror) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t w = 0; w < walls.size(); ++w) {
    walls[w].name = mesh.wall_names()[w];
    if (walls[w].name == "ymax") walls[w].specular = {0.8};
  }
  const Problem slab(mesh, {}, {uniform_medium(1, 2, 0, 1)}, walls);
  const Scene scene(slab, directions_product(2));
  const double once = 0.5 * (1 - std::exp(-2.0));
  EXPECT_NEAR(scene.along({0.3, -1, 0.4}, Vec3::UnitY()), once + std::exp(-2.0) * 0.8 * once, 1e-12);
}

// A ray across the gap between two mirrors goes round and round: q/sigma (1 - t)/(1 - r t) of each mirror's r
// and the gap's t = e^(-sigma h), however thin the medium; where nothing is lost nothing shines, at once.
TEST(RayRadiance, AddsUpTheRoundsBetweenMirrors) {
  const TetrahedralMesh mesh = cube_mesh(0.03);
  for (const double extinction : {2.0, 1e-3, 1e-6}) {
    std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
    for (std::size_t w = 0; w < walls.size(); ++w) {
      walls[w].name = mesh.wall_names()[w];
      if (walls[w].name == "ymin" || walls[w].name == "ymax") walls[w].specular = {1.0};
      if (walls[w].name == "ymax") walls[w].specular = {0.99};
    }
    const Problem gap(mesh, {}, {uniform_medium(1, extinction, 0, extinction)}, walls);
    const Scene scene(gap, directions_product(2));
    const double across = std::exp(-extinction), glow = -std::expm1(-extinction);
    const double expected = glow * (1 + 0.99 * across) / (1 - 0.99 * across * across);
    EXPECT_NEAR(scene.along({0.3, -1, 0.4}, Vec3::UnitY()) / expected, 1, 1e-9) << extinction;
  }
  const Problem dark = uniform_problem(mesh, uniform_medium(1, 0, 0, 0), uniform_wall(1, 0, 0, 1));
  const Scene nothing(dark, directions_product(2));
  EXPECT_EQ(nothing.along({0.3, 0.2, 0.4}, Vec3::UnitY()), 0);
}

// Thin haze in the sun: L = sigma_s p E integral of e^(-sigma s) ds, with the phase function itself.
TEST(RayRadiance, ScattersTheSunOnceExactly) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  const PhaseHenyeyGreenstein phase{0.8};
  Problem haze = with_lights(mesh, uniform_medium(1, 1e-6, 1e-6, 0, phase), uniform_wall(1, 0, 0, 0),
                             {{"sun", BeamLight{-Vec3::UnitZ(), {5}, {0, 1, 2, 3, 4, 5}}, {}}});
  const Scene scene(haze, directions_ldfe_sq(1));
  for (const Vec3& looking : {Vec3(0, 1, 0), Vec3(0.2, 0.6, 0.5), Vec3(0.1, 0.3, -0.4)}) {
    const Vec3 unit = looking.normalized();
    const Vec3 from(0.4, 0.05, 0.5);
    double path_length = 0.95 / unit.y();
    if (unit.z() != 0) path_length = std::min(path_length, 0.5 / std::abs(unit.z()));
    const double expected = 1e-6 * value_of(phase, unit.z()) * 5 * path_length;
    // What scatters twice is a millionth of it; so is what is lost on the path.
    EXPECT_NEAR(scene.along(from, looking, 2), expected, 3e-6 * expected);
    EXPECT_NEAR(scene.along(from, looking), expected, 3e-6 * expected);
  }
}

// Thick haze, exactly: integral of e^(-s y) sigma_s p E e^(-s z) dy at constant height z.
TEST(RayRadiance, ScattersTheSunInThickHaze) {
  const TetrahedralMesh mesh = cube_mesh(0.002);
  const double extinction = 1.5, scattering = 1e-6;
  const int zmax = wall_of(mesh, "zmax");
  Problem haze = with_lights(mesh, uniform_medium(1, extinction - scattering, scattering, 0),
                             uniform_wall(1, 0, 0, 0), {{"sun", BeamLight{-Vec3::UnitZ(), {5}, {zmax}}, {}}});
  const Scene scene(haze, directions_ldfe_sq(1));
  const double depth = 0.6;
  const double expected =
      scattering / (4 * pi) * 5 * std::exp(-extinction * depth) * (1 - std::exp(-extinction)) / extinction;
  EXPECT_NEAR(scene.along({0.4, -1, 1 - depth}, Vec3::UnitY(), 4), expected, 1e-6 * expected);
  EXPECT_NEAR(scene.along({0.4, -1, 1 - depth}, Vec3::UnitY()), expected, 3e-3 * expected);
}

/// The unit cube around a crate that the sun from above does not go through.
TetrahedralMesh cube_with_crate() {
  BoxPrimitive room, crate;
  room.region = "haze";
  room.min = Vec3(0, 0, 0);
  room.max = Vec3(1, 1, 1);
  crate.hole = true;
  crate.name = "crate";
  crate.min = Vec3(0.31, 0.3, 0.6);
  crate.max = Vec3(0.67, 0.7, 0.8);
  Geometry geometry;
  geometry.primitives = {room, crate};
  TetrahedraOptions options;
  options.max_volume = {0.004};
  return TetrahedralMesh(tetrahedralize(arrange(geometry), options));
}

// Shafts beside the shadow of a crate: of the ray's path from x = 0 to 1 only what lies outside of the shadow
// is lit, so the integral of e^(-s x) leaves that stretch out. The cells do not know where the shadow's edges
// are; the points on the ray do, to a cell's part.
TEST(RayRadiance, ShaftsEndAtTheShadowOfACrate) {
  const TetrahedralMesh mesh = cube_with_crate();
  const double extinction = 1.5, scattering = 1e-6;
  Problem haze =
      with_lights(mesh, uniform_medium(1, extinction - scattering, scattering, 0), uniform_wall(1, 0, 0, 0),
                  {{"sun", BeamLight{-Vec3::UnitZ(), {5}, {wall_of(mesh, "zmax")}}, {}}});
  const Scene scene(haze, directions_ldfe_sq(1));
  const auto stretch = [&](double from, double to) {
    return (std::exp(-extinction * from) - std::exp(-extinction * to)) / extinction;
  };
  for (const double height : {0.2, 0.45}) {
    const double sun = scattering / (4 * pi) * 5 * std::exp(-extinction * (1 - height));
    const double lit = sun * (stretch(0, 0.31) + stretch(0.67, 1)), all = sun * stretch(0, 1);
    const double fast = scene.along({-1, 0.45, height}, Vec3::UnitX());
    const double crisp = scene.along({-1, 0.45, height}, Vec3::UnitX(), 64);
    EXPECT_NEAR(crisp, lit, 3e-3 * lit) << height;
    EXPECT_LT(std::abs(crisp - lit), std::abs(fast - lit) / 3) << height;
    EXPECT_GT(all, 1.4 * lit);
    // Beside the crate there is no shadow.
    EXPECT_NEAR(scene.along({-1, 0.1, height}, Vec3::UnitX(), 4), all, 1e-6 * all);
  }
}

TEST(RayRadiance, ShowsALampWithAnExtent) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  SurfaceLight lamp;
  lamp.triangles = {{0.3, 0.5, 0.3}, {0.7, 0.5, 0.3}, {0.7, 0.5, 0.7},
                    {0.3, 0.5, 0.3}, {0.7, 0.5, 0.7}, {0.3, 0.5, 0.7}};  // shines to -y
  lamp.radiance = {7};
  const Problem room =
      with_lights(mesh, uniform_medium(1, 0.9, 0, 0), uniform_wall(1, 0, 0, 0), {{"lamp", lamp, {}}});
  const Scene scene(room, directions_product(2));
  EXPECT_NEAR(scene.along({0.5, -1, 0.5}, Vec3::UnitY()), 7 * std::exp(-0.45), 1e-12);
  EXPECT_NEAR(scene.along({0.5, 0.1, 0.5}, Vec3::UnitY()), 7 * std::exp(-0.36), 1e-12);
  EXPECT_EQ(scene.along({0.5, 2, 0.5}, -Vec3::UnitY()), 0) << "from behind";
  EXPECT_EQ(scene.along({0.2, -1, 0.5}, Vec3::UnitY()), 0) << "beside it";
}

TEST(RayRadiance, LooksThroughBacksAndNotThroughFronts) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const Problem room = uniform_problem(mesh, uniform_medium(1, 0, 0, 0), uniform_wall(1, 2, 0, 0));
  const Scene scene(room, directions_product(2));
  EXPECT_NEAR(scene.along({0.5, -1, 0.5}, Vec3::UnitY()), 2, 1e-15);
  EXPECT_FALSE(scene.radiance.enter({0.5, -1, 0.5}, -Vec3::UnitY()));
}

TEST(Picture, HasTheSameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  PointLight lamp;
  lamp.position = {0.4, 0.55, 0.6};
  lamp.power = {1};
  const Problem room = with_lights(mesh, uniform_medium(1, 0.3, 2, 0, PhaseHenyeyGreenstein{0.7}),
                                   uniform_wall(1, 0, 0.5, 0), {{"lamp", lamp, {}}});
  const Scene scene(room, directions_ldfe_sq(1));
  Camera camera = camera_into_the_cube();
  camera.samples = 4;
  camera.gather = 64;
  const Picture one = take_picture(scene.radiance, camera, 1);
  for (const int threads : {2, 3, 5})
    EXPECT_EQ(take_picture(scene.radiance, camera, threads).radiance, one.radiance);
}

TEST(Picture, StopsWhereItIsAskedTo) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const Problem room = uniform_problem(mesh, uniform_medium(1, 0, 0, 0), uniform_wall(1, 2, 0, 0));
  const Scene scene(room, directions_product(2));
  double last = 0;
  EXPECT_TRUE(take_picture(scene.radiance, camera_into_the_cube(), 1, [&](double share) {
                EXPECT_GT(share, last);
                last = share;
                return true;
              }).whole);
  EXPECT_EQ(last, 1);
  EXPECT_FALSE(take_picture(scene.radiance, camera_into_the_cube(), 1, [](double) { return false; }).whole);
}

TEST(RayRadiance, RefusesAStateOfAnotherKind) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const Problem room = uniform_problem(mesh, uniform_medium(1, 0.1, 1, 0, PhaseHenyeyGreenstein{0.6}),
                                       uniform_wall(1, 2, 0, 0));
  const Scene scene(room, directions_product(4));
  EXPECT_THROW(RayRadiance(scene.lights, directions_product(2), scene.options, scene.solution.state, 1),
               InputError);
}

}  // namespace
}  // namespace etendue::ray_radiance_test
