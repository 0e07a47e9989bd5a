// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/kernel/sweep_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/errors.h"
#include "solver/transport/cells/cell_coefficients.h"
#include "solver/transport/kernel/cell_balance.h"
#include "solver/transport/order/projected_area.h"
#include "solver/transport/order/sweep_order.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue {
namespace {

class KernelChoice : public testing::Test {
 protected:
  void TearDown() override { unsetenv("ETENDUE_ISA"); }

  /// Empty where this machine does not have the instruction set.
  std::vector<double> fluence(const char* isa, int bands) {
    setenv("ETENDUE_ISA", isa, 1);
    const TetrahedralMesh mesh = cube_mesh(2e-2);
    const Problem problem =
        uniform_problem(mesh, uniform_medium(bands, 1.3, 0.9, 0.7, PhaseHenyeyGreenstein{0.4}),
                        uniform_wall(bands, 0.2, 0.3, 0.1));
    SolveOptions options = tight_options(Lumping::automatic);
    options.tolerance = 1e-4;
    try {
      return solve(problem, directions_product(4), options).fluence;
    } catch (const InputError&) {
      return {};
    }
  }
};

TEST_F(KernelChoice, InstructionSetsGiveTheSameBits) {
  for (const int bands : {1, 2, 3, 8, 11, 16}) {
    const std::vector<double> baseline = fluence("baseline", bands);
    ASSERT_FALSE(baseline.empty());
    for (const char* isa : {"avx2", "avx512"}) {
      const std::vector<double> wide = fluence(isa, bands);
      if (wide.empty()) continue;
      EXPECT_EQ(wide, baseline) << isa << " with " << bands << " bands";
    }
  }
}

TEST_F(KernelChoice, BandsSolvedTogetherEqualBandsSolvedAlone) {
  const std::vector<double> one = fluence("baseline", 1);
  ASSERT_FALSE(one.empty());
  for (const int bands : {2, 3, 8, 11, 16}) {
    const std::vector<double> many = fluence("baseline", bands);
    ASSERT_EQ(many.size(), one.size() * static_cast<std::size_t>(bands));
    for (std::size_t i = 0; i < one.size(); ++i)
      for (std::size_t b = 0; b < static_cast<std::size_t>(bands); ++b)
        EXPECT_NEAR(many[i * static_cast<std::size_t>(bands) + b], one[i], 1e-13 * one[i]);
  }
}

TEST_F(KernelChoice, RefusesAnUnknownInstructionSet) {
  setenv("ETENDUE_ISA", "mmx", 1);
  try {
    choose_kernels(Basis::linear, 1);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "ETENDUE_ISA = mmx: unknown; use avx512, avx2 or baseline");
  }
}

/// The radiance [cell][4] of one ordinate in one band, cell by cell and number by number.
std::vector<double> swept_plainly(const Problem& problem, const Vec3& direction, int band, Lumping lumping) {
  const TetrahedralMesh& mesh = problem.mesh();
  std::vector<double> extinction;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    extinction.push_back(problem.absorption(CellIndex(c), band));
  const CellCoefficients cells(mesh, extinction, 1, Basis::linear, lumping);
  std::vector<double> radiance(4 * static_cast<std::size_t>(mesh.cell_count()));
  const SweepTiles tiles(mesh, static_cast<std::size_t>(mesh.cell_count()));
  const SweepGraph graph(mesh);
  std::vector<SweepVisit> visits(graph.cell_count());
  const SweepOrder order = SweepOrderMaker(graph, tiles, LevelOrder::neighbours).make(direction, visits);
  for (const SweepVisit& visit : order.visits) {
    const CellIndex cell(visited_cell(visit));
    double a[4], right[4], u[4];
    for (std::size_t f = 0; f < 4; ++f) {
      const FaceIndex face(mesh.faces(cell)[f]);
      a[f] = (mesh.owner(face) == cell ? 1 : -1) * projected_area(mesh.area_normal(face), direction);
    }
    const ProjectedAreas<double> areas = projected_areas(a);
    const auto source = cells.source_factors(cell, 0);
    for (double& r : right) r = (4 * source.sum + source.own) * problem.emission(cell, band);
    for (int f = 0; f < 4; ++f) {
      const FaceIndex face(mesh.faces(cell)[static_cast<std::size_t>(f)]);
      if (a[f] >= 0) continue;
      double inflow[3];
      for (std::size_t k = 0; k < 3; ++k) {
        if (face.value() < mesh.boundary_face_count()) {
          inflow[k] = problem.wall(mesh.wall(face)).radiance[static_cast<std::size_t>(band)];
          continue;
        }
        const CellIndex other = mesh.owner(face) == cell ? mesh.neighbour(face) : mesh.owner(face);
        const auto& vertices = mesh.vertices(other);
        const auto node =
            std::find(vertices.begin(), vertices.end(), mesh.vertices(face)[k]) - vertices.begin();
        inflow[k] = radiance[4 * other.at() + static_cast<std::size_t>(node)];
      }
      add_inflow(areas, f, inflow, right);
    }
    const double mass = cells.mass(cell, 0);
    solve_cell(areas, invert_cell(areas, std::abs(mass), std::max(mass, 0.0)), right, u);
    std::copy(u, u + 4, &radiance[4 * cell.at()]);
  }
  return radiance;
}

TEST(SweepKernel, PacketsGiveTheAnswerOfThePlainKernel) {
  const TetrahedralMesh mesh = cube_with_ball(5e-3);
  for (const int bands : {1, 2, 3, 8, 11, 16}) {
    // Thick enough in the first bands that some cells are lumped and others are not; no band is like another.
    Medium medium = uniform_medium(bands, 12.8, 0, 0.7, PhaseIsotropic{});
    Wall wall = uniform_wall(bands, 0.9, 0, 0);
    for (std::size_t b = 0; b < static_cast<std::size_t>(bands); ++b) {
      const auto number = static_cast<double>(b + 1);
      medium.absorption[b] = Coefficient(12.8 / number);
      medium.emission[b] = Coefficient(0.7 * number);
      wall.radiance[b] = 0.9 + 0.1 * number;
    }
    const Problem problem = uniform_problem(mesh, medium, wall);
    const DirectionSet directions = directions_product(4);
    SolveOptions options = tight_options(Lumping::automatic);
    options.keep_ordinates = {5, 20};
    const Solution solution = solve(problem, directions, options);
    ASSERT_EQ(solution.radiance.size(), options.keep_ordinates.size());
    for (const OrdinateRadiance& kept : solution.radiance)
      for (int band = 0; band < bands; ++band) {
        const std::vector<double> plain =
            swept_plainly(problem, directions.direction(OrdinateIndex(kept.ordinate)), band, options.lumping);
        ASSERT_EQ(kept.values.size(), plain.size() * static_cast<std::size_t>(bands));
        for (std::size_t i = 0; i < plain.size(); ++i)
          EXPECT_NEAR(kept.values[i * static_cast<std::size_t>(bands) + static_cast<std::size_t>(band)],
                      plain[i], 1e-13 * (1 + plain[i]));
      }
  }
}

TEST(LaneStride, RoundsBandsUpToLanes) {
  EXPECT_EQ(lane_stride(1), 1);
  EXPECT_EQ(lane_stride(2), 2);
  EXPECT_EQ(lane_stride(3), 4);
  EXPECT_EQ(lane_stride(4), 4);
  EXPECT_EQ(lane_stride(5), 8);
  EXPECT_EQ(lane_stride(16), 16);
  EXPECT_EQ(lane_stride(17), 24);
}

}  // namespace
}  // namespace etendue
