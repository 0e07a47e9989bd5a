// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/solve/solve_photons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "base/parallel/instruction_set.h"
#include "base/quadrature/cell_rule.h"
#include "solver/problem/lights/lamp_shape.h"
#include "solver/solution/balance.h"
#include "tests/solver/photons/solve/photon_samples.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::solve_photons_test {
namespace {

using std::numbers::pi;

// Everything at one temperature: u = B everywhere, whatever the medium and the walls do.
TEST(SolvePhotons, FurnaceIsEverywhereTheSame) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const double radiance = 2;
  const Problem problem =
      uniform_problem(mesh, uniform_medium(1, 0.7, 1.3, 0.7 * radiance, PhaseHenyeyGreenstein{0.5}),
                      uniform_wall(1, 0.5 * radiance, 0.3, 0.2));
  const PhotonSolution found = solved(problem, 40000);
  EXPECT_NEAR(mean_square_off(found, radiance), 1, 0.25);
  EXPECT_LT(found.report.error[0], 0.06);
  EXPECT_EQ(found.report.lost, 0);
}

// With a black cold enclosure nothing is random but the roulette.
TEST(SolvePhotons, BalanceCloses) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.5, 2, 1), uniform_wall(1, 0, 0, 0));
  const PhotonSolution found = solved(problem, 4000);
  const Balance balance = balances(problem, found.solution)[0];
  EXPECT_NEAR(balance.emitted, 4 * pi, 1e-12);
  EXPECT_LT(std::abs(balance.residual), 1e-3);
}

TEST(SolvePhotons, ThreadsDoNotChangeABit) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = uniform_problem(mesh, uniform_medium(2, 0.5, 2, 1), uniform_wall(2, 0.1, 0.5, 0.3));
  const PhotonSolution one = solved(problem, 3000, {}, 1), three = solved(problem, 3000, {}, 3);
  EXPECT_EQ(one.solution.fluence, three.solution.fluence);
  EXPECT_EQ(one.sums.packed(), three.sums.packed());
}

TEST(SolvePhotons, InstructionSetsDoNotChangeABit) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = uniform_problem(mesh, uniform_medium(2, 0.5, 2, 1, PhaseHenyeyGreenstein{0.4}),
                                          uniform_wall(2, 0.1, 0.5, 0.3));
  struct AnyAfterwards {
    ~AnyAfterwards() { unsetenv("ETENDUE_ISA"); }
  } any_afterwards;
  setenv("ETENDUE_ISA", "baseline", 1);
  const PhotonSolution plain = solved(problem, 3000);
  for (const char* isa : {"avx2", "avx512"}) {
    if (!has_instruction_set(isa)) continue;
    setenv("ETENDUE_ISA", isa, 1);
    const PhotonSolution wide = solved(problem, 3000);
    EXPECT_EQ(wide.sums.packed(), plain.sums.packed()) << isa;
  }
  setenv("ETENDUE_ISA", "mmx", 1);
  EXPECT_THROW(solved(problem, 10), InputError);
}

// A beam that enters by z = 0 into a medium that only absorbs: fluence E exp(-a z) on every depth, its mean
// over a cell by the histories that meet it, and a net flux along z that is the same.
TEST(SolvePhotons, BeamFadesInAnAbsorber) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  const double absorption = 3;
  const auto& names = mesh.wall_names();
  const int floor = static_cast<int>(std::ranges::find(names, "zmin") - names.begin());
  const Problem problem(mesh, {}, {uniform_medium(1, absorption, 0, 0)},
                        std::vector<Wall>(names.size(), uniform_wall(1, 0, 0, 0)), AngularSpace::sphere,
                        {{"beam", BeamLight{Vec3::UnitZ(), {2}, {floor}}, {}}});
  const PhotonSolution found = solved(problem, 20000);
  const Balance balance = balances(problem, found.solution)[0];
  EXPECT_NEAR(balance.inflow, 2, 1e-12);
  EXPECT_NEAR(balance.outflow, 2 * std::exp(-absorption), 1e-12);
  EXPECT_NEAR(balance.absorbed, 2 * (1 - std::exp(-absorption)), 1e-12);
  double square = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    double mean = 0;
    for (const CellRulePoint& node : cell_rule()) {
      double z = 0;
      for (std::size_t i = 0; i < 4; ++i)
        z += node.barycentric[i] * mesh.point(VertexIndex(mesh.vertices(CellIndex(c))[i])).z();
      mean += node.weight * 2 * std::exp(-absorption * z);
    }
    const auto at = static_cast<std::size_t>(c);
    square += std::pow((found.sums.cell_means.mean(at) - mean) / found.sums.cell_means.error(at), 2);
    EXPECT_NEAR(found.solution.net_flux[12 * at + 2], found.solution.fluence[4 * at], 1e-12);
  }
  EXPECT_NEAR(square / mesh.cell_count(), 1, 0.25);
}

