// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Rooms whose walls have a reflectance f_r.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "solver/materials/surfaces/microfacets.h"
#include "solver/materials/surfaces/phong.h"
#include "solver/materials/surfaces/reflectance_table.h"
#include "solver/solution/balance.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::glossy_walls_test {
namespace {

using std::numbers::pi;

Wall glossy_wall(int bands, double radiance, double diffuse, std::shared_ptr<const Reflectance> lobe) {
  Wall wall = uniform_wall(bands, radiance, diffuse, 0);
  wall.glossy.assign(static_cast<std::size_t>(bands), std::move(lobe));
  return wall;
}

/// Walls by name: the one that shines, one that is `special`, the rest like `other`.
std::vector<Wall> walls_of(const TetrahedralMesh& mesh, const Wall& special, const Wall& other) {
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(name == "zmin" ? special : other);
    if (name == "zmax") walls.back().radiance.assign(other.radiance.size(), 1);
    walls.back().name = name;
  }
  return walls;
}

Solution solved(const Problem& problem, Method method = Method::automatic) {
  SolveOptions options = tight_options();
  options.method = method;
  return solve(problem, directions_ldfe_sq(1), options);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return largest / size;
}

// Everything at one temperature: a wall emits what it does not reflect, at each angle. The albedo of Phong's
// lobe with exponent 1 is r/pi (sin g + (pi - g) cos g).
TEST(GlossyFurnace, RadianceIsConstant) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const double level = 2.5;
  const auto lobe = std::make_shared<Phong>(0.5, 1);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(glossy_wall(1, 0, 0.3, lobe));
    walls.back().specular = {0.1};
    walls.back().name = name;
    const std::string c = std::string("abs(w") + name.front() + ")";
    walls.back().radiance_by_direction = {AngularFormula("2.5*(1-0.4-0.5/3.141592653589793*(sqrt(1-" + c +
                                                         "*" + c + ")+(3.141592653589793-acos(" + c + "))*" +
                                                         c + "))")};
  }
  const Problem problem(mesh, {}, {uniform_medium(1, 0.3, 0.7, 0.3 * level)}, walls);
  for (const SpaceOrder order : {SpaceOrder::linear, SpaceOrder::constant}) {
    SolveOptions options = tight_options();
    options.order = order;
    const Solution solution = solve(problem, directions_ldfe_sq(1), options);
    ASSERT_TRUE(solution.converged());
    EXPECT_LT(largest_deviation(solution.fluence, 4 * pi * level), 1e-8);
    EXPECT_LT(std::abs(balances(problem, solution)[0].residual), 1e-8);
  }
}

TEST(GlossyWalls, AnEvenReflectanceIsDiffuse) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  std::vector<ReflectancePoint> points;
  for (const double in : {0., 90.})
    for (const double out : {0., 90.}) points.push_back({in, out, 0, 1 / pi});
  const auto even = std::make_shared<ReflectanceTable>(points, 0.6);
  const Wall other = uniform_wall(1, 0, 0.4, 0);
  const Medium haze = uniform_medium(1, 0.2, 0.5, 0);
  const Problem glossy(mesh, {}, {haze}, walls_of(mesh, glossy_wall(1, 0, 0.2, even), other));
  const Problem diffuse(mesh, {}, {haze}, walls_of(mesh, uniform_wall(1, 0, 0.8, 0), other));
  // The half range of the set along z is not pi to the last digit.
  EXPECT_LT(largest_difference(solved(glossy).fluence, solved(diffuse).fluence), 1e-4);
}

