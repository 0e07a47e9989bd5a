// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/kernels/directional_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "solver/materials/kernels/kernel_formula.h"
#include "solver/materials/kernels/leaf_canopy.h"
#include "solver/materials/kernels/micro_flakes.h"
#include "tests/solver/angular/sets/sets_to_test.h"

namespace etendue::directional_kernel_test {
namespace {

using std::numbers::pi;

std::vector<LeafAngles> all_leaf_angles() {
  std::vector<LeafAngles> all;
  for (std::size_t i = 0; i < leaf_angle_names().size(); ++i) all.push_back(static_cast<LeafAngles>(i));
  return all;
}

KernelFormula formula(const std::string& text) {
  KernelFormula kernel;
  kernel.formula = std::make_shared<Expression>(text, kernel_variables());
  return kernel;
}

const char* const henyey_greenstein =
    "2/(4*pi)*(1-0.7^2)/(1+0.7^2-2*0.7*(wx*vx+wy*vy+wz*vz))^1.5";  // sigma_s = 2, g = 0.7

std::string refusal(const DirectionalScattering& scattering, const DirectionSet& set) {
  try {
    directional_kernel(scattering, set);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LeafProjection, IsOneHalfInTheMeanForEveryInclination) {
  const DirectionSet set = directions_product(32);
  for (const LeafAngles angles : all_leaf_angles()) {
    double mean = 0;
    for (int m = 0; m < set.count(); ++m)
      mean +=
          set.weight(OrdinateIndex(m)) * leaf_projection(angles, set.direction(OrdinateIndex(m))) / (4 * pi);
    EXPECT_NEAR(mean, 0.5, 1e-3) << leaf_angle_names()[static_cast<std::size_t>(angles)];
  }
}

TEST(LeafProjection, IsThatOfItsNormals) {
  for (const LeafAngles angles : all_leaf_angles()) {
    const LeafNormals leaves = leaf_normals(angles);
    double total = 0;
    for (const double share : leaves.shares) total += share;
    EXPECT_NEAR(total, 1, 1e-12);
    for (const Vec3& w : {Vec3(0, 0, 1), Vec3(0.6, 0, 0.8), Vec3(0, 0.8, -0.6), Vec3(1, 0, 0)}) {
      double sum = 0;
      for (std::size_t i = 0; i < leaves.normals.size(); ++i)
        sum += leaves.shares[i] * std::abs(w.dot(leaves.normals[i]));
      EXPECT_NEAR(leaf_projection(angles, w), sum, 1e-3);
    }
  }
  EXPECT_EQ(leaf_projection(LeafAngles::horizontal, Vec3(0.6, 0, -0.8)), 0.8);
  EXPECT_NEAR(leaf_projection(LeafAngles::vertical, Vec3(0.6, 0, -0.8)), 2 / pi * 0.6, 1e-15);
}

TEST(LeafCanopy, ScattersAndAbsorbsWhatItsLeavesTake) {
  const DirectionSet set = directions_ldfe_sq(1);
  for (const LeafAngles angles : all_leaf_angles()) {
    const LeafCanopy leaves{angles, 0.4, 0.1};
    const DirectionalKernel kernel = directional_kernel(leaves, set);
    EXPECT_GE(kernel.kernel.rate.minCoeff(), 0);
    EXPECT_LT((kernel.kernel.rate - kernel.kernel.rate.transpose()).cwiseAbs().maxCoeff(), 1e-14);
    for (std::size_t m = 0; m < set.directions().size(); ++m) {
      const double projection = leaf_projection(angles, set.directions()[m]);
      EXPECT_NEAR(kernel.kernel.total[m], 0.5 * projection, 1e-14);
      EXPECT_NEAR(kernel.absorbing[m], 0.5 * projection, 1e-14);
      EXPECT_LE(kernel.kernel.leaving[m], kernel.kernel.total[m] * (1 + 1e-12));
    }
    // Sums over the matrix with its diagonal against Ross's G in closed form.
    EXPECT_LT(dense_accuracy(kernel.kernel, set).energy_error, 1e-10)
        << leaf_angle_names()[static_cast<std::size_t>(angles)];
  }
}

TEST(LeafCanopy, OfLevelLeavesSendsWhatItReflectsBackUp) {
  const DirectionSet set = directions_ldfe_sq(1);
  const DirectionalKernel kernel = directional_kernel(LeafCanopy{LeafAngles::horizontal, 0.5, 0}, set);
  for (Eigen::Index n = 0; n < set.count(); ++n)
    for (Eigen::Index m = 0; m < set.count(); ++m) {
      const double from = set.directions()[static_cast<std::size_t>(n)].z();
      const double into = set.directions()[static_cast<std::size_t>(m)].z();
      if (from * into > 0) {
        EXPECT_EQ(kernel.kernel.rate(m, n), 0);
        continue;
      }
      // Lambertian: 0.5/pi |mu'||mu|. Half ranges along z are exact on this set.
      EXPECT_NEAR(kernel.kernel.rate(m, n), -0.5 / pi * from * into, 1e-12);
    }
}

TEST(LeafCanopy, HasTheMeanCosineOfItsLeavesHoweverTheyStand) {
  // In isotropic light each leaf sends back r and through t of what it meets, (2/3) along its normal.
  const double reflectance = 0.4, transmittance = 0.3;
  const double cosine = 4.0 / 9 * (transmittance - reflectance) / (transmittance + reflectance);
  for (const DirectionSet& set : {directions_ldfe_sq(2), directions_product(16)})
    for (const LeafAngles angles : {LeafAngles::horizontal, LeafAngles::vertical, LeafAngles::erectophile}) {
      const DirectionalKernel kernel =
          directional_kernel(LeafCanopy{angles, reflectance, transmittance}, set);
      EXPECT_NEAR(dense_accuracy(kernel.kernel, set).asymmetry, cosine, 1e-3) << label(set);
    }
}

TEST(MicroFlakes, OfAnyShapeSendAsMuchBackAsOn) {
  for (const double along : {0.05, 0.5, 1.0}) {
    const DirectionSet set = directions_ldfe_sq(2);
    const DirectionalKernel flakes = directional_kernel(MicroFlakes{Vec3::UnitZ(), along, 1, 1}, set);
    EXPECT_NEAR(dense_accuracy(flakes.kernel, set).asymmetry, 0, 1e-3) << along;
  }
}

TEST(MicroFlakes, OfARoundShapeScatterIsotropically) {
  const DirectionSet set = directions_ldfe_sq(1);
  const DirectionalKernel kernel = directional_kernel(MicroFlakes{Vec3::UnitX(), 1, 1, 0.8}, set);
  EXPECT_NEAR(kernel.reference, 1, 1e-12);
  for (std::size_t m = 0; m < set.directions().size(); ++m) {
    EXPECT_NEAR(kernel.kernel.total[m], 0.8, 1e-12);
    EXPECT_NEAR(kernel.absorbing[m], 0.2, 1e-12);
  }
}

TEST(MicroFlakes, OfARoundShapeAreTheMatrixOfIsotropicScattering) {
  for (const DirectionSet& set : {directions_ldfe_sq(1), directions_product(8)}) {
    const DirectionalKernel round = directional_kernel(MicroFlakes{Vec3::UnitX(), 1, 1, 1}, set);
    const DenseKernel isotropic = dense_kernel(PhaseIsotropic{}, set);
    EXPECT_LT((round.kernel.rate - isotropic.rate).cwiseAbs().maxCoeff(), 1e-12) << label(set);
    EXPECT_NEAR(dense_accuracy(round.kernel, set).asymmetry, 0, 1e-12) << label(set);
  }
}

/// The sum over normals on fine rings about the axis, of D(h) |w.h|^3: without a closed form.
double summed_momentum_transfer(const MicroFlakes& flakes, const Vec3& w) {
  const int rings = 1000, azimuths = 400;
  const Vec3 side = flakes.axis.unitOrthogonal(), other = flakes.axis.cross(side);
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double polar = pi / 2 * (i + 0.5) / rings, z = std::cos(polar), r = std::sin(polar);
    const double stretched = z * z / (flakes.along * flakes.along) + r * r / (flakes.across * flakes.across);
    const double density = 1 / (pi * flakes.along * flakes.across * flakes.across * stretched * stretched);
    for (int j = 0; j < azimuths; ++j) {
      const double azimuth = 2 * pi * (j + 0.5) / azimuths;
      const Vec3 h = z * flakes.axis + r * (std::cos(azimuth) * side + std::sin(azimuth) * other);
      sum += density * std::pow(std::abs(w.dot(h)), 3) * r * 2 * pi * pi / rings / azimuths;
    }
  }
  return sum;
}

TEST(MicroFlakes, LoseTheMomentumOfMirrors) {
  const Vec3 w = Vec3(0.3, -0.5, 0.7).normalized();
  for (const MicroFlakes& flakes :
       {MicroFlakes{Vec3(0, 0.6, 0.8), 1, 0.2, 1}, MicroFlakes{Vec3(0, 0.6, 0.8), 0.3, 1, 1},
        MicroFlakes{Vec3(0.6, 0, 0.8), 0.7, 0.5, 1}})
    for (const Vec3& direction : {w, flakes.axis, Vec3(flakes.axis.unitOrthogonal())})
      EXPECT_NEAR(flake_momentum_transfer(flakes, direction) / summed_momentum_transfer(flakes, direction), 1,
                  2e-5)
          << flakes.along << ' ' << flakes.across;
  // A stack of mirrors sends light back where it is seen from above, and forward where it is seen aslant.
  const MicroFlakes mirrors{Vec3::UnitZ(), 1, 1e-3, 1};
  EXPECT_NEAR(flake_momentum_transfer(mirrors, Vec3::UnitZ()), 2, 1e-4);
  EXPECT_NEAR(flake_momentum_transfer(mirrors, Vec3(0.8, 0, 0.6)), 2 * 0.6 * 0.6 * 0.6, 1e-4);
}

TEST(MicroFlakes, AsThinAsMirrorsAreAccepted) {
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0, 0.6, 0.8)})
    for (const MicroFlakes& flakes : {MicroFlakes{axis, 1, 1e-3, 0.9}, MicroFlakes{axis, 1e-3, 1, 0.9}})
      EXPECT_EQ(refusal(flakes, directions_ldfe_sq(1)), "") << axis.y() << ' ' << flakes.along;
}