// A point in void: through each wall of a cube around it a sixth of its power.
TEST(SolvePhotons, PointLightsAllSidesOfACube) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  PointLight lamp;
  lamp.position = Vec3(0.5, 0.5, 0.5);
  lamp.power = {6};
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0)},
                        std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0)),
                        AngularSpace::sphere, {{"lamp", lamp, {}}});
  const PhotonSolution found = solved(problem, 40000);
  for (const auto& wall : wall_powers(problem, found.solution)) EXPECT_NEAR(wall[0].incoming, 1, 0.03);
}

// The same from the middle of the ceiling: all of it goes down, to the floor the part of a cosine-free lamp
// that it sees, (2 / pi) asin(1 / 5) of the half space (a square of side 1 from the distance 1).
TEST(SolvePhotons, LampOnTheCeilingSendsItsWholePowerDown) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  PointLight lamp;
  lamp.position = Vec3(0.5, 0.5, 1);
  lamp.power = {6};
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, 0));
    walls.back().name = name;
  }
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0)}, walls, AngularSpace::sphere,
                        {{"lamp", lamp, {}}});
  const PhotonSolution found = solved(problem, 40000);
  const auto powers = wall_powers(problem, found.solution);
  double all = 0;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    all += powers[w][0].incoming;
    if (walls[w].name == "zmax") {
      EXPECT_EQ(powers[w][0].incoming, 0);
    }
    if (walls[w].name == "zmin") {
      EXPECT_NEAR(powers[w][0].incoming, 6 * 2 / pi * std::asin(0.2), 0.05);
    }
  }
  EXPECT_NEAR(all, 6, 1e-9);
}

// The same numbers whether histories are walked in one run or added to those of an earlier one, but for the
// shares of the power that batches of other sizes begin in.
// A lamp in the middle of an empty cube that shines by the azimuth about -z.
TEST(SolvePhotons, LampWithPlanesLightsEachSideByItsShape) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  PointLight lamp;
  lamp.position = {0.5, 0.5, 0.5};
  lamp.power = {1};
  lamp.axis = -Vec3::UnitZ();
  lamp.angle = {0, pi / 2, pi};
  lamp.plane = {0, pi / 2, pi, 1.5 * pi, 2 * pi};
  lamp.intensity = {1, 6, 1, 1, 3, 1, 1, 0, 1, 1, 1, 1, 1, 6, 1};
  const auto& names = mesh.wall_names();
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0)},
                        std::vector<Wall>(names.size(), uniform_wall(1, 0, 0, 0)), AngularSpace::sphere,
                        {{"lamp", lamp, {}}});
  const auto powers = wall_powers(problem, solved(problem, 40000).solution);
  const int steps = 400;
  for (std::size_t w = 0; w < names.size(); ++w) {
    Vec3 out = Vec3::Zero();
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
      if (mesh.wall(FaceIndex(f)) == static_cast<int>(w)) out = mesh.area_normal(FaceIndex(f)).normalized();
    const Vec3 u = out.unitOrthogonal(), v = out.cross(u);
    double share = 0;
    for (int i = 0; i < steps; ++i)
      for (int k = 0; k < steps; ++k) {
        const Vec3 place = out + ((2 * i + 1.0) / steps - 1) * u + ((2 * k + 1.0) / steps - 1) * v;
        share += 4.0 / (steps * steps) * lamp_shape(lamp, place.normalized()) / std::pow(place.norm(), 3);
      }
    share /= integral_of_lamp_shape(lamp);
    EXPECT_NEAR(powers[w][0].incoming, share, 4 * std::sqrt(share / 40000)) << names[w];
  }
}

TEST(SolvePhotons, HistoriesAddToThoseOfAnEarlierRun) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.5, 2, 1), uniform_wall(1, 0, 0.2, 0));
  const CellLocator locator(mesh);
  PhotonOptions options;
  options.photons = 64 * 50;
  const PhotonSolution first = solve_photons(problem, locator, options);
  const PhotonSums saved = PhotonSums::unpacked(first.solution.state.photons);
  EXPECT_EQ(saved.packed(), first.sums.packed());
  options.initial = &saved;
  const PhotonSolution both = solve_photons(problem, locator, options);
  EXPECT_EQ(both.sums.histories, 2 * first.sums.histories);
  EXPECT_EQ(both.sums.fluence.batches(), 128);
  EXPECT_NEAR(both.report.error[0] / first.report.error[0], std::sqrt(0.5), 0.1);
  EXPECT_NE(both.solution.fluence, first.solution.fluence);
}

