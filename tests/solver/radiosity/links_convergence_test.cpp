// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "radiosity_samples.h"

namespace etendue {
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
}  // namespace etendue
