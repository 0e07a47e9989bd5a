// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Photons in media that scatter by a formula of both directions.
#include "solver/photons/sampling/kernel_sampler.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "solver/angular/sets/direction_set.h"
#include "solver/materials/kernels/kernel_formula.h"
#include "solver/photons/solve/probe_histories.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/solution/balance.h"
#include "tests/solver/photons/solve/photon_samples.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::kernel_sampler_test {
namespace {

using std::numbers::pi;

KernelFormula kernel_of(const std::string& text, bool reciprocal = false) {
  KernelFormula kernel;
  kernel.formula = std::make_shared<const Expression>(text, kernel_variables());
  kernel.reciprocal = reciprocal;
  return kernel;
}

// Henyey and Greenstein's function for g, times 2.
std::string henyey_greenstein(const std::string& g) {
  return "2*(1-(" + g + ")^2)/(4*pi*(1+(" + g + ")^2-2*(" + g + ")*(wx*vx+wy*vy+wz*vz))^1.5)";
}

Medium scattering_by(const KernelFormula& kernel, double absorption, double emission) {
  Medium medium = uniform_medium(1, absorption, mean_scattering(kernel), emission);
  medium.directional = {kernel};
  return medium;
}

void expect_furnace(const Problem& problem, double radiance) {
  const PhotonSolution found = solved(problem, 10000);
  EXPECT_NEAR(mean_square_off(found, radiance), 1, 0.3);
  EXPECT_LT(found.report.error[0], 0.12);
  EXPECT_TRUE(found.solution.notes.empty());
}

// Means of what is drawn are those of the kernel: one that prefers the axis, one with its peak in a mirror.
TEST(KernelSampler, DrawsWhereTheKernelScatters) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const DirectionSet set = directions_product(64);
  for (const char* text : {"(1 + wz*wz)*(1 + vz*vz)", "0.1 + exp(-8*((vx-wx)^2 + (vy-wy)^2 + (vz+wz)^2))",
                           "max(0, wx*vx+wy*vy+wz*vz)*(1 + 0.9*vx)"}) {
    const KernelFormula kernel = kernel_of(text);
    const KernelSampler sampler(kernel, mesh, 0);
    EXPECT_EQ(sampler.meeting_rate(), 0);
    const Vec3 before = Vec3(0.6, -0.3, 0.7).normalized();
    double total = 0;
    Vec3 exact = Vec3::Zero(), mean = Vec3::Zero(), square = Vec3::Zero();
    for (std::int32_t m = 0; m < set.count(); ++m) {
      const Vec3& after = set.direction(OrdinateIndex(m));
      const double weight = set.weight(OrdinateIndex(m)) * kernel.at(before, after);
      total += weight;
      exact += weight * Vec3(after.x(), after.z(), after.z() * after.z());
    }
    constexpr int count = 40000;
    for (int n = 0; n < count; ++n) {
      RandomStream stream(5, static_cast<std::uint64_t>(n), RandomUse::flight);
      DrawnNumbers random(stream);
      const Vec3 after = sampler.scattered(CellIndex(0), before, random);
      const Vec3 value(after.x(), after.z(), after.z() * after.z());
      mean += value / count;
      square += value.cwiseAbs2() / count;
    }
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(mean[i], exact[i] / total, 4 * std::sqrt((square[i] - mean[i] * mean[i]) / count) + 1e-3)
          << text;
    EXPECT_EQ(sampler.beyond_bound().first, 0) << text;
  }
}

