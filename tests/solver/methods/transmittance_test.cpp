// SPDX-License-Identifier: AGPL-3.0-or-later
// Sheets that let light through, by all three methods.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Dense>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/geometry/primitives/sheet_shape.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/radiosity/solve/solve_radiosity.h"
#include "solver/solution/balance.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/methods/sheet_rooms.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::transmittance_test {
namespace {

using std::numbers::pi;

/// The unit cube with a sheet of walls "top" and "under" half-way up, from wall to wall or as a table.
TetrahedralMesh room_with_sheet(double margin, double max_volume) {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "air";
  geometry.primitives.emplace_back(room);
  geometry.sheets.push_back(
      {rectangle_corners({margin, margin, 0.5}, {1 - margin, 1 - margin, 0.5}), "top", "under", {}});
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{max_volume}, 1.4, {}}));
}

const TetrahedralMesh& divided() {
  static const TetrahedralMesh mesh = room_with_sheet(0, 0.03);
  return mesh;
}
const TetrahedralMesh& with_table() {
  static const TetrahedralMesh mesh = room_with_sheet(0.25, 0.01);
  return mesh;
}

const Medium nothing = uniform_medium(1, 0, 0, 0);
const Medium haze = uniform_medium(1, 0.3, 1, 0);

void expect_balance(const Problem& problem, const Solution& solution, double tolerance = 1e-8) {
  EXPECT_LT(std::abs(balances(problem, solution)[0].residual), tolerance);
}

TEST(Transmittance, FacesOfASheetKnowEachOther) {
  const std::vector<std::int32_t> behind = faces_behind(with_table());
  double area = 0;
  for (std::int32_t f = 0; f < with_table().boundary_face_count(); ++f) {
    const std::int32_t other = behind[static_cast<std::size_t>(f)];
    if (other < 0) continue;
    EXPECT_EQ(behind[static_cast<std::size_t>(other)], f);
    EXPECT_EQ(with_table().vertices(FaceIndex(f)), with_table().vertices(FaceIndex(other)));
    EXPECT_LT((with_table().area_normal(FaceIndex(f)) + with_table().area_normal(FaceIndex(other))).norm(),
              1e-12);
    area += with_table().area(FaceIndex(f));
  }
  EXPECT_NEAR(area, 2 * 0.25, 1e-12);
}

// Black plates of radiance 1 below and 0.25 above, infinite since the sides are mirrors: what arrives at the
// sheet is what the plate of its side sends, and both sides send on r of their own and t of the other.
TEST(Transmittance, TwoBlackCavitiesExchangeLight) {
  const double r = 0.2, t = 0.5;
  std::map<std::string, Surface> walls{{"top", {0, r, t}}, {"under", {0, r, t}}};
  walls["zmin"] = {1};
  walls["zmax"] = {0.25};
  const Problem mirrors = room(divided(), nothing, walls, {0, 0, 0, 1});
  const Solution ordinates = by_ordinates(mirrors);
  ASSERT_TRUE(ordinates.converged());
  const double range = ordinates.half_range[0];
  EXPECT_NEAR(power_on(mirrors, ordinates, "zmax").incoming, range * (0.25 * r + t), 1e-9);
  EXPECT_NEAR(power_on(mirrors, ordinates, "zmin").incoming, range * (r + 0.25 * t), 1e-9);
  expect_balance(mirrors, ordinates);
  const PhotonSolution photons = by_photons(mirrors, 20000);
  const std::size_t top = wall_number(mirrors, "zmax"), floor = wall_number(mirrors, "zmin");
  EXPECT_NEAR(photons.sums.derived.mean(top), pi * (0.25 * r + t), 3.5 * photons.sums.derived.error(top));
  EXPECT_NEAR(photons.sums.derived.mean(floor), pi * (r + 0.25 * t), 3.5 * photons.sums.derived.error(floor));
  const Solution radiosity = by_radiosity(mirrors);
  EXPECT_NEAR(power_on(mirrors, radiosity, "zmax").incoming, pi * (0.25 * r + t), 1e-9);
  EXPECT_NEAR(power_on(mirrors, radiosity, "zmin").incoming, pi * (r + 0.25 * t), 1e-9);
  expect_balance(mirrors, radiosity);
}

