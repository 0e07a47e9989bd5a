// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/surfaces/reflectance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "base/quadrature/panel_rule.h"
#include "solver/materials/surfaces/microfacets.h"
#include "solver/materials/surfaces/phong.h"
#include "solver/materials/surfaces/reflectance_table.h"
#include "solver/materials/surfaces/ward.h"

namespace etendue::reflectance_test {
namespace {

using std::numbers::pi;

const Vec3 up(0, 0, 1);

Vec3 direction(double angle, double azimuth) {
  return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
}

std::vector<std::shared_ptr<const Reflectance>> models() {
  std::vector<ReflectancePoint> points;
  for (const double in : {0., 30., 60., 90.})
    for (const double out : {0., 30., 60., 90.})
      for (const double azimuth : {0., 90., 180.})
        points.push_back({in, out, azimuth, 0.1 + 0.001 * (in + out) * (in > 0 && out > 0) * azimuth / 180});
  return {std::make_shared<Phong>(0.9, 0),
          std::make_shared<Phong>(0.8, 20),
          std::make_shared<Microfacets>(0.7, 0.3, FacetFresnel::constant),
          std::make_shared<Microfacets>(0.04, 0.6, FacetFresnel::schlick),
          std::make_shared<Ward>(1, 0.15),
          std::make_shared<Ward>(0.8, 0.6),
          std::make_shared<ReflectanceTable>(points, 1)};
}

/// Integral over all reflected directions of f_r cos g, by a product rule of order 6 in the angle and exact
/// for smooth functions of the azimuth.
template <class Function>
double reflected(const Reflectance& model, double angle_in, const Function& g) {
  constexpr int turns = 256;
  // Tables have kinks at every 30 degrees.
  return integral_by_panels(0, pi / 2, 300, [&](double angle) {
    double sum = 0;
    for (int i = 0; i < turns; ++i) {
      const Vec3 out = direction(angle, 2 * pi * (i + 0.5) / turns);
      sum += model.between(-direction(angle_in, 0), out, up) * out.z() * g(out);
    }
    return std::sin(angle) * sum * 2 * pi / turns;
  });
}

TEST(Reflectance, IsReciprocal) {
  for (const auto& model : models())
    for (const double in : {0.1, 0.7, 1.4})
      for (const double out : {0.3, 1.1, 1.5})
        for (const double azimuth : {0.2, 1.6, 3.0}) {
          const Vec3 i = direction(in, 0.4), o = direction(out, 0.4 + azimuth);
          const double there = model->between(-i, o, up);
          EXPECT_NEAR(there, model->between(-o, i, up), 1e-12 * there);
          EXPECT_GE(there, 0);
        }
}

TEST(Reflectance, AlbedoIsTheIntegralAndAtMostOne) {
  for (const auto& model : models()) {
    for (const double angle : {0., 0.4, 1.0, 1.4})
      EXPECT_NEAR(model->albedo(std::cos(angle)), reflected(*model, angle, [](const Vec3&) { return 1.; }),
                  1e-3);
    EXPECT_LE(model->albedo().largest(), 1);
  }
}

// Moments of the directions that photons take, by a grid of both numbers.
TEST(Reflectance, SamplesStandForTheIntegral) {
  constexpr int side = 400;
  for (const auto& model : models())
    for (const double angle : {0.2, 1.2}) {
      Vec3 mean = Vec3::Zero();
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
          const ReflectedRay ray = model->sample(std::cos(angle), (i + 0.5) / side, (j + 0.5) / side);
          EXPECT_NEAR(ray.direction.norm(), 1, 1e-12);
          mean += ray.weight * ray.direction / (side * side);
        }
      for (const int axis : {0, 1, 2})
        EXPECT_NEAR(mean[axis], reflected(*model, angle, [&](const Vec3& out) { return out[axis]; }), 2e-3)
            << axis;
    }
}

TEST(Reflectance, NothingIsReflectedThroughTheSurface) {
  for (const auto& model : models()) {
    EXPECT_EQ(model->between(direction(0.3, 0), direction(0.3, 0), up), 0);
    EXPECT_EQ(model->between(-direction(0.3, 0), -direction(0.3, 0), up), 0);
  }
}

// The integral of max(cos a, 0) cos over the half space, a from a direction at the angle g to the normal, is
// 2/3 (sin g + (pi - g) cos g).
TEST(Phong, AlbedoOfExponentOneHasAClosedForm) {
  const Phong model(0.6, 1);
  for (const double angle : {0., 0.3, 0.9, 1.5, pi / 2})
    EXPECT_NEAR(model.albedo(std::cos(angle)), 0.6 / pi * (std::sin(angle) + (pi - angle) * std::cos(angle)),
                1e-9);
}

TEST(Phong, ReflectsItsShareOfLightAlongTheNormal) {
  for (const double exponent : {0., 3., 1000.})
    EXPECT_NEAR(Phong(0.5, exponent).albedo(1), 0.5, 1e-9) << exponent;
}

TEST(Microfacets, SmoothOnesLoseNothing) {
  const Microfacets smooth(0.8, 0.01, FacetFresnel::constant);
  for (const double angle : {0., 0.5, 1.0}) EXPECT_NEAR(smooth.albedo(std::cos(angle)), 0.8, 1e-3);
}

// Schlick: r + (1 - r)(1 - cos)^5 of what a smooth surface reflects.
TEST(Microfacets, FresnelGrowsWithTheAngle) {
  const Microfacets smooth(0.04, 0.01, FacetFresnel::schlick);
  for (const double angle : {0., 0.6, 1.2})
    EXPECT_NEAR(smooth.albedo(std::cos(angle)), 0.04 + 0.96 * std::pow(1 - std::cos(angle), 5), 1e-3);
}

/// The mean weight of the directions that photons take, by a grid of both numbers.
double sampled_albedo(const Reflectance& model, double cos_in) {
  constexpr int side = 1000;
  double sum = 0;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) sum += model.sample(cos_in, (i + 0.5) / side, (j + 0.5) / side).weight;
  return sum / (side * side);
}