TEST(GlossyWalls, ANearlySmoothWallIsAMirror) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const auto smooth = std::make_shared<Microfacets>(0.8, 0.001, FacetFresnel::constant);
  const Wall other = uniform_wall(1, 0, 0.4, 0);
  const Medium haze = uniform_medium(1, 0.2, 0.5, 0);
  const Problem glossy(mesh, {}, {haze}, walls_of(mesh, glossy_wall(1, 0, 0, smooth), other));
  const Problem mirror(mesh, {}, {haze}, walls_of(mesh, uniform_wall(1, 0, 0, 0.8), other));
  EXPECT_LT(largest_difference(solved(glossy).fluence, solved(mirror).fluence), 5e-3);
}

// The balance closes and all iterations find the same, with bands that differ.
TEST(GlossyWalls, IterationsAgreeAndLoseNothing) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  Wall floor = glossy_wall(2, 0, 0.1, std::make_shared<Phong>(0.8, 20));
  floor.glossy[1] = std::make_shared<Microfacets>(0.6, 0.4, FacetFresnel::constant);
  Wall other = glossy_wall(2, 0, 0.5, std::make_shared<Phong>(0.4, 5));
  other.glossy[1] = nullptr;
  const Problem problem(mesh, {{"a", "b"}, {}}, {uniform_medium(2, 0.1, 4, 0)}, walls_of(mesh, floor, other));
  Solution first;
  for (const Method method : {Method::gmres, Method::source_iteration})
    for (const Acceleration acceleration : {Acceleration::diffusion, Acceleration::none}) {
      SolveOptions options = tight_options();
      options.method = method;
      options.acceleration = acceleration;
      options.max_sweeps = 2000;
      const Solution solution = solve(problem, directions_ldfe_sq(1), options);
      ASSERT_TRUE(solution.converged());
      for (const Balance& balance : balances(problem, solution)) EXPECT_LT(std::abs(balance.residual), 1e-8);
      if (first.fluence.empty()) first = solution;
      EXPECT_LT(largest_difference(solution.fluence, first.fluence), 1e-8);
      // Diffusion knows what glossy walls send back.
      if (method == Method::gmres && acceleration == Acceleration::diffusion) {
        EXPECT_LT(solution.convergence[0].sweeps, 40);
      }
    }
}

// What a lamp on one wall brings to another is what the other would bring to it.
TEST(GlossyWalls, LightGoesBothWays) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const auto at_wall = [&](const std::string& lamp, const std::string& receiver) {
    std::vector<Wall> walls;
    std::size_t number = 0;
    for (const std::string& name : mesh.wall_names()) {
      walls.push_back(name == "zmin" ? glossy_wall(1, 0, 0.1, std::make_shared<Phong>(0.8, 20))
                                     : uniform_wall(1, name == lamp ? 1 : 0, 0, 0));
      walls.back().name = name;
      if (name == receiver) number = walls.size() - 1;
    }
    const Problem problem(mesh, {}, {uniform_medium(1, 0.1, 0.3, 0)}, walls);
    return wall_powers(problem, solved(problem))[number][0].incoming;
  };
  // Discrete light is reciprocal but for what upwind cells do.
  EXPECT_NEAR(at_wall("xmin", "zmax"), at_wall("zmax", "xmin"), 0.01 * at_wall("zmax", "xmin"));
}

// A smooth wall may lie askew, where no mirrored ordinates are; the energy is kept there too.
TEST(GlossyWalls, MayLieAskew) {
  const TetrahedralMesh mesh = moved_mesh(cube_mesh(3e-2), [](const Vec3& x) {
    return Vec3(x.x() + 0.3 * x.z(), x.y() - 0.2 * x.z(), x.z() + 0.1 * x.x());
  });
  const Problem problem =
      uniform_problem(mesh, uniform_medium(1, 0.1, 0.2, 1),
                      glossy_wall(1, 0, 0, std::make_shared<Microfacets>(0.9, 0.05, FacetFresnel::constant)));
  const Solution solution = solved(problem);
  ASSERT_TRUE(solution.converged());
  EXPECT_LT(std::abs(balances(problem, solution)[0].residual), 1e-8);
}

}  // namespace
}  // namespace etendue::glossy_walls_test