TEST(MicroFlakes, ThatLieFlatShowTheirFacesAlongTheAxis) {
  const MicroFlakes flakes{Vec3(0, 0.6, 0.8), 1, 0.2, 0.9};
  EXPECT_NEAR(flake_projection(flakes, flakes.axis), 1, 1e-15);
  EXPECT_NEAR(flake_projection(flakes, Vec3::UnitX()), 0.2, 1e-15);
  const DirectionalKernel kernel = directional_kernel(flakes, directions_ldfe_sq(1));
  EXPECT_GE(kernel.kernel.rate.minCoeff(), 0);
  EXPECT_GT(kernel.reference, 0.2);
  EXPECT_LT(kernel.reference, 1);
}

TEST(KernelFormula, ThatIsHenyeyAndGreensteinsEqualsIt) {
  EXPECT_NEAR(mean_scattering(formula(henyey_greenstein)), 2, 1e-12);
  for (const DirectionSet& set : {directions_ldfe_sq(1), directions_triangular(8)}) {
    const DirectionalKernel kernel = directional_kernel(formula(henyey_greenstein), set);
    const DenseKernel expected = dense_kernel(PhaseHenyeyGreenstein{0.7}, set);
    EXPECT_LT((kernel.kernel.rate - 2 * expected.rate).cwiseAbs().maxCoeff(), 1e-12) << label(set);
    for (std::size_t m = 0; m < kernel.kernel.leaving.size(); ++m)
      EXPECT_NEAR(kernel.kernel.leaving[m], 2 * expected.leaving[m], 1e-12);
    EXPECT_NEAR(kernel.reference, 2, 1e-12);
    EXPECT_TRUE(kernel.absorbing.empty());
  }
}

