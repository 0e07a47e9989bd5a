// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Extended form factors: mirrors and glossy walls between patches.
#include "solver/radiosity/extended/extended_exchange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/materials/surfaces/microfacets.h"
#include "solver/materials/surfaces/phong.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/radiosity/exchange/exchange_matrix.h"
#include "solver/radiosity/form_factors/exchange_area.h"
#include "solver/solution/balance.h"
#include "tests/solver/radiosity/radiosity_samples.h"

namespace etendue::extended_exchange_test {
namespace {

using std::numbers::pi;

/// [band] of a wall that is not all like the others.
struct Finish {
  std::vector<double> diffuse, specular, radiance;
  std::vector<std::shared_ptr<const Reflectance>> glossy = {};
  double refractive_index = 1;
};

Problem room(const TetrahedralMesh& mesh, const std::map<std::string, Finish>& named, const Finish& other) {
  const std::size_t bands = other.diffuse.size();
  const Problem plain = empty_room(mesh, 0, "");
  std::vector<Medium> media(plain.media().begin(), plain.media().end());
  for (Medium& medium : media) {
    medium.absorption = medium.scattering = medium.emission = std::vector<Coefficient>(bands, Coefficient(0));
    medium.phase.assign(bands, PhaseIsotropic{});
  }
  std::vector<Wall> walls(plain.walls().begin(), plain.walls().end());
  for (Wall& wall : walls) {
    const auto found = named.find(wall.name);
    const Finish& finish = found == named.end() ? other : found->second;
    wall.diffuse = finish.diffuse;
    wall.specular = finish.specular;
    wall.radiance = finish.radiance;
    wall.glossy = finish.glossy;
    wall.refractive_index = finish.refractive_index;
  }
  Bands names;
  names.names.clear();
  for (std::size_t b = 0; b < bands; ++b) names.names.push_back("band" + std::to_string(b));
  return Problem(mesh, names, std::move(media), std::move(walls));
}

RadiosityOptions fine_options(int path_rays = 1024) {
  RadiosityOptions options;
  options.path_rays = path_rays;
  options.limits = {1e-12, 2000};
  options.threads = 1;
  return options;
}

FlatPatch behind_x(const FlatPatch& patch) {
  std::vector<TriangleCorners> triangles;
  for (TriangleCorners t : patch.triangles()) {
    for (Vec3& corner : t) corner[0] = -corner[0];
    std::swap(t[1], t[2]);
    triangles.push_back(t);
  }
  return FlatPatch(triangles);
}

/// Root mean square error of G_1 of a mirror at x = 0 against the closed form of images, of its root mean
/// square.
double error_of_images(int rays) {
  const TetrahedralMesh mesh = cube_mesh(0.03);
  const double shines = 0.8;
  const Problem problem = room(mesh, {{"xmin", {{0.1}, {shines}, {0}}}}, {{0.5}, {0}, {0}});
  const WallPatches patches = wall_patches(mesh, 0);
  const ExchangeMatrix straight(patches.patches, 1, 2);
  const ExtendedExchange extended(straight, problem, patches, Redirection::mirrors_and_lobes, rays);
  double error = 0, square = 0;
  for (std::size_t j = 0; j < extended.size(); ++j) {
    const std::vector<double> whole = extended.row(j), seen = straight.row(j);
    for (std::size_t k = 0; k < extended.size(); ++k) {
      const auto on_mirror = [&](std::size_t p) {
        return mesh.wall_names()[static_cast<std::size_t>(patches.walls[p])] == "xmin";
      };
      const double exact = on_mirror(j) || on_mirror(k)
                               ? 0
                               : shines * exchange_area(patches.patches[j], behind_x(patches.patches[k]));
      error += std::pow(whole[k] - seen[k] - exact, 2);
      square += exact * exact;
    }
  }
  return std::sqrt(error / square);
}

// A patch sees others behind a flat mirror where their images are; of itself too.
TEST(ExtendedExchange, OfAFlatMirrorIsThatOfImages) {
  const double coarse = error_of_images(256), fine = error_of_images(4096);
  // Sixteen times the rays: a quarter of the error. With 256 about one goes from a patch to another.
  EXPECT_LT(coarse, 0.7);
  EXPECT_LT(fine, coarse / 3.8);
}

TEST(ExtendedExchange, IsSymmetricAndKeepsAllLight) {
  const TetrahedralMesh mesh = room_with_crate(0.05);
  const auto red = std::make_shared<Phong>(0.5, 20.0);
  const auto blue = std::make_shared<Microfacets>(0.7, 0.4, FacetFresnel::schlick);
  const Problem problem = room(
      mesh,
      {{"zmin", {{0.1, 0.1}, {0.2, 0.1}, {0, 0}, {red, blue}}}, {"crate.zmax", {{0, 0}, {0.9, 0.6}, {0, 0}}}},
      {{0.5, 0.3}, {0, 0}, {1, 2}});
  const WallPatches patches = wall_patches(mesh, 0.5);
  ExchangeMatrix straight(patches.patches, 16, 2);
  straight.close(1e-13);
  ExtendedExchange extended(straight, problem, patches, Redirection::mirrors_and_lobes, 512);
  const ExtendedClosing closing = extended.close(1e-13);
  EXPECT_LT(closing.row_sum_mean, 0.04);
  EXPECT_LE(closing.closed_row_sum, 1e-13);
  // What had to be closed is the rays' own error: sixteen times as many leave a third of it at most.
  ExtendedExchange finer(straight, problem, patches, Redirection::mirrors_and_lobes, 8192);
  EXPECT_LT(finer.close(1e-13).row_sum_mean, closing.row_sum_mean / 3);
  // x G y = y G x, and times() has the rows of row().
  std::vector<double> x, y;
  for (std::size_t i = 0; i < 2 * extended.size(); ++i) {
    x.push_back(std::sin(3.0 * static_cast<double>(i)));
    y.push_back(std::cos(static_cast<double>(i)));
  }
  const std::vector<double> gx = extended.times(x), gy = extended.times(y);
  double xgy = 0, ygx = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xgy += x[i] * gy[i];
    ygx += y[i] * gx[i];
  }
  EXPECT_NEAR(xgy, ygx, 1e-12 * std::abs(xgy) + 1e-14);
  const std::size_t j = extended.size() / 2;
  const std::vector<double> row = extended.row(j);
  double sum = 0;
  for (std::size_t k = 0; k < extended.size(); ++k) sum += row[2 * k + 1] * y[2 * k + 1];
  EXPECT_NEAR(sum, gy[2 * j + 1], 1e-13);
  // What a patch sends arrives, and but for what is redirected it stays.
  std::vector<double> sent(x.size(), 0);
  sent[2 * j] = 1;
  sent[2 * j + 1] = 3;
  const std::vector<double> arriving = extended.times(sent), redirected = extended.redirected(sent, arriving);
  double stays[2] = {0, 0};
  for (std::size_t i = 0; i < arriving.size(); ++i) stays[i % 2] += arriving[i] - redirected[i];
  EXPECT_NEAR(stays[0], patches.patches[j].area(), 1e-12);
  EXPECT_NEAR(stays[1], 3 * patches.patches[j].area(), 1e-12);
}

TEST(ExtendedExchange, IsTheSameForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Problem problem =
      room(mesh, {{"zmin", {{0.1}, {0.2}, {0}, {std::make_shared<Phong>(0.5, 20.0)}}}}, {{0.5}, {0}, {1}});
  const WallPatches patches = wall_patches(mesh, 0);
  std::vector<double> first;
  for (const int threads : {1, 2, 3}) {
    const ExchangeMatrix straight(patches.patches, 1, threads);
    const ExtendedExchange extended(straight, problem, patches, Redirection::mirrors_and_lobes, 100);
    const std::vector<double> ones = extended.times(std::vector<double>(extended.size(), 1.0));
    if (first.empty()) first = ones;
    EXPECT_EQ(ones, first);
  }
}

// Walls that emit what they do not mirror, and mirrors that emit the rest: all is even, whatever the rays.
TEST(ExtendedRoom, AFurnaceWithMirrorsIsEven) {
  const TetrahedralMesh mesh = room_with_crate(0.05);
  const Problem problem = room(
      mesh, {{"zmin", {{0.2}, {0.3}, {0.5}}}, {"crate.xmax", {{0}, {0.9}, {0.1}}}, {"xmin", {{0}, {1}, {0}}}},
      {{0.6}, {0}, {0.4}});
  for (const RadiosityMethod method : {RadiosityMethod::gathering, RadiosityMethod::shooting,
                                       RadiosityMethod::direct, RadiosityMethod::hierarchical}) {
    RadiosityOptions options = fine_options(64);
    options.method = method;
    RadiosityRoom with_method(problem, options);
    const Solution solution = with_method.solve();
    ASSERT_EQ(solution.irradiance.size(), 3 * static_cast<std::size_t>(mesh.boundary_face_count()));
    ASSERT_EQ(solution.exitance.size(), 3 * static_cast<std::size_t>(mesh.boundary_face_count()));
    for (const double irradiance : solution.irradiance) ASSERT_NEAR(irradiance, pi, 1e-9);
    for (const double exitance : solution.exitance) ASSERT_NEAR(exitance, pi, 1e-9);
    // Points look over the mirrors along 64 rays: on the mean over some thousand points these know it well.
    ASSERT_EQ(solution.fluence.size(), 4 * mesh.volumes().size());
    double mean = 0;
    for (const double fluence : solution.fluence)
      mean += fluence / static_cast<double>(solution.fluence.size());
    EXPECT_NEAR(mean, 4 * pi, 0.005 * 4 * pi);
    EXPECT_LT(std::abs(balances(problem, solution)[0].residual), 1e-10);
  }
}

TEST(ExtendedRoom, AllSolutionsAreTheSame) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const Problem problem =
      room(mesh,
           {{"zmin", {{0.1, 0.2}, {0.3, 0.1}, {0, 0}, {nullptr, std::make_shared<Phong>(0.5, 20.0)}}},
            {"xmax", {{0, 0}, {0, 0}, {1, 2}}}},
           {{0.6, 0.4}, {0, 0}, {0, 0}});
  std::vector<double> irradiance, exitance;
  for (const RadiosityMethod method :
       {RadiosityMethod::direct, RadiosityMethod::gathering, RadiosityMethod::shooting}) {
    RadiosityOptions options = fine_options(64);
    options.method = method;
    const Solution solution = RadiosityRoom(problem, options).solve();
    for (const Balance& balance : balances(problem, solution)) EXPECT_LT(std::abs(balance.residual), 1e-10);
    if (irradiance.empty()) {
      irradiance = solution.irradiance;
      exitance = solution.exitance;
    }
    ASSERT_GT(irradiance.size(), 0);
    ASSERT_EQ(solution.irradiance.size(), irradiance.size());
    ASSERT_EQ(solution.exitance.size(), irradiance.size());
    for (std::size_t i = 0; i < irradiance.size(); ++i) {
      ASSERT_NEAR(solution.irradiance[i], irradiance[i], 1e-9);
      ASSERT_NEAR(solution.exitance[i], exitance[i], 1e-9);
    }
  }
}

