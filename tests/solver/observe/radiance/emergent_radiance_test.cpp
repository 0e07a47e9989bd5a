// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Pictures of half-spaces that scatter isotropically, against Chandrasekhar's H
// (validation/reference/chandrasekhar_h.csv; its origin stands there).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>
#include <sstream>
#include <string>

#include "solver/observe/camera/picture.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/observe/sensors/block_mesh.h"
#include "tests/solver/transport/sample_problems.h"
#include "tests/support/checkout.h"

namespace etendue::emergent_radiance_test {
namespace {

using std::numbers::pi;

/// H over mu, from the lines w, mu, H, …
std::map<double, double> chandrasekhar_h(double albedo) {
  std::ifstream file(test::checkout("validation/reference/chandrasekhar_h.csv"));
  std::map<double, double> table;
  for (std::string line; std::getline(file, line);) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream cells(line);
    double w = 0, mu = 0, h = 0;
    if (cells >> w >> mu >> h && w == albedo) table[mu] = h;
  }
  return table;
}

/// A column between mirrors, `fineness` times as fine as layers that grow from 1/100 to 1/2: what shines has
/// a logarithm at the surface, which equal cells would follow at less than order two.
TetrahedralMesh column(double depth, int fineness) {
  std::vector<double> heights = {0};
  for (double layer = 0.01; heights.back() < depth; layer = std::min(0.5, 1.1 * layer)) {
    const double top = heights.back();
    for (int i = 1; i <= fineness; ++i) heights.push_back(top + layer * i / fineness);
  }
  return block_mesh({std::vector<double>{0, 4}, {0, 4}, heights}, [](const Vec3&, const Vec3& outwards) {
    if (outwards.z() < -0.5) return "surface";
    return outwards.z() > 0.5 ? "bottom" : "side";
  });
}

/// A highly scattering medium magnifies what an iteration leaves.
SolveOptions converged() {
  SolveOptions options;
  options.tolerance = 1e-8;
  return options;
}

struct HalfSpace {
  HalfSpace(double albedo, double emission, int fineness, std::vector<Light> suns = {})
      // Twelve free paths let 6e-6 of a ray through; the bottom's cold is felt by e^-14 over 8 / sqrt(1 - w).
      : mesh(column(std::max(12.0, 8 / std::sqrt(1 - albedo)), fineness)),
        problem(mesh, {}, {uniform_medium(1, 1 - albedo, albedo, emission)}, walls(), AngularSpace::sphere,
                placed(std::move(suns))),
        directions(directions_double_gauss(8)),
        lights(problem),
        solution(solve_split(lights, directions, options)),
        scene(lights, directions, options, solution.state, 1) {}

  /// What a camera sees that looks in at the angle mu: one ray of its middle.
  double seen(double mu, int shafts = 0) const {
    Camera camera;
    camera.look_at = {2.1, 1.3, 0};
    camera.position = camera.look_at - Vec3(std::sqrt(1 - mu * mu), 0, mu);
    camera.up = Vec3::UnitY();
    camera.orthographic = 0.01;
    camera.pixels = {1, 1};
    camera.shafts = shafts;
    return take_picture(scene, camera, 1).radiance[0];
  }

  std::vector<Wall> walls() const {
    std::vector<Wall> found;
    for (const std::string& name : mesh.wall_names()) {
      found.push_back(uniform_wall(1, 0, 0, name == "side" ? 1 : 0));
      found.back().name = name;
    }
    return found;
  }
  std::vector<Light> placed(std::vector<Light> suns) const {
    const auto surface = std::ranges::find(mesh.wall_names(), "surface") - mesh.wall_names().begin();
    for (Light& sun : suns) std::get<BeamLight>(sun.kind).walls = {static_cast<int>(surface)};
    return suns;
  }

  TetrahedralMesh mesh;
  Problem problem;
  DirectionSet directions;
  SolveOptions options = converged();
  LightSetup lights;
  Solution solution;
  RayRadiance scene;
};

double largest_error(const HalfSpace& scene, double albedo, int shafts,
                     const std::function<double(double mu, double h)>& exact) {
  double largest = 0;
  for (const auto& [mu, h] : chandrasekhar_h(albedo))
    if (mu > 0) largest = std::max(largest, std::abs(scene.seen(mu, shafts) / exact(mu, h) - 1));
  return largest;
}

/// Of what an isothermal half-space sends out, I = B sqrt(1 - w) H(mu) (Chandrasekhar 1960, sec. 38).
double glow_error(double albedo, int fineness) {
  const HalfSpace hot(albedo, (1 - albedo) * 3, fineness);
  return largest_error(hot, albedo, 0, [&](double, double h) { return 3 * std::sqrt(1 - albedo) * h; });
}

/// Under a sun of irradiance E overhead, I = w E H(mu) H(1) / (4 pi (mu + 1)) (eq. III.123); with light that
/// scatters once between the vertices, or by rays from each cell.
std::array<double, 2> sunlit_errors(double albedo, int fineness) {
  const HalfSpace lit(albedo, 0, fineness, {{"sun", BeamLight{Vec3::UnitZ(), {2}, {}}, {}}});
  const double overhead = chandrasekhar_h(albedo).at(1);
  const auto exact = [&](double mu, double h) { return albedo * 2 * h * overhead / (4 * pi * (mu + 1)); };
  return {largest_error(lit, albedo, 0, exact), largest_error(lit, albedo, 3, exact)};
}

/// Below this other errors than those of the cells are seen: the bottom's, the table's, the directions'.
constexpr double not_of_cells = 3e-5;

// Within 3e-4, and a third of that with cells half as thick.
TEST(EmergentRadiance, OfAHotHalfSpaceIsExact) {
  for (const double albedo : {0.5, 0.9}) {
    ASSERT_GT(chandrasekhar_h(albedo).size(), 5U);
    const double coarse = glow_error(albedo, 1);
    EXPECT_LT(coarse, 3e-4) << albedo;
    EXPECT_LT(glow_error(albedo, 2), std::max(coarse / 3, not_of_cells)) << albedo;
  }
}

TEST(EmergentRadiance, OfAHalfSpaceInTheSunIsExact) {
  for (const double albedo : {0.5, 0.9}) {
    const auto coarse = sunlit_errors(albedo, 1), fine = sunlit_errors(albedo, 2);
    for (const std::size_t shafts : {0, 1}) {
      EXPECT_LT(coarse[shafts], 3e-4) << albedo << " " << shafts;
      EXPECT_LT(fine[shafts], std::max(coarse[shafts] / 3, not_of_cells)) << albedo << " " << shafts;
    }
  }
}

}  // namespace
}  // namespace etendue::emergent_radiance_test
