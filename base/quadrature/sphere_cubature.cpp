// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/quadrature/sphere_cubature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/quadrature/unit_rule.h"

namespace etendue {
namespace {

using std::numbers::pi;

constexpr std::size_t most_patches = 1500;
/// Patches of an octant along each side at the start, and the width of those at suspects.
constexpr int first_cuts = 2;
constexpr double suspect_width = 0.02;

/// [polar angle, azimuth] from … to, with the integrals over it.
struct OctantPatch {
  std::array<double, 2> from, to;
  std::array<double, 2> values{}, errors{};
};

std::array<double, 2> sum_over(const PairOnSphere& functions, const OctantPatch& patch,
                               const GaussRule& rule) {
  const double height = patch.to[0] - patch.from[0], width = patch.to[1] - patch.from[1];
  std::array<double, 2> sum{};
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double polar = patch.from[0] + height * rule.nodes[i], sine = std::sin(polar);
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const double azimuth = patch.from[1] + width * rule.nodes[j];
      const auto f = functions({sine * std::cos(azimuth), sine * std::sin(azimuth), std::cos(polar)});
      const double weight = rule.weights[i] * rule.weights[j] * height * width * sine;
      for (std::size_t k = 0; k < 2; ++k) sum[k] += weight * f[k];
    }
  }
  return sum;
}

/// Eight nodes along each side against five. The two may agree by chance where a kink passes: a half is
/// therefore no surer than what halving changed.
void integrate(const PairOnSphere& functions, OctantPatch& patch) {
  static const GaussRule fine = unit_rule(8), coarse = unit_rule(5);
  patch.values = sum_over(functions, patch, fine);
  const std::array<double, 2> other = sum_over(functions, patch, coarse);
  for (std::size_t k = 0; k < 2; ++k) patch.errors[k] = std::abs(patch.values[k] - other[k]);
}

/// In two, across the longer side as the sphere sees it.
std::array<OctantPatch, 2> halves(const OctantPatch& patch) {
  const double sine = std::sin(0.5 * (patch.from[0] + patch.to[0]));
  const std::size_t side =
      patch.to[0] - patch.from[0] >= sine * (patch.to[1] - patch.from[1]) ? std::size_t{0} : std::size_t{1};
  std::array<OctantPatch, 2> result = {patch, patch};
  result[0].to[side] = result[1].from[side] = 0.5 * (patch.from[side] + patch.to[side]);
  return result;
}

/// Both halves, integrated.
std::array<OctantPatch, 2> refined(const PairOnSphere& functions, const OctantPatch& patch) {
  std::array<OctantPatch, 2> two = halves(patch);
  for (OctantPatch& half : two) integrate(functions, half);
  for (std::size_t k = 0; k < 2; ++k) {
    const double change = std::abs(patch.values[k] - two[0].values[k] - two[1].values[k]);
    for (OctantPatch& half : two) half.errors[k] = std::max(half.errors[k], change);
  }
  return two;
}

bool is_wide(const OctantPatch& patch) {
  const double sine = std::sin(0.5 * (patch.from[0] + patch.to[0]));
  return std::max(patch.to[0] - patch.from[0], sine * (patch.to[1] - patch.from[1])) > suspect_width;
}

bool holds(const OctantPatch& patch, const Vec3& w) {
  const double polar = std::acos(std::clamp(w.z(), -1.0, 1.0));
  const double angle = std::atan2(w.y(), w.x()), azimuth = angle < 0 ? angle + 2 * pi : angle;
  return polar >= patch.from[0] && polar <= patch.to[0] && azimuth >= patch.from[1] && azimuth <= patch.to[1];
}

void add_with_suspects(const PairOnSphere& functions, const OctantPatch& patch,
                       const std::vector<Vec3>& suspects, std::vector<OctantPatch>& patches) {
  if (is_wide(patch) && std::ranges::any_of(suspects, [&](const Vec3& w) { return holds(patch, w); })) {
    for (const OctantPatch& half : halves(patch)) add_with_suspects(functions, half, suspects, patches);
    return;
  }
  patches.push_back(patch);
  integrate(functions, patches.back());
}

std::vector<OctantPatch> first_patches(const PairOnSphere& functions, const std::vector<Vec3>& suspects) {
  const double step = pi / 2 / first_cuts;
  std::vector<OctantPatch> patches;
  for (int i = 0; i < 2 * first_cuts; ++i)
    for (int j = 0; j < 4 * first_cuts; ++j)
      add_with_suspects(functions, {{i * step, j * step}, {(i + 1) * step, (j + 1) * step}}, suspects,
                        patches);
  return patches;
}

SphereIntegrals total(const std::vector<OctantPatch>& patches) {
  SphereIntegrals sum;
  for (const OctantPatch& patch : patches)
    for (std::size_t k = 0; k < 2; ++k) {
      sum.values[k] += patch.values[k];
      sum.errors[k] += patch.errors[k];
    }
  return sum;
}

}  // namespace

SphereIntegrals integrate_over_sphere(const PairOnSphere& functions, const std::vector<Vec3>& suspects,
                                      double relative) {
  std::vector<OctantPatch> patches = first_patches(functions, suspects);
  SphereIntegrals sum = total(patches);
  const auto share = [&](const OctantPatch& patch, std::size_t k) {
    return sum.errors[k] > 0 ? patch.errors[k] / sum.errors[k] : 0;
  };
  const auto urgency = [&](const OctantPatch& patch) { return std::max(share(patch, 0), share(patch, 1)); };
  const auto is_enough = [&] {
    return !(sum.errors[0] > relative * std::abs(sum.values[0])) &&
           !(sum.errors[1] > relative * std::abs(sum.values[1]));
  };
  // A heap by urgency would need rebuilding as the sums change; rounds over the worst tenth do not.
  while (!is_enough() && std::isfinite(sum.errors[0] + sum.errors[1]) && patches.size() < most_patches) {
    const std::size_t worst = std::max<std::size_t>(1, patches.size() / 10);
    std::ranges::nth_element(
        patches, patches.begin() + static_cast<std::ptrdiff_t>(worst),
        [&](const OctantPatch& a, const OctantPatch& b) { return urgency(a) > urgency(b); });
    for (std::size_t i = 0; i < worst; ++i) {
      const std::array<OctantPatch, 2> two = refined(functions, patches[i]);
      patches[i] = two[0];
      patches.push_back(two[1]);
    }
    sum = total(patches);
  }
  return sum;
}

}  // namespace etendue