// A small lamp above walls that redirect by the angle: no more than arrives anywhere, and not less than
// nothing.
TEST(ExtendedRoom, WhatIsRedirectedIsAPartOfWhatArrives) {
  const TetrahedralMesh mesh = cube_mesh(1e-3);
  const auto lobe = std::make_shared<Microfacets>(0.1, 0.2, FacetFresnel::schlick);
  const Problem problem =
      room(mesh,
           {{"zmin", {{0}, {0}, {0}, {}, 1.5}}, {"xmin", {{0}, {0}, {0}, {lobe}}}, {"zmax", {{0}, {0}, {1}}}},
           {{0.1}, {0}, {0}});
  RadiosityRoom with_floor(problem, fine_options(64));
  with_floor.solve();
  const RadiosityState& state = with_floor.solved();
  ASSERT_EQ(state.irradiance.size(), with_floor.patches().patches.size());
  ASSERT_EQ(state.redirected.size(), state.irradiance.size());
  for (std::size_t p = 0; p < state.irradiance.size(); ++p) {
    EXPECT_GE(state.redirected[p], -1e-6 * state.irradiance[p]) << p;
    EXPECT_LE(state.redirected[p], (1 + 1e-6) * state.irradiance[p]) << p;
  }
}

// Patches are cut for the light that is straight: not for the noise of rays over a mirror.
TEST(ExtendedRoom, AMirrorDoesNotCutPatches) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  std::size_t patches[2];
  for (const bool mirrored : {false, true}) {
    const Problem problem =
        room(mesh, {{"zmin", {{0.5}, {0}, {1}}}, {"xmin", {{mirrored ? 0 : 0.9}, {mirrored ? 0.9 : 0}, {0}}}},
             {{0.5}, {0}, {0}});
    RadiosityOptions options = fine_options(64);
    options.patch_size = 0.5;
    options.refinement = {0.3, 0.06};
    patches[mirrored ? 1 : 0] = RadiosityRoom(problem, options).report().patches;
  }
  EXPECT_LT(static_cast<double>(patches[1]), 1.3 * static_cast<double>(patches[0]));
}