// Plates that reflect too: the light goes to and fro between four surfaces, infinite since the sides are
// mirrors.
TEST(Transmittance, CavitiesInSeriesHaveAClosedForm) {
  const double r = 0.3, t = 0.6, floor = 0.7, ceiling = 0.5;
  const Problem problem =
      room(divided(), nothing,
           {{"top", {0, r, t}}, {"under", {0, r, t}}, {"zmin", {1, floor, 0}}, {"zmax", {0, ceiling, 0}}},
           {0, 0, 0, 1});
  // What arrives, over pi: at the floor, under the sheet, on it, at the ceiling.
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix(0, 1) -= r;
  matrix(0, 2) -= t;
  matrix(1, 0) -= floor;
  matrix(2, 3) -= ceiling;
  matrix(3, 2) -= r;
  matrix(3, 1) -= t;
  const Eigen::Vector4d exact = matrix.partialPivLu().solve(Eigen::Vector4d(0, 1, 0, 0));
  for (const Acceleration acceleration : {Acceleration::automatic, Acceleration::diffusion}) {
    SolveOptions options = tight_options();
    options.acceleration = acceleration;
    const Solution solution = solve(problem, directions_ldfe_sq(1), options);
    ASSERT_TRUE(solution.converged());
    const double range = solution.half_range[0];
    EXPECT_NEAR(power_on(problem, solution, "zmin").incoming, range * exact[0], 1e-8);
    EXPECT_NEAR(power_on(problem, solution, "under").incoming, range * exact[1], 1e-8);
    EXPECT_NEAR(power_on(problem, solution, "top").incoming, range * exact[2], 1e-8);
    EXPECT_NEAR(power_on(problem, solution, "zmax").incoming, range * exact[3], 1e-8);
    expect_balance(problem, solution);
  }
  for (const RadiosityMethod method :
       {RadiosityMethod::gathering, RadiosityMethod::shooting, RadiosityMethod::direct}) {
    const Solution solution = by_radiosity(problem, method);
    EXPECT_NEAR(power_on(problem, solution, "zmin").incoming, pi * exact[0], 1e-8);
    EXPECT_NEAR(power_on(problem, solution, "under").incoming, pi * exact[1], 1e-8);
    EXPECT_NEAR(power_on(problem, solution, "top").incoming, pi * exact[2], 1e-8);
    EXPECT_NEAR(power_on(problem, solution, "zmax").incoming, pi * exact[3], 1e-8);
    expect_balance(problem, solution);
  }
  const PhotonSolution photons = by_photons(problem, 40000);
  const std::array<std::string, 4> names{"zmin", "under", "top", "zmax"};
  for (Eigen::Index i = 0; i < 4; ++i) {
    const std::size_t wall = wall_number(problem, names[static_cast<std::size_t>(i)]);
    EXPECT_NEAR(photons.sums.derived.mean(wall), pi * exact[i], 3.5 * photons.sums.derived.error(wall));
  }
}

// Everything at one temperature: u = 2 everywhere, whatever the sheet lets through.
TEST(Transmittance, FurnaceDoesNotSeeTheSheet) {
  const double u = 2;
  const auto wall = [&](double diffuse, double transmittance) {
    return Surface{(1 - diffuse - transmittance) * u, diffuse, transmittance};
  };
  const std::map<std::string, Surface> walls{{"top", wall(0.5, 0.4)}, {"under", wall(0.1, 0.4)}};
  const Problem hazy = room(with_table(), uniform_medium(1, 0.7, 1.3, 0.7 * u), walls, wall(0.3, 0));
  const Solution found = solve(hazy, directions_ldfe_sq(1), tight_options());
  EXPECT_LT(largest_deviation(found.fluence, 4 * pi * u), 1e-8);
  const Problem clear = room(with_table(), nothing, walls, wall(0.3, 0));
  for (const RadiosityMethod method :
       {RadiosityMethod::gathering, RadiosityMethod::shooting, RadiosityMethod::direct})
    EXPECT_LT(largest_deviation(by_radiosity(clear, method).irradiance, pi * u), 1e-8);
}

// Patches that join faces of the sheet, and such that cut them, lie on each other.
TEST(Transmittance, PatchesOfAnySizePassThePower) {
  const Problem problem = room(
      divided(), nothing, {{"zmin", {1, 0.3}}, {"top", {0, 0.25, 0.5}}, {"under", {0, 0.4, 0.5}}}, {0, 0.5});
  for (const double size : {0.0, 0.6, 0.3}) {
    const Solution solution = by_radiosity(problem, RadiosityMethod::gathering, size);
    expect_balance(problem, solution);
    const WallPower top = power_on(problem, solution, "top"), under = power_on(problem, solution, "under");
    EXPECT_NEAR(top.outgoing, 0.25 * top.incoming + 0.5 * under.incoming, 1e-9);
    EXPECT_NEAR(under.outgoing, 0.4 * under.incoming + 0.5 * top.incoming, 1e-9);
  }
}