TEST(SolvePhotons, RefusesSumsThatAreDamagedOrOfAnotherMesh) {
  const TetrahedralMesh mesh = cube_mesh(0.05), other = cube_mesh(0.5);
  const Medium medium = uniform_medium(1, 0.5, 2, 1);
  PhotonOptions options;
  options.photons = 64;
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0, 0.2, 0));
  std::vector<double> packed = solve_photons(problem, CellLocator(mesh), options).sums.packed();
  const PhotonSums sums = PhotonSums::unpacked(packed);
  options.initial = &sums;
  const Problem another = uniform_problem(other, medium, uniform_wall(1, 0, 0.2, 0));
  EXPECT_THROW(solve_photons(another, CellLocator(other), options), InputError);
  packed[0] = -1;  // histories
  EXPECT_THROW(PhotonSums::unpacked(packed), InputError);
  packed[0] = sums.packed()[0];
  packed[2] = std::numeric_limits<double>::quiet_NaN();  // batches of the fluence
  EXPECT_EQ(PhotonSums::unpacked(packed).fluence.size(), 0u);
}

TEST(SolvePhotons, StopsAtTheErrorThatWasAskedFor) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.5, 2, 1), uniform_wall(1, 0, 0.2, 0));
  const CellLocator locator(mesh);
  PhotonOptions options;
  options.until = 0.02;
  const PhotonSolution found = solve_photons(problem, locator, options);
  EXPECT_LE(found.report.error[0], 0.02);
  EXPECT_GT(found.report.error[0], 0.01);
  EXPECT_TRUE(found.solution.converged());
  options.photons = 1000;
  EXPECT_FALSE(solve_photons(problem, locator, options).solution.converged());
}

/// Matter of a million free paths that loses next to nothing: a history of its middle takes minutes.
Medium endless_matter() { return uniform_medium(1, 1e-9, 1e6, 1); }

TEST(SolvePhotons, StopsWithinABatchOfThickMatter) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Problem problem = uniform_problem(mesh, endless_matter(), uniform_wall(1, 0, 1, 0));
  PhotonOptions options;
  options.threads = 2;
  int looks = 0;
  const auto begun = std::chrono::steady_clock::now();
  const PhotonSolution found =
      solve_photons(problem, CellLocator(mesh), options, [&](const PhotonProgress& progress) {
        ++looks;
        EXPECT_EQ(progress.batches, 0);
        return progress.seconds > 0.3 ? SolveControl::stop : SolveControl::proceed;
      });
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(2));
  EXPECT_GT(looks, 2);
  EXPECT_TRUE(found.solution.interrupted);
  EXPECT_EQ(found.sums.histories, 0U);
  EXPECT_TRUE(found.solution.fluence.empty());
}

TEST(SolvePhotons, LeavesWholeBatchesWhereItIsStopped) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.5, 2, 1), uniform_wall(1, 0.1, 0.5, 0));
  const CellLocator locator(mesh);
  std::vector<std::vector<double>> sums;
  for (const int threads : {1, 3}) {
    PhotonOptions options;
    options.photons = 64 * 3000;
    options.threads = threads;
    const PhotonSolution found = solve_photons(problem, locator, options, [](const PhotonProgress& progress) {
      return progress.batches < 5 ? SolveControl::proceed : SolveControl::stop;
    });
    EXPECT_TRUE(found.solution.interrupted);
    EXPECT_EQ(found.sums.fluence.batches(), 5);
    EXPECT_EQ(found.sums.histories, 5 * 3000U);
    sums.push_back(found.sums.packed());
  }
  EXPECT_EQ(sums[0], sums[1]);
}

// A mirror of its half: the same as the whole.
TEST(SolvePhotons, MirrorsStandForTheOtherHalf) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names())
    walls.push_back(name == "zmin" ? uniform_wall(1, 1, 0, 0)
                                   : uniform_wall(1, 0, 0, name == "zmax" ? 0 : 1));
  // Mirrors on four sides: a slab without scattering passes 2 E_3(a) of the light from a Lambertian side.
  const Problem problem(mesh, {}, {uniform_medium(1, 1, 0, 0)}, walls);
  const Balance balance = balances(problem, solved(problem, 40000).solution)[0];
  const double third_exponential_integral = 0.1096919669;  // E_3(1), Abramowitz and Stegun, table 5.4
  EXPECT_NEAR(balance.outflow, pi * 2 * third_exponential_integral, 0.004);
  EXPECT_LT(std::abs(balance.residual), 1e-3);
}

TEST(SolvePhotons, RefusesKernelsAsMatrices) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  Medium medium = uniform_medium(1, 1, 1, 0);
  medium.origin = {"case.toml", 7, "media.fog"};
  medium.directional = {KernelMatrix{}};
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0));
  const std::string refusal = refusal_of(problem);
  EXPECT_NE(refusal.find("case.toml:7: media.fog.kernel: is a matrix"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace etendue::solve_photons_test