// Half of the half-way directions about a normal reflect light that grazes to below the surface, the others
// twice their share: at any roughness all of r is left. At no other angle is it more.
TEST(Ward, ReflectsItsShareOfLightThatGrazesAndLessOfOther) {
  for (const double roughness : {0.001, 0.05, 0.3, 1.}) {
    const Ward model(0.7, roughness);
    EXPECT_NEAR(sampled_albedo(model, 1e-8), 0.7, 1e-3) << roughness;
    EXPECT_EQ(model.albedo().largest(), 0.7) << roughness;
    EXPECT_EQ(model.albedo().angle_of_largest(), 90) << roughness;
  }
}

// Of light along the normal: with t = tan^2 d of the half-way direction, cos_o = (1 - t)/(1 + t) and the
// weight is r (1 - t), up to t = 1, so that the albedo is r (1 - a^2 (1 - exp(-1/a^2))).
TEST(Ward, AlbedoAlongTheNormalHasAClosedForm) {
  for (const double roughness : {0.001, 0.2, 0.6, 1.}) {
    const double a = roughness * roughness;
    EXPECT_NEAR(Ward(0.8, roughness).albedo(1), 0.8 * (1 - a * (1 - std::exp(-1 / a))), 1e-5) << roughness;
  }
}

// Ward (1992), eq. 4a: r/(4 pi a^2 sqrt(cos_i cos_o)) exp(-tan^2 d/a^2). In the mirrored direction the
// bounded one has 1/cos_i instead of its root, and about the normal of a smooth surface both are the same.
TEST(Ward, IsTheLobeOf1992AboutTheNormalOfASmoothSurface) {
  const double roughness = 0.05, peak = 0.8 / (4 * pi * roughness * roughness);
  const Ward model(0.8, roughness);
  for (const double angle : {0., 0.5, 1.2})
    EXPECT_NEAR(model.between(-direction(angle, 0), direction(angle, pi), up) * std::pow(std::cos(angle), 2),
                peak, 1e-9 * peak);
  for (const double angle : {0.02, 0.05, 0.1}) {
    const double tangent = std::tan(angle / 2);
    const double ward = peak / std::sqrt(std::cos(angle)) * std::exp(-std::pow(tangent / roughness, 2));
    EXPECT_NEAR(model.between(-up, direction(angle, 1), up), ward, 0.01 * ward) << angle;
  }
}

TEST(AlbedoTable, MeanOfAnAlbedoLikeTheCosine) {
  const AlbedoTable table([](double cos_in) { return cos_in; });
  EXPECT_NEAR(table.mean(), 2. / 3, 1e-9);
  EXPECT_EQ(table.largest(), 1);
  EXPECT_EQ(table.angle_of_largest(), 0);
}

}  // namespace
}  // namespace etendue::reflectance_test
