// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/visibility/path_attenuation.h"

#include <algorithm>
#include <cmath>

#include "solver/uncollided/sources/homogeneous_path.h"

namespace etendue {
namespace {

/// Less than that is nothing, but its logarithm is a number.
constexpr double least_path_transmittance = 1e-300;
/// Newton's steps end where they change the optical depth by less than that.
constexpr double last_step = 1e-13;
constexpr int most_newton_steps = 50;

/// Beams in one band as they would arrive through a homogeneous medium.
struct BeamSum {
  double fluence = 0;
  Vec3 flux = Vec3::Zero();
  double path = 0;  ///< fluence times length

  BeamSum(const LightBeams& beams, std::size_t band, double extinction = 0) {
    for (std::size_t i = 0; i < beams.size(); ++i) {
      const HomogeneousPath left = homogeneous_path(beams.interval(i), extinction);
      const double value = beams.fluence(i)[band] * left.transmittance;
      fluence += value;
      flux += value * beams.direction(i);
      path += value * left.mean;
    }
  }
};

/// The extinction at which this fluence of the clear beams is transmitted. The logarithm of the transmitted
/// fluence falls and is convex, so Newton's steps from the left never overshoot; the mean path begins there
/// (Jensen's inequality).
double effective_extinction(const LightBeams& clear, std::size_t band, double left) {
  BeamSum sum(clear, band);
  double extinction = std::log(sum.fluence / left) * sum.fluence / sum.path;
  for (int i = 0; i < most_newton_steps; ++i) {
    sum = BeamSum(clear, band, extinction);
    const double step = std::log(sum.fluence / left) * sum.fluence / sum.path;
    if (!(sum.fluence > 0) || !(step > 0)) break;
    extinction += step;
    if (step * sum.path < last_step * sum.fluence) break;
  }
  return extinction;
}

}  // namespace

Visibility sample(const ExtendedSource& source, const PointInCell& here, LightDetail detail,
                  LightBeams& beams, std::span<PathAttenuation> attenuation) {
  VisibleRaySamples samples(attenuation.size());
  source.sample(here, detail, samples);
  const LightBeams& clear = samples.clear;
  LightBeams open(attenuation.size());
  beams.clear();
  for (std::size_t i = 0; i < clear.size(); ++i) {
    if (!samples.is_open(i)) continue;
    std::ranges::copy(clear.fluence(i), open.add(clear.direction(i), clear.interval(i)).begin());
    std::copy_n(&samples.arriving[i * attenuation.size()], attenuation.size(),
                beams.add(clear.direction(i)).begin());
  }
  bool any_light = false;
  for (std::size_t b = 0; b < attenuation.size(); ++b) {
    attenuation[b] = {};
    const BeamSum all(clear, b), visible(open, b), arrived(beams, b);
    any_light = any_light || all.fluence > 0;
    if (all.fluence > 0) attenuation[b].visible = visible.fluence / all.fluence;
    if (!(visible.fluence > 0)) continue;
    attenuation[b].length = visible.path / visible.fluence;
    attenuation[b].extinction =
        effective_extinction(open, b, std::max(arrived.fluence, least_path_transmittance * visible.fluence));
    const BeamSum homogeneous(clear, b, attenuation[b].extinction);
    if (!(homogeneous.fluence > 0)) continue;
    if (open.size() < clear.size())
      attenuation[b].visible = BeamSum(open, b, attenuation[b].extinction).fluence / homogeneous.fluence;
    if (arrived.fluence > 0)
      attenuation[b].deflection = arrived.flux / arrived.fluence - homogeneous.flux / homogeneous.fluence;
  }
  if (!any_light) return Visibility::behind;
  return open.size() == 0             ? Visibility::nothing
         : open.size() < clear.size() ? Visibility::part
                                      : Visibility::all;
}

}  // namespace etendue