// Patches that are cut where the light changes, on one side of the sheet more than on the other, pass the
// power too, along links as well, and bring to the walls what even fine patches do.
TEST(Transmittance, PatchesThatAreCutWhereTheLightChangesPassThePower) {
  const Problem problem =
      room(with_table(), nothing,
           {{"zmin", {1, 0.3}}, {"top", {0, 0.25, 0.5}}, {"under", {0, 0.4, 0.5}}, {"zmax", {0, 0.5}}});
  RadiosityOptions options;
  options.threads = 2;
  options.limits = {1e-10, 2000};
  options.patch_size = 0.2;
  RadiosityRoom even(problem, options);
  const Solution fine = even.solve();
  options.patch_size = 0.4;
  options.refinement = {.change = 0.4, .smallest = 0.15};
  for (const RadiosityMethod method : {RadiosityMethod::gathering, RadiosityMethod::hierarchical}) {
    options.method = method;
    RadiosityRoom cut(problem, options);
    EXPECT_GT(cut.report().rounds.size(), 1u);
    const Solution solution = cut.solve();
    expect_balance(problem, solution);
    const WallPower top = power_on(problem, solution, "top"), under = power_on(problem, solution, "under");
    EXPECT_NEAR(top.outgoing, 0.25 * top.incoming + 0.5 * under.incoming, 1e-9);
    EXPECT_NEAR(under.outgoing, 0.4 * under.incoming + 0.5 * top.incoming, 1e-9);
    for (const std::string& wall : with_table().wall_names()) {
      const double wanted = power_on(problem, fine, wall).incoming;
      EXPECT_NEAR(power_on(problem, solution, wall).incoming, wanted, 0.02 * wanted) << wall;
    }
  }
}

TEST(Transmittance, MethodsAgree) {
  const std::map<std::string, Surface> walls{
      {"zmin", {1, 0.3}}, {"top", {0, 0.25, 0.5}}, {"under", {0, 0.4, 0.5}}, {"zmax", {0, 0.5}}};
  const Problem clear = room(with_table(), nothing, walls), hazy = room(with_table(), haze, walls);
  const PhotonSolution clear_photons = by_photons(clear, 30000), hazy_photons = by_photons(hazy, 30000);
  const Solution radiosity = by_radiosity(clear);
  const Solution ordinates = solve(hazy, directions_ldfe_sq(2), tight_options());
  expect_balance(clear, radiosity);
  expect_balance(hazy, ordinates);
  for (std::size_t w = 0; w < with_table().wall_names().size(); ++w) {
    const std::string& wall = with_table().wall_names()[w];
    // Patches and cells are a fifth of the room wide.
    const double lit = clear_photons.sums.derived.mean(w), dim = hazy_photons.sums.derived.mean(w);
    EXPECT_NEAR(power_on(clear, radiosity, wall).incoming, lit,
                3 * clear_photons.sums.derived.error(w) + 0.02 * lit)
        << wall;
    EXPECT_NEAR(power_on(hazy, ordinates, wall).incoming, dim,
                3 * hazy_photons.sums.derived.error(w) + 0.02 * dim)
        << wall;
  }
  EXPECT_LT(std::abs(balances(hazy, hazy_photons.solution)[0].residual), 0.01);
}

// A lamp above the sheet: its uncollided light comes out below, diffusely.
TEST(Transmittance, ALampShinesThrough) {
  const double t = 0.7;
  PointLight point;
  point.position = {0.5, 0.5, 0.75};
  point.power = {4 * pi};
  const Problem problem =
      room(divided(), nothing, {{"top", {0, 0, t}}, {"under", {0, 0, t}}}, {}, {{"lamp", point, {}}});
  const Solution solution = by_ordinates(problem);
  const double arrives = power_on(problem, solution, "top").incoming;
  EXPECT_GT(arrives, 3);
  EXPECT_NEAR(power_on(problem, solution, "under").outgoing, t * arrives, 1e-6);
  EXPECT_NEAR(solution.lights.balance[0].residual, 0, 5e-3);
  expect_balance(problem, solution, 5e-3);
  const PhotonSolution photons = by_photons(problem, 20000);
  const std::size_t floor = wall_number(problem, "zmin");
  EXPECT_NEAR(power_on(problem, solution, "zmin").incoming, photons.sums.derived.mean(floor),
              3 * photons.sums.derived.error(floor) + 0.02);
}

TEST(Transmittance, IsRefusedWhereNothingIsBehindOrTheSidesDiffer) {
  const auto message = [](const std::map<std::string, Surface>& walls) -> std::string {
    try {
      room(with_table(), nothing, walls);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message({{"zmin", {0, 0, 0.5}}}).find("walls.zmin.transmittance = 0.5: the wall is no sheet at"),
            std::string::npos);
  EXPECT_NE(message({{"top", {0, 0, 0.5}}, {"under", {0, 0, 0.4}}})
                .find("walls.top.transmittance = 0.5: the other side of the sheet, under, has 0.4"),
            std::string::npos);
  EXPECT_NE(message({{"top", {0, 0.6, 0.5}}, {"under", {0, 0, 0.5}}})
                .find("walls.top.diffuse + specular + transmittance = 1.1: reflects more light than arrives"),
            std::string::npos);
}

}  // namespace
}  // namespace etendue::transmittance_test
