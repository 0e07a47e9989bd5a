// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/geometry/primitives/sheet_shape.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "tests/solver/radiosity/radiosity_samples.h"

namespace etendue::links_convergence_test {
namespace {

/// Root mean square of what two solutions differ by, of the mean of one.
double difference(const RadiosityRoom& room, const std::vector<double>& other) {
  double square = 0, mean = 0, area = 0;
  for (std::size_t p = 0; p < other.size(); ++p) {
    const double part = room.patches().patches[p].area(), value = room.irradiance()[p];
    square += part * std::pow(value - other[p], 2);
    mean += part * value;
    area += part;
  }
  return std::sqrt(square / area) / (mean / area);
}

// The same patches by all pairs: the error falls with the tolerance, and is some ten times that.
TEST(LinksConvergence, SolutionsTendToThatOfTheMatrix) {
  for (const TetrahedralMesh& mesh : {TetrahedralMesh(kuhn_cube_raw()), room_with_crate(0.1)}) {
    const Problem problem = empty_room(mesh, 0.5, "zmax");
    RadiosityOptions options;
    options.patch_size = 0.4;
    options.threads = 2;
    RadiosityRoom all(problem, options);
    all.solve();
    double last = 1;
    for (const double tolerance : {3e-3, 3e-4}) {
      options.method = RadiosityMethod::hierarchical;
      options.link_tolerance = tolerance;
      RadiosityRoom linked(problem, options);
      const Solution solution = linked.solve();
      EXPECT_TRUE(solution.converged());
      EXPECT_GT(linked.report().links, 0u);
      const double error = difference(all, linked.irradiance());
      EXPECT_LT(error, 20 * tolerance);
      EXPECT_LT(error, last);
      last = error;
    }
  }
}

/// A cube with a small bright patch in its floor below a sheet that lets half of the light through: the light
/// between them is many times the mean.
TetrahedralMesh room_below_a_sheet() {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "air";
  geometry.primitives.emplace_back(room);
  geometry.patches.push_back({"lamp", {0.4, 0.4, 0}, {0.5, 0.5, 0}, {}});
  geometry.sheets.push_back({rectangle_corners({0.2, 0.2, 0.1}, {0.8, 0.8, 0.1}), "top", "under", {}});
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{0.05}, 1.4, {}}));
}

Problem lit_from_below(const TetrahedralMesh& mesh) {
  const Problem plain = empty_room(mesh, 0.5, "lamp");
  std::vector<Wall> walls(plain.walls().begin(), plain.walls().end());
  for (Wall& wall : walls)
    if (wall.name == "top" || wall.name == "under") {
      wall.diffuse = {0.4};
      wall.transmittance = {0.5};
    }
  return Problem(mesh, Bands{}, {plain.media().begin(), plain.media().end()}, walls);
}

// What patches send is not known before: links are split until all stay for what is found. Below the sheet
// and, via it, above.
TEST(LinksConvergence, LinksAreSplitUntilTheBoundHoldsBesideASheet) {
  const TetrahedralMesh mesh = room_below_a_sheet();
  const Problem problem = lit_from_below(mesh);
  RadiosityOptions options;
  options.patch_size = 0.2;
  options.threads = 2;
  RadiosityRoom all(problem, options);
  all.solve();
  options.method = RadiosityMethod::hierarchical;
  for (const double tolerance : {3e-3, 3e-4}) {
    options.link_tolerance = tolerance;
    RadiosityRoom linked(problem, options);
    linked.solve();
    const std::vector<std::size_t>& rounds = linked.report().link_rounds;
    EXPECT_GT(rounds.size(), 1u);
    EXPECT_LT(rounds.size(), 10u);
    EXPECT_GT(rounds.back(), rounds.front());
    EXPECT_EQ(rounds.back(), linked.report().links);
    // Of what there is, which is far more than the mean in few places.
    const std::vector<double> dark(linked.irradiance().size(), 0);
    EXPECT_LT(difference(all, linked.irradiance()), 20 * tolerance * difference(all, dark));
  }
}

// Sixteen times the patches have at most sixteen times the links, and an eighth more: those of all pairs grow
// by 256.
TEST(LinksConvergence, LinksGrowAsPatchesDo) {
  for (const TetrahedralMesh& mesh : {TetrahedralMesh(kuhn_cube_raw()), room_with_crate(0.1)}) {
    const auto links_of = [&](double size) {
      const std::vector<FlatPatch> patches = wall_patches(mesh, size).patches;
      const LinkRule rule{1e-3, std::vector<double>(patches.size(), 1)};
      const ExchangeLinks links(patches, rule, 4, 2);
      return static_cast<double>(links.link_count()) / static_cast<double>(patches.size());
    };
    const double coarse = links_of(0.2), fine = links_of(0.05);
    EXPECT_LT(fine, 1.125 * coarse);
  }
}

}  // namespace
}  // namespace etendue::links_convergence_test
