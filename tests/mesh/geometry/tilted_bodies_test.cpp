// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Bodies in general positions, many of them: slower than a unit test may be.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "tests/mesh/geometry/scene.h"

namespace etendue::tilted_bodies_test {
namespace {

std::map<std::string, double> meshed_volumes(const Geometry& geometry) {
  const TetrahedralMesh mesh(tetrahedralize(arrange(geometry), {}));
  std::map<std::string, double> volumes;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    volumes[mesh.region_names()[static_cast<std::size_t>(mesh.region(CellIndex(c)))]] +=
        mesh.volume(CellIndex(c));
  return volumes;
}

TEST(TiltedBodies, CylindersOfAnyNumberOfSidesKeepTheirVolumes) {
  std::mt19937 random(7);
  std::normal_distribution<double> part;
  for (const int facets : {8, 16, 32, 64}) {
    const double jet = 2 * facets * 0.5 * 0.09 * std::sin(2 * std::numbers::pi / facets);
    for (int i = 0; i < 8; ++i) {
      const Vec3 axis = Vec3(part(random), part(random), part(random)).normalized();
      const Vec3 from = Vec3::Constant(2) - axis, to = Vec3::Constant(2) + axis;
      SCOPED_TRACE(testing::Message() << facets << " sides along " << axis.transpose());
      const auto volumes =
          meshed_volumes({{box("air", {0, 0, 0}, {4, 4, 4}), cylinder("jet", from, to, 0.3, facets)}, {}});
      ASSERT_EQ(volumes.size(), 2u);
      EXPECT_NEAR(volumes.at("jet"), jet, 1e-12);
      EXPECT_NEAR(volumes.at("air"), 64 - jet, 64e-12);
    }
  }
}

}  // namespace
}  // namespace etendue::tilted_bodies_test
