// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/walls/wall_matrix.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "solver/materials/surfaces/microfacets.h"
#include "solver/materials/surfaces/phong.h"
#include "solver/materials/surfaces/ward.h"

namespace etendue::wall_matrix_test {
namespace {

std::vector<std::shared_ptr<const Reflectance>> models() {
  return {std::make_shared<Phong>(0.9, 0),
          std::make_shared<Phong>(0.8, 50),
          std::make_shared<Microfacets>(0.7, 0.3, FacetFresnel::schlick),
          std::make_shared<Microfacets>(0.9, 0.02, FacetFresnel::constant),
          std::make_shared<Ward>(0.9, 0.02),
          std::make_shared<Ward>(0.8, 0.4)};
}

const std::vector<Vec3> normals{Vec3::UnitZ(), -Vec3::UnitX(), Vec3(0.3, -0.5, 0.8).normalized()};

/// w |w.n| of pairs.
std::vector<double> across(const DirectionSet& set, const Vec3& normal) {
  std::vector<double> values;
  for (std::int32_t m = 0; m < set.count(); m += 2)
    values.push_back(set.weight(OrdinateIndex(m)) * std::abs(set.direction(OrdinateIndex(m)).dot(normal)));
  return values;
}

// The albedo is reflected of light along each ordinate, and it is the reflected radiance of isotropic light
// of radiance 1.
TEST(WallMatrix, KeepsTheEnergyOfEachDirection) {
  const DirectionSet set = directions_ldfe_sq(1);
  for (const auto& model : models())
    for (const Vec3& normal : normals) {
      const WallMatrix matrix(set, normal, *model);
      const std::vector<double> c = across(set, normal);
      for (Eigen::Index q = 0; q < matrix.entries().cols(); ++q) {
        const double albedo =
            model->albedo(std::abs(set.direction(OrdinateIndex(static_cast<int>(2 * q))).dot(normal)));
        double out = 0;
        for (Eigen::Index p = 0; p < matrix.entries().rows(); ++p)
          out += c[static_cast<std::size_t>(p)] * matrix.entries()(p, q);
        EXPECT_NEAR(out / c[static_cast<std::size_t>(q)], albedo, 1e-12);
        EXPECT_NEAR(matrix.entries().row(q).sum(), albedo, 1e-12);
      }
    }
}

TEST(WallMatrix, IsReciprocalAndNotNegative) {
  const DirectionSet set = directions_ldfe_sq(1);
  for (const auto& model : models()) {
    const WallMatrix matrix(set, normals[2], *model);
    const std::vector<double> c = across(set, normals[2]);
    for (std::size_t p = 0; p < c.size(); ++p)
      for (std::size_t q = 0; q < p; ++q) {
        const auto row = static_cast<Eigen::Index>(p), column = static_cast<Eigen::Index>(q);
        const double there = c[p] * matrix.entries()(row, column),
                     back = c[q] * matrix.entries()(column, row);
        // Beside a narrow lobe products of factors that are nearly nothing lose their digits.
        EXPECT_NEAR(there, back, 1e-12 * (there + back) + 1e-200);
        EXPECT_GE(there, 0);
      }
  }
}

/// What a lobe reflects into `out` of the light max(w.x, 0)^2: f_r cos over the half sphere of arriving
/// light, by a midpoint rule.
double reflected_radiance(const Reflectance& lobe, const Vec3& normal, const Vec3& out) {
  constexpr int rings = 100, turns = 200;
  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  double sum = 0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < turns; ++j) {
      // Uniform in cos^2: each point has the same share of the projected half sphere.
      const double cosine = std::sqrt((i + 0.5) / rings), sine = std::sqrt(1 - cosine * cosine);
      const double azimuth = 2 * std::numbers::pi * (j + 0.5) / turns;
      const Vec3 in = cosine * normal + sine * (std::cos(azimuth) * u + std::sin(azimuth) * v);
      const double light = std::pow(std::max(in.x(), 0.0), 2);
      sum += light * lobe.between(in, out, -normal);
    }
  return sum * std::numbers::pi / (rings * turns);
}

// A wall that is lit from one side, against the integral of the reflectance, as the set is refined.
TEST(WallMatrix, TendsToTheIntegralOfTheReflectance) {
  const Phong lobe(0.8, 10);
  const Vec3& normal = normals[2];
  double last_error = 1, last_sums = 1;
  for (const int order : {1, 2, 4}) {
    const DirectionSet set = directions_ldfe_sq(order);
    const WallMatrix matrix(set, normal, lobe);
    double error = 0, size = 0;
    for (Eigen::Index p = 0; p < matrix.entries().rows(); p += order * order) {
      double found = 0;
      for (Eigen::Index q = 0; q < matrix.entries().cols(); ++q) {
        const Vec3& w = set.direction(OrdinateIndex(static_cast<int>(2 * q)));
        const Vec3 in = w.dot(normal) > 0 ? w : Vec3(-w);
        found += matrix.entries()(p, q) * std::pow(std::max(in.x(), 0.0), 2);
      }
      const Vec3& w = set.direction(OrdinateIndex(static_cast<int>(2 * p)));
      const double exact = reflected_radiance(lobe, normal, w.dot(normal) < 0 ? w : Vec3(-w));
      error += std::pow(found - exact, 2);
      size += exact * exact;
    }
    error = std::sqrt(error / size);
    const RowSums sums = matrix.row_sums();
    const double off = std::max(1 - sums.smallest, sums.largest - 1);
    EXPECT_LT(error, 0.5 * last_error) << order;
    EXPECT_LT(off, 0.6 * last_sums) << order;
    last_error = error;
    last_sums = off;
  }
  EXPECT_LT(last_error, 5e-3);
  EXPECT_LT(last_sums, 0.03);
}

// A wall that is nearly smooth and lies across an axis has nothing but the mirrored ordinate.
TEST(WallMatrix, ANarrowLobeIsAMirror) {
  const DirectionSet set = directions_ldfe_sq(1);
  const Microfacets smooth(0.9, 0.001, FacetFresnel::constant);
  const WallMatrix matrix(set, Vec3::UnitZ(), smooth);
  for (std::int32_t p = 0; p < set.count() / 2; ++p) {
    const std::int32_t mirrored = set.mirrored(OrdinateIndex(2 * p), Vec3::UnitZ()) / 2;
    const double albedo = smooth.albedo(std::abs(set.direction(OrdinateIndex(2 * p)).z()));
    EXPECT_NEAR(matrix.entries()(mirrored, p), albedo, 0.02);
  }
}

}  // namespace
}  // namespace etendue::wall_matrix_test