/// A box of side 1, or with `twice` from x = -1 to 1.
TetrahedralMesh box(bool twice, double max_volume) {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "air";
  if (twice) room.min[0] = -1;
  geometry.primitives.emplace_back(room);
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{max_volume}, 1.4, {}}));
}

// A perfect mirror at x = 0 shows the other half of a room of twice the length.
TEST(ExtendedRoom, AMirrorIsHalfOfARoom) {
  const Finish grey{{0.5}, {0}, {0}}, lamp{{0.2}, {0}, {1}};
  const TetrahedralMesh half = box(false, 2e-3), whole = box(true, 2e-3);
  const Problem mirrored = room(half, {{"xmin", {{0}, {1}, {0}}}, {"zmin", lamp}}, grey);
  const Problem doubled = room(whole, {{"zmin", lamp}}, grey);
  RadiosityRoom with_mirror(mirrored, fine_options()), without(doubled, fine_options());
  const Solution a = with_mirror.solve(), b = without.solve();
  for (const char* wall : {"zmin", "zmax", "xmax", "ymin", "ymax"})
    EXPECT_NEAR(mean_on(half, a.irradiance, wall) / mean_on(whole, b.irradiance, wall), 1, 2e-3) << wall;
  const Vec3 points[] = {{0.1, 0.4, 0.7}, {0.6, 0.2, 0.3}};
  for (const Vec3& point : points) {
    const WallLightValue seen = with_mirror.light(4, 16384).at(point, Vec3::UnitZ()),
                         truth = without.light(4, 0).at(point, Vec3::UnitZ());
    EXPECT_NEAR(seen.fluence[0] / truth.fluence[0], 1, 4e-3);
    EXPECT_NEAR(seen.irradiance[0] / truth.irradiance[0], 1, 8e-3);
    EXPECT_LT((seen.net_flux[0] - truth.net_flux[0]).norm(), 8e-3 * truth.fluence[0]);
  }
}