TEST(KernelFormula, WithKinksAndStepsIsIntegrated) {
  struct Known {
    const char* text;
    double (*scattered)(const Vec3&);
    double most;
  };
  const auto step = [](const Vec3&) { return 1.0; };
  const auto oblique = [](const Vec3&) { return pi * std::sqrt(1.34); };
  for (const Known& known :
       {Known{"max(0, wz*vz)", [](const Vec3& w) { return pi * std::abs(w.z()); }, 1e-7},
        Known{"max(0, wx*vx+wy*vy+wz*vz)", [](const Vec3&) { return pi; }, 1e-7},
        Known{"abs(vx*wy)", [](const Vec3& w) { return 2 * pi * std::abs(w.y()); }, 1e-7},
        Known{"vz > 0 ? 1/(2*pi) : 0", step, 1e-7}, Known{"max(0, vx+0.5*vy-0.3*vz)", oblique, 1e-5}})
    for (const Vec3& w : {Vec3(0.36, 0.48, 0.8), Vec3(-0.6, 0, 0.8), Vec3(0, 0, -1)}) {
      const OutgoingMoments found = outgoing_moments(formula(known.text), w);
      const double expected = known.scattered(w);
      EXPECT_LT(found.uncertainty, known.most) << known.text;
      EXPECT_NEAR(found.scattered, expected, (found.uncertainty + 1e-14) * expected) << known.text;
    }
}

TEST(KernelFormula, WithANarrowMirrorImageIsIntegrated) {
  // Half a degree wide about the image of the direction in z = 0.
  const DirectionSet set = directions_ldfe_sq(1);
  for (const Vec3& w : set.directions()) {
    const OutgoingMoments found = outgoing_moments(formula("exp(-10000*(1-(wx*vx+wy*vy-wz*vz)))"), w);
    EXPECT_NEAR(found.scattered, 2 * pi / 10000, 1e-6 * 2 * pi / 10000);
    EXPECT_LT(found.uncertainty, 1e-6);
  }
}

