// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/sampling/kernel_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "base/text/vector_text.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/photons/kernel/photon_turns.h"

namespace etendue {
namespace {

using std::numbers::pi;

// Rings are even in t, where 1 - cosine = 2 t^2.
constexpr std::size_t rings = 240;
// In each ring so many angles and azimuths are sampled: at one place, or at each of many.
struct Looks {
  int angles, azimuths;
};
constexpr Looks at_one = {3, 24}, at_many = {1, 8};
// What is missed between them; neighbouring rings count too.
constexpr double ring_margin = 1.15;

std::size_t ring_of(double t) {
  return std::min(rings - 1, static_cast<std::size_t>(t * static_cast<double>(rings)));
}

/// At t from `before`.
Vec3 turned(const Vec3& before, double t, double cosine, double sine) {
  double w[3] = {before.x(), before.y(), before.z()};
  turn(w, 1 - 2 * t * t, cosine, sine);
  return {w[0], w[1], w[2]};
}

}  // namespace

KernelBound::KernelBound(const KernelFormula& kernel, const std::vector<Vec3>& places) : bound_(rings, 0) {
  const bool one = places.size() == 1;
  const DirectionSet set = one ? directions_ldfe_sq(1) : directions_triangular(4);
  std::vector<Vec3> befores(set.directions().begin(), set.directions().end());
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) befores.emplace_back(sign * Vec3::Unit(axis));
  const Looks looks = one ? at_one : at_many;
  KernelFormula there = kernel;
  for (const Vec3& place : places) {
    there.place = place;
    for (const Vec3& before : befores) {
      for (std::size_t ring = 0; ring < rings; ++ring)
        for (int i = 0; i < looks.angles; ++i)
          for (int j = 0; j < looks.azimuths; ++j) {
            const double t =
                (static_cast<double>(ring) + (i + 0.5) / looks.angles) / static_cast<double>(rings);
            const double azimuth = 2 * pi * j / looks.azimuths;
            look(there, before, turned(before, t, std::cos(azimuth), std::sin(azimuth)));
          }
      // Where formulas put mirrors and peaks.
      for (int octant = 1; octant < 8; ++octant)
        look(there, before,
             Vec3(octant & 1 ? -before.x() : before.x(), octant & 2 ? -before.y() : before.y(),
                  octant & 4 ? -before.z() : before.z()));
    }
  }
  const std::vector<double> seen = bound_;
  for (std::size_t ring = 0; ring < rings; ++ring) {
    const double before = ring > 0 ? seen[ring - 1] : 0, behind = ring + 1 < rings ? seen[ring + 1] : 0;
    bound_[ring] = ring_margin * std::max({before, seen[ring], behind});
    const double from = static_cast<double>(ring) / rings, to = static_cast<double>(ring + 1) / rings;
    cumulative_.push_back((ring > 0 ? cumulative_.back() : 0) +
                          4 * pi * (to * to - from * from) * bound_[ring]);
  }
}

void KernelBound::look(const KernelFormula& kernel, const Vec3& before, const Vec3& after) {
  const double t = (after - before).norm() / 2;
  if (t < 1e-6) return;
  const double value = kernel.at(before, after);
  if (!(value >= 0 && std::isfinite(value)))
    throw InputError(
        fmt::format("the kernel is {:.6g} from {} into {}; must be a finite number of at least 0", value,
                    vector_text(before), vector_text(after)));
  double& bound = bound_[ring_of(t)];
  bound = std::max(bound, value);
}

KernelBound::Draw KernelBound::draw(const Vec3& before, DrawnNumbers& random) const {
  const double wanted = random.number() * total();
  const auto above = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, wanted);
  const auto ring = static_cast<std::size_t>(above - cumulative_.begin());
  const double from = static_cast<double>(ring) / rings, to = static_cast<double>(ring + 1) / rings;
  const double t = std::sqrt(from * from + random.number() * (to * to - from * from));
  double c, s;
  unit_circle(random.word(), c, s);
  return {turned(before, t, c, s), bound_[ring]};
}

}  // namespace etendue
