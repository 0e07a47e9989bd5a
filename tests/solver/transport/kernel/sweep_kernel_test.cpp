// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/kernel/sweep_kernel.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/errors.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::sweep_kernel_test {
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
}  // namespace etendue::sweep_kernel_test