// What arrives at each wall, within 1 % and three errors of the photons.
TEST(ExtendedRoom, GlossyWallsAreThoseOfPhotons) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const std::map<std::string, std::map<std::string, Finish>> rooms = {
      {"a Phong lobe", {{"zmin", {{0.1}, {0}, {0}, {std::make_shared<Phong>(0.8, 20.0)}}}}},
      {"facets by Schlick beside a mirror",
       {{"zmin", {{0.1}, {0.1}, {0}, {std::make_shared<Microfacets>(0.3, 0.3, FacetFresnel::schlick)}}},
        {"xmax", {{0.2}, {0.7}, {0}}}}},
      {"a smooth surface", {{"zmin", {{0}, {0}, {0}, {}, 1.5}}}},
      {"a lobe that differs from band to band",
       {{"zmin",
         {{0.1, 0.1},
          {0, 0},
          {0, 0},
          {std::make_shared<Phong>(0.8, 20.0), std::make_shared<Phong>(0.3, 20.0)}}}}},
      {"two lobes",
       {{"zmin",
         {{0.1, 0.1},
          {0, 0.2},
          {0, 0},
          {std::make_shared<Phong>(0.8, 20.0),
           std::make_shared<Microfacets>(0.5, 0.5, FacetFresnel::constant)}}}}}};
  for (const auto& [what, named] : rooms) {
    std::map<std::string, Finish> finishes = named;
    const std::size_t bands = named.at("zmin").diffuse.size();
    const auto all = [&](double value) { return std::vector<double>(bands, value); };
    finishes["xmin"] = {all(0.3), all(0), all(1)};
    const Problem problem = room(mesh, finishes, {all(0.3), all(0), all(0)});
    const Solution radiosity = RadiosityRoom(problem, fine_options()).solve();
    for (const Balance& balance : balances(problem, radiosity))
      EXPECT_LT(std::abs(balance.residual), 1e-10) << what;
    PhotonOptions options;
    options.photons = 100000;
    options.threads = 2;
    const auto wall_numbers = [&](const Solution& solution) {
      std::vector<double> powers;
      for (const auto& wall : wall_powers(problem, solution))
        for (const WallPower& power : wall) {
          powers.push_back(power.incoming);
          powers.push_back(power.outgoing);
        }
      return powers;
    };
    const PhotonSolution photons = solve_photons(problem, CellLocator(mesh), options, {}, wall_numbers);
    const std::vector<double> found = wall_numbers(radiosity);
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], photons.sums.derived.mean(i),
                  3 * photons.sums.derived.error(i) + 0.01 * photons.sums.derived.mean(i))
          << what << ", " << mesh.wall_names()[i / 2 / bands] << (i % 2 == 0 ? ", incoming" : ", outgoing");
  }
}

}  // namespace
}  // namespace etendue::extended_exchange_test
