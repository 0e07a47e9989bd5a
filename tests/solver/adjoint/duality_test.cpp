// SPDX-License-Identifier: AGPL-3.0-or-later
// What a run reads of a quantity, and the sum of what all emitters bring of it by its importance.
#include <gtest/gtest.h>

#include <memory>

#include "base/errors.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"
#include "tests/solver/adjoint/random_problem.h"
#include "tests/solver/transport/directional_media.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::duality_test {
namespace {

SolveOptions exact_options(Lumping lumping = Lumping::automatic) {
  SolveOptions options = tight_options(lumping);
  options.tolerance = 1e-13;
  options.precision = Precision::full;
  return options;
}

void expect_duality(const Problem& problem, const DirectionSet& directions, unsigned seed,
                    const SolveOptions& options = exact_options()) {
  const std::vector<Response> responses = random_responses(problem.mesh(), seed);
  const std::vector<double> errors = duality_errors(problem, directions, responses, options);
  ASSERT_EQ(errors.size(), responses.size());
  for (std::size_t i = 0; i < errors.size(); ++i)
    EXPECT_LT(errors[i], 1e-11) << "seed " << seed << ", response " << i;
}

const TetrahedralMesh& coarse_mesh() {
  static const TetrahedralMesh mesh = two_region_mesh(0.2);
  return mesh;
}

void expect_duality(const TetrahedralMesh& mesh, unsigned seed, Rays rays) {
  expect_duality(random_problem(mesh, seed, rays),
                 seed % 2 == 0 ? directions_product(4) : directions_ldfe_sq(1), seed);
}

class OnTheOrdinates : public testing::TestWithParam<unsigned> {};
TEST_P(OnTheOrdinates, ImportanceGivesWhatARunReads) {
  expect_duality(coarse_mesh(), GetParam(), Rays::none);
}
INSTANTIATE_TEST_SUITE_P(Duality, OnTheOrdinates, testing::Range(0U, 8U));

// Six cells, since rays take their time.
class AlongRays : public testing::TestWithParam<unsigned> {
 protected:
  TetrahedralMesh mesh_ = TetrahedralMesh(kuhn_cube_raw());
};
TEST_P(AlongRays, ImportanceGivesWhatARunReadsOfALamp) { expect_duality(mesh_, GetParam(), Rays::from_lamp); }
TEST_P(AlongRays, ImportanceGivesWhatARunReadsOfLights) { expect_duality(mesh_, GetParam(), Rays::from_all); }
INSTANTIATE_TEST_SUITE_P(Duality, AlongRays, testing::Range(0U, 4U));

TEST(Duality, HoldsWithAMatrixAndWithDeltaM) {
  for (const ScatteringChoice choice :
       {ScatteringChoice{ScatteringBackend::dense, -1, ForwardPeak::automatic},
        ScatteringChoice{ScatteringBackend::moments, 3, ForwardPeak::delta_m},
        ScatteringChoice{ScatteringBackend::galerkin, -1, ForwardPeak::keep}}) {
    const Problem problem = random_problem(coarse_mesh(), 3, Rays::none, [&](auto& media, auto&) {
      for (Medium& medium : media) {
        medium.phase.assign(3, PhaseHenyeyGreenstein{0.7});
        medium.choice.assign(3, choice);
      }
    });
    expect_duality(problem, directions_product(4), 3);
  }
}

TEST(Duality, HoldsWithLeavesFlakesAndAbsorptionByDirection) {
  const Problem problem = random_problem(coarse_mesh(), 4, Rays::none, [](auto& media, auto&) {
    media[0].directional = {LeafCanopy{LeafAngles::planophile, 0.3, 0.2},
                            MicroFlakes{Vec3(1, 2, 3).normalized(), 1, 0.4, 0.8}, std::monostate{}};
    media[0].absorption_by_direction = {{}, {}, AngularFormula("0.5 + 0.2*wx + 0.1*wz*wz")};
    media[0].emission_by_direction = {{}, {}, AngularFormula("1 + 0.5*wx + x")};
  });
  const std::vector<Response> all = random_responses(coarse_mesh(), 4);
  const std::vector<double> errors =
      duality_errors(problem, directions_product(4), {all[0], all[1], all[2]}, exact_options());
  ASSERT_EQ(errors.size(), 3U);
  for (const double error : errors) EXPECT_LT(error, 1e-11);
  EXPECT_THROW(solve_adjoint({}, problem, {directions_product(4)}, AbsorbedPower{0}, exact_options()),
               InputError);
}

TEST(Duality, HoldsWithRefractingWallsThatGlow) {
  const Problem problem = random_problem(coarse_mesh(), 5, Rays::none, [](auto&, auto& walls) {
    for (Wall& wall : walls) {
      if (wall.name == "zmax") continue;  // where the beam enters
      wall.diffuse.assign(3, 0);
      wall.specular.assign(3, 0);
      wall.glossy.clear();
      wall.refractive_index = 1.4;
      wall.radiance = {1, 0.5, 2};
    }
  });
  expect_duality(problem, directions_product(6), 5);
}

TEST(Duality, HoldsOnConstantElementsAndWithLumpedMass) {
  const Problem problem = random_problem(coarse_mesh(), 6, Rays::none);
  SolveOptions constant = exact_options();
  constant.order = SpaceOrder::constant;
  expect_duality(problem, directions_product(4), 6, constant);
  expect_duality(problem, directions_product(4), 6, exact_options(Lumping::mass));
}

TEST(Duality, RefusesWhatHasNoAdjoint) {
  const auto adjoint_of = [](const Problem& problem, const SolveOptions& options) {
    return solve_adjoint({}, problem, {directions_product(4)}, ArrivingPower{0}, options);
  };
  const Problem problem = random_problem(coarse_mesh(), 7, Rays::none);
  SolveOptions positive = exact_options();
  positive.positivity = Positivity::rescale;
  EXPECT_THROW(adjoint_of(problem, positive), InputError);
  const Problem by_kernel = random_problem(coarse_mesh(), 7, Rays::none, [](auto& media, auto&) {
    media[0].directional.assign(3, kernel("0.1 + 0.05*wz"));
  });
  EXPECT_THROW(adjoint_of(by_kernel, exact_options()), InputError);
}

}  // namespace
}  // namespace etendue::duality_test