TEST(KernelFormula, ThatIsTooSharpToBeIntegratedIsRefused) {
  const std::string text =
      refusal(formula("exp(-1e8*(vx-0.36)^2)*(1+wx*vx)"), directions_ldfe_sq(1));  // a ring of 1e-4
  EXPECT_EQ(text.rfind("what the kernel scatters out of the direction (", 0), 0u) << text;
  EXPECT_NE(text.find("too sharp for a formula, use a phase function or a matrix"), std::string::npos)
      << text;
  EXPECT_NE(refusal(formula("1/(vx-vx)"), directions_ldfe_sq(1)), "");
}

TEST(KernelFormula, SaysHowFarItsIntegralMayBeOff) {
  const DirectionSet set = directions_product(2);
  EXPECT_LT(directional_kernel(formula(henyey_greenstein), set).kernel.uncertainty, 1e-10);
  const DirectionalKernel kinked = directional_kernel(formula("max(0, 0.9*wx+vx+0.5*vy-0.3*vz)"), set);
  EXPECT_GT(kinked.kernel.uncertainty, 1e-9);
  EXPECT_LT(kinked.kernel.uncertainty, 1e-4);
  EXPECT_GE(dense_accuracy(kinked.kernel, set).energy_error, kinked.kernel.uncertainty);
}

TEST(KernelFormula, ThatIsReciprocalMakesAMatrixThatIs) {
  for (const char* text :
       {"1 + 0.5*(wz - vz)", "(1 + 0.9*wx*vx)*(2 + wz - vz)", "max(0, -wz*vz)", "exp(wz-vz)"}) {
    KernelFormula kernel = formula(text);
    kernel.reciprocal = true;
    for (const DirectionSet& set : {directions_ldfe_sq(1), directions_triangular(8)}) {
      const DenseAccuracy accuracy = dense_accuracy(directional_kernel(kernel, set).kernel, set);
      EXPECT_LT(accuracy.reciprocity_error, 1e-12) << text << " on " << label(set);
      EXPECT_LT(accuracy.momentum_error, 1e-9) << text << " on " << label(set);
    }
  }
}

TEST(KernelFormula, NamesTheDirectionsThatMakeItNegative) {
  const std::string text = refusal(formula("1 + 2*vx"), directions_ldfe_sq(1));
  EXPECT_EQ(text.rfind("the kernel is -", 0), 0u) << text;
  EXPECT_NE(text.find(" from ("), std::string::npos) << text;
  EXPECT_NE(text.find(" into ("), std::string::npos) << text;
}

TEST(KernelFormula, IsRefusedWhereItScattersMoreThanTheExtinction) {
  KernelFormula kernel = formula("(1 + 0.5*wz)/(4*pi)");
  kernel.extinction = 1.2;
  const std::string text = refusal(kernel, directions_ldfe_sq(1));
  EXPECT_NE(text.find("out of the direction ("), std::string::npos) << text;
  kernel.extinction = 1.6;
  EXPECT_EQ(refusal(kernel, directions_ldfe_sq(1)), "");
}

TEST(KernelFormula, KeepsItsWordThatItIsReciprocal) {
  KernelFormula kernel = formula("1 + 0.5*wz");
  EXPECT_EQ(refusal(kernel, directions_ldfe_sq(1)), "");
  kernel.reciprocal = true;
  EXPECT_NE(refusal(kernel, directions_ldfe_sq(1)).find("the opposite way"), std::string::npos);
  kernel = formula("1 + 0.5*(wz - vz)");  // k(-v, -w) is the same
  kernel.reciprocal = true;
  EXPECT_EQ(refusal(kernel, directions_ldfe_sq(1)), "");
}

TEST(KernelMatrix, ThatIsDiagonalDoesNotScatter) {
  const DirectionSet set = directions_product(2);
  KernelMatrix matrix;
  matrix.count = set.count();
  matrix.values.assign(static_cast<std::size_t>(set.count() * set.count()), 0);
  for (int m = 0; m < set.count(); ++m)
    matrix.values[static_cast<std::size_t>(m * set.count() + m)] = 3 / set.weight(OrdinateIndex(m));
  const DirectionalKernel kernel = directional_kernel(matrix, set);
  for (const double leaving : kernel.kernel.leaving) EXPECT_EQ(leaving, 0);
  EXPECT_NEAR(kernel.reference, 3, 1e-14);
}

TEST(KernelMatrix, ForAnotherSetIsRefused) {
  KernelMatrix matrix{4, std::vector<double>(16, 1), false, {}};
  EXPECT_NE(refusal(matrix, directions_product(2)).find("is for 4 directions"), std::string::npos);
}

}  // namespace
}  // namespace etendue::directional_kernel_test
