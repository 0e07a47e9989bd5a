// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>

#include <etendue/etendue.h>

#include "app/write/image/image_files.h"
#include "tests/support/checkout.h"

namespace etendue::library_test {
namespace {

const std::filesystem::path small_case = test::checkout("tests/app/api/small_case.toml");
const Case::Overrides by_photons = {"solve.method=\"photons\"", "solve.photons=20000",
                                    "solve.probe_photons=2000"};
const Case::Overrides by_radiosity = {"solve.method=\"radiosity\"", "media.air.absorption=0",
                                      "media.air.scattering=0", "media.smoke.absorption=0",
                                      "media.smoke.scattering=0"};

std::filesystem::path scratch(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "etendue-library" / name;
  std::filesystem::remove_all(folder);
  return folder;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream) << file;
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

/// The folder of results that the command writes of the small case.
std::filesystem::path run_by_command(const std::string& name, const Case::Overrides& overrides) {
  const std::filesystem::path folder = scratch(name);
  std::vector<std::string> arguments = {
      "run", small_case.string(), "--output", folder.string(), "--progress", "none", "--no-estimate"};
  for (const std::string& change : overrides) arguments.insert(arguments.end(), {"--set", change});
  std::ostringstream out, err;
  EXPECT_EQ(run_command(arguments, out, err), 0) << err.str();
  return folder;
}

void expect_files_of_the_command(const std::string& name, const Case::Overrides& overrides,
                                 const std::vector<std::string>& files) {
  const std::filesystem::path expected = run_by_command(name + "-command", overrides);
  const std::filesystem::path written = scratch(name);
  const Solution solution = solve(Case::from_file(small_case, overrides));
  EXPECT_TRUE(solution.converged());
  solution.write(written);
  ASSERT_FALSE(files.empty());
  for (const std::string& file : files)
    EXPECT_EQ(bytes_of(written / file), bytes_of(expected / file)) << file;
  const Image image = solution.render("front");
  EXPECT_EQ(png_bytes({image.width, image.height}, image.srgb), bytes_of(expected / "front.png"));
}

TEST(Library, SolvesByOrdinatesToTheBitAsTheCommandDoes) {
  expect_files_of_the_command(
      "ordinates", {},
      {"fields.vtu", "walls.vtp", "probes.csv", "sensors.csv", "walls.csv", "regions.csv", "history.csv"});
}

TEST(Library, SolvesByPhotonsToTheBitAsTheCommandDoes) {
  expect_files_of_the_command("photons", by_photons,
                              {"fields.vtu", "walls.vtp", "probes.csv", "walls.csv", "regions.csv"});
}

TEST(Library, SolvesByRadiosityToTheBitAsTheCommandDoes) {
  expect_files_of_the_command(
      "radiosity", by_radiosity,
      {"fields.vtu", "walls.vtp", "probes.csv", "sensors.csv", "walls.csv", "regions.csv"});
}

TEST(Library, ReadsOutHaveTheirShapes) {
  const Solution solution = solve(Case::from_file(small_case));
  const auto cells = static_cast<std::size_t>(solution.mesh().cell_count());
  const auto faces = static_cast<std::size_t>(solution.mesh().boundary_face_count());
  ASSERT_GT(cells, 100U);
  EXPECT_EQ(solution.bands(), (std::vector<std::string>{"red", "blue"}));
  EXPECT_EQ(solution.fluence().size(), cells * 4 * 2);
  EXPECT_EQ(solution.net_flux().size(), cells * 4 * 3 * 2);
  EXPECT_EQ(solution.irradiance().size(), faces * 3 * 2);
  EXPECT_EQ(solution.exitance().size(), faces * 3 * 2);
  EXPECT_EQ(solution.mesh().cells().size(), cells * 4);
  EXPECT_EQ(solution.mesh().boundary_faces().size(), faces * 3);
  EXPECT_EQ(solution.walls().size(), solution.mesh().wall_names().size() * 2);
  EXPECT_EQ(solution.regions().size(), 4U);
  EXPECT_EQ(solution.probes().size(), 4U);
  EXPECT_FALSE(solution.sensors().empty());
  ASSERT_EQ(solution.balances().size(), 2U);
  for (const BandBalance& balance : solution.balances()) {
    const double sent = balance.emitted + balance.inflow;
    EXPECT_NEAR(balance.residual, (sent - balance.absorbed - balance.outflow) / sent, 1e-14);
    EXPECT_LT(std::abs(balance.residual), 0.01);  // solve.balance_tolerance
  }
  for (const BandIteration& band : solution.iterations()) EXPECT_TRUE(band.converged && band.sweeps > 1);
}

TEST(Library, FluenceAtPointsIsThatOfProbesAndNanOutside) {
  const Solution solution = solve(Case::from_file(small_case));
  const std::vector<double> at = solution.fluence_at(std::array{0.4, 0.5, 0.1, 9.0, 9.0, 9.0, 1.0, 0.7, 0.5});
  const std::vector<ProbeReading> probes = solution.probes();
  ASSERT_EQ(at.size(), 6U);
  ASSERT_EQ(probes.size(), 4U);
  EXPECT_EQ(at[0], probes[0].fluence);
  EXPECT_EQ(at[1], probes[1].fluence);
  EXPECT_TRUE(std::isnan(at[2]) && std::isnan(at[3]));
  EXPECT_EQ(at[4], probes[2].fluence);
  EXPECT_EQ(at[5], probes[3].fluence);
  EXPECT_THROW(solution.fluence_at(std::array{1.0, 2.0}), InputError);
}

TEST(Library, NamesEveryFaultOfACaseWithItsLine) {
  try {
    Case::from_text("[media.air]\nabsorption = -1\nscatering = 2\n", "room.toml");
    FAIL();
  } catch (const InputError& error) {
    ASSERT_GE(error.faults().size(), 2U);
    EXPECT_EQ(error.faults().front().file, "room.toml");
    EXPECT_NE(std::string(error.what()).find("room.toml:2: media.air.absorption = -1"), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("room.toml:3: "), std::string::npos) << error.what();
  }
  EXPECT_THROW(Case::from_file("/nowhere/case.toml"), FileError);
  EXPECT_THROW(solve(Case::from_file(small_case)).render("back"), InputError);
}

TEST(Library, EndsWhereItIsAskedTo) {
  const Case input = Case::from_file(small_case);
  const Mesh mesh = input.mesh();
  EXPECT_THROW(solve(input, mesh, {.stop = [] { return true; }}), Stopped);
  std::vector<std::string> stages;
  const Solution half = solve(input, mesh, {.progress = [&](const Progress& progress) {
                                stages.push_back(progress.stage);
                                return progress.sweep < 2;
                              }});
  EXPECT_FALSE(half.converged());
  ASSERT_GE(stages.size(), 3U);
  EXPECT_EQ(stages.front(), "setting up");
  EXPECT_NE(std::ranges::find(stages, "sweeps"), stages.end());
}

TEST(Library, EndsWithinAnyMethod) {
  for (const auto& [overrides, stage] :
       {std::pair(Case::Overrides(), "sweeps"), std::pair(by_photons, "photons"),
        std::pair(by_radiosity, "light from wall to wall")}) {
    std::atomic<bool> begun = false;
    const SolveSettings settings{
        .progress = [&](const Progress& progress) { return begun = progress.stage == stage, true; },
        .stop = [&] { return begun.load(); }};
    EXPECT_THROW(solve(Case::from_file(small_case, overrides), settings), Stopped) << stage;
    EXPECT_TRUE(begun);
  }
}

TEST(Library, SolvesInTwoThreadsAtOnce) {
  const Case first = Case::from_file(small_case);
  const Case second = Case::from_file(small_case, {"mesh.edge_length=0.6", "walls.lamp.radiance=[1, 5]"});
  const std::array<Solution, 2> alone = {solve(first), solve(second)};
  std::vector<Solution> together(2, alone[0]);
  std::thread other([&] { together[1] = solve(second); });
  together[0] = solve(first);
  other.join();
  for (const std::size_t i : {0U, 1U}) {
    ASSERT_EQ(together[i].fluence().size(), alone[i].fluence().size());
    EXPECT_TRUE(std::ranges::equal(together[i].fluence(), alone[i].fluence()));
  }
}

TEST(Library, MakesMeshesFromArraysAndRefusesWrongOnes) {
  const std::array points = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  std::array<std::int32_t, 4> tetrahedra = {0, 1, 2, 3};
  const std::array<std::int32_t, 12> triangles = {0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3};
  const std::array<std::int32_t, 4> walls = {0, 1, 1, 1};
  MeshArrays arrays{.points = points, .tetrahedra = tetrahedra, .triangles = triangles, .walls = walls};
  arrays.wall_names = {"floor", "rest"};
  const Mesh mesh = Mesh::from_arrays(arrays);
  ASSERT_EQ(mesh.boundary_face_count(), 4);
  EXPECT_EQ(std::ranges::count(mesh.face_walls(), 0), 1);
  EXPECT_NEAR(mesh.volumes().front(), 1.0 / 6, 1e-15);
  EXPECT_EQ(mesh.region_names(), std::vector<std::string>{"medium"});
  const Case input =
      Case::from_text("[media.medium]\nabsorption = 1\n[walls.floor]\nradiance = 2\n[walls.rest]\n", mesh);
  EXPECT_TRUE(solve(input).converged());
  EXPECT_THROW(solve(Case::from_text("[media.medium]\n[walls.ceiling]\n[walls.\"*\"]\n", mesh)), InputError);
  tetrahedra[2] = 4;
  EXPECT_THROW(Mesh::from_arrays(arrays), InputError);
  tetrahedra[2] = 2;
  arrays.walls = arrays.walls.first(3);
  EXPECT_THROW(Mesh::from_arrays(arrays), InputError);
}

TEST(Library, ChecksACaseOnAMesh) {
  const Case good = Case::from_file(small_case);
  const Mesh mesh = good.mesh();
  EXPECT_NO_THROW(check(good, mesh));
  const Case again = Case::from_text(bytes_of(small_case), mesh, small_case);
  EXPECT_EQ(again.resolved_toml(), good.resolved_toml());
  EXPECT_EQ(again.mesh().cell_count(), mesh.cell_count());
  EXPECT_THROW(check(Case::from_file(small_case, {"probe[0].points=[[9, 9, 9]]"}), mesh), InputError);
}

TEST(Library, HasAVersion) { EXPECT_EQ(version().find('.'), 1U); }

}  // namespace
}  // namespace etendue::library_test