// A reciprocal kernel takes out of each direction what it brings into it.
TEST(KernelSampler, KernelsKeepAFurnace) {
  const TetrahedralMesh mesh = cube_mesh(0.03);
  const Wall wall = uniform_wall(1, 0.6, 0.4, 0);
  expect_furnace(uniform_problem(mesh, scattering_by(kernel_of("0.2*(1 + wz*wz)*(1 + vz*vz)"), 0, 0), wall),
                 1);
  KernelFormula taken = kernel_of("0.1*(1 + wz*wz)*(1 + vz*vz)", true);
  taken.extinction = 4;
  Medium medium = scattering_by(taken, 0, 0);
  medium.absorption = {Coefficient(4 - mean_scattering(taken))};
  // What scattering leaves of the extinction: 4/3 pi 0.1 4 (1 + wz^2).
  medium.emission_by_direction = {AngularFormula("4 - 0.1*16/3*pi*(1 + wz*wz)")};
  const Problem problem = uniform_problem(mesh, medium, wall);
  expect_furnace(problem, 1);
  const CellLocator locator(mesh);
  const auto seen = walk_back_from({{Vec3(0.4, 0.5, 0.2), {}}}, problem, locator, {4000, 1, 2});
  EXPECT_NEAR(seen[0][0].fluence.value, 4 * pi, 3 * seen[0][0].fluence.error);
  // One that depends on the place in another way in each direction.
  const KernelFormula varied = kernel_of(henyey_greenstein("0.8*x"));
  EXPECT_GT(KernelSampler(varied, mesh, 0).meeting_rate(), 2);
  expect_furnace(uniform_problem(mesh, scattering_by(varied, 0.5, 0.5), wall), 1);
}

// A formula that is Henyey and Greenstein's reflects as the phase function does, and one whose g is that of
// the place where it is even too.
TEST(KernelSampler, FormulasOfAPhaseFunctionAreOne) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 1));
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (mesh.wall_names()[w] == "zmin") walls[w] = uniform_wall(1, 1, 0, 0);
    if (mesh.wall_names()[w] == "zmax") walls[w] = uniform_wall(1, 0, 0, 0);
  }
  const auto absorbed = [&](const Medium& medium) {
    const Problem problem(mesh, {}, {medium}, walls);
    const PhotonSolution found = solved(problem, 20000, [&](const Solution& batch) {
      const Balance balance = balances(problem, batch)[0];
      return std::vector<double>{balance.absorbed, balance.residual};
    });
    EXPECT_LT(std::abs(found.sums.derived.mean(1)), 2e-3);
    return Estimate{found.sums.derived.mean(0), found.sums.derived.error(0)};
  };
  const Estimate exact = absorbed(uniform_medium(1, 0.5, 2, 0, PhaseHenyeyGreenstein{0.7}));
  for (const std::string g : {"0.7", "0.7 + 0*x", "(z < 2 ? 0.7 : z)"}) {
    const Estimate found = absorbed(scattering_by(kernel_of(henyey_greenstein(g)), 0.5, 0));
    EXPECT_NEAR(found.value, exact.value, 3 * std::hypot(found.error, exact.error)) << g;
    EXPECT_LT(found.error, 0.01 * found.value);
  }
}

TEST(KernelSampler, ThreadsDoNotChangeABit) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Medium medium = scattering_by(kernel_of(henyey_greenstein("0.5*x")), 0.5, 1);
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0.1, 0.5, 0.3));
  EXPECT_EQ(solved(problem, 1000, {}, 1).sums.packed(), solved(problem, 1000, {}, 3).sums.packed());
}

// Backwards such light would scatter by another kernel.
TEST(KernelSampler, ProbesDoNotGoBackUnlessItIsReciprocal) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Wall wall = uniform_wall(1, 1, 0, 0);
  for (const bool reciprocal : {false, true}) {
    const Medium medium = scattering_by(kernel_of("0.2 + 0*wx", reciprocal), 1, 0);
    const Problem problem = uniform_problem(mesh, medium, wall);
    EXPECT_EQ(can_walk_back(problem), reciprocal);
  }
}

TEST(KernelSampler, RefusesNegativeKernelsWithTheDirections) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  Medium medium = uniform_medium(1, 1, 1, 0);
  medium.origin = {"case.toml", 7, "media.fog"};
  medium.directional = {kernel_of("0.1 + vz")};
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 1, 0, 0));
  const std::string refusal = refusal_of(problem);
  EXPECT_NE(refusal.find("case.toml:7: media.fog.kernel: the kernel is -"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace etendue::kernel_sampler_test
