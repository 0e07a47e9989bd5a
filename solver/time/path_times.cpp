// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/path_times.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mesh/tetrahedra/bounding_box.h"
#include "solver/uncollided/sources/beam_source.h"

namespace etendue {
namespace {

/// Times of the bands of a beam, or within one, that differ by less than this part of them are
/// one.
constexpr double same_time = 1e-6;

/// Of light with an extent that lights up or goes out part by part.
constexpr LightDetail finest_light{0.2, 0.01, 0.15, 0.04, TriangleRule::seven_points};

/// How often each band is there.
constexpr std::size_t copies = 3;

Problem with_copies(const Problem& problem) {
  std::vector<int> bands(copies * static_cast<std::size_t>(problem.band_count()));
  for (std::size_t b = 0; b < bands.size(); ++b) bands[b] = static_cast<int>(b) % problem.band_count();
  return problem.of_bands(bands);
}

/// Extinction by time, none in the first copy of the bands, [cell][band].
std::vector<double> extinction_by_time(const Problem& copied, const Slowness& slowness, double rate) {
  const auto bands = static_cast<std::size_t>(copied.band_count());
  std::vector<double> extinction;
  for (std::int32_t c = 0; c < copied.mesh().cell_count(); ++c) {
    const double slow = slowness[static_cast<std::size_t>(copied.mesh().region(CellIndex(c)))];
    for (std::size_t b = 0; b < bands; ++b)
      extinction.push_back(static_cast<double>(b / (bands / copies)) * rate * slow);
  }
  return extinction;
}

/// At which light from one end of the domain is attenuated to 1/e at the other.
double rate_of_domain(const Problem& problem, const Slowness& slowness) {
  return 1 / (bounding_box(problem.mesh().points()).diagonal() * *std::ranges::max_element(slowness));
}

}  // namespace

PathTimes::PathTimes(const LightSetup& lights, const Slowness& slowness)
    : lights_(lights),
      slowness_(slowness),
      rate_(rate_of_domain(lights.problem(), slowness)),
      problem_(with_copies(lights.problem())),
      timed_(problem_, extinction_by_time(problem_, slowness, rate_)) {
  if (timed_.sources().size() != lights.sources().size())
    throw std::logic_error("lights with times that are not those without");
}

void PathTimes::beams_at(const PointInCell& at, std::size_t source, LightDetail detail, LightBeams& room,
                         const TimedBeamReader& reader) const {
  room.clear();
  timed_.sources()[source]->add_beams(at, Sight::attenuated, detail, room);
  const std::size_t bands = lights_.paths().bands();
  std::vector<Times> times(bands);
  std::vector<double> alone(bands);
  for (std::size_t k = 0; k < room.size(); ++k) {
    const std::span<const double> fluence = room.fluence(k).first(bands);
    double first = std::numeric_limits<double>::infinity(), last = 0;
    for (std::size_t b = 0; b < bands; ++b) {
      times[b] = times_of(room.fluence(k), b);
      if (!(fluence[b] > 0) || std::isinf(times[b].mean)) continue;
      first = std::min(first, times[b].mean - times[b].deviation);
      last = std::max(last, times[b].mean + times[b].deviation);
    }
    if (first > last) continue;  // all dark
    if (last - first <= same_time * last) {
      reader({source, room.direction(k), last, fluence});
      continue;
    }
    // Light from a volume: half of it a deviation before its mean time, and half behind.
    for (std::size_t b = 0; b < bands; ++b)
      for (const double side : {-1.0, 1.0}) {
        std::ranges::fill(alone, 0);
        alone[b] = fluence[b] / 2;
        const double time = times[b].mean + side * times[b].deviation;
        if (fluence[b] > 0 && std::isfinite(time))
          reader({source, room.direction(k), std::max(0.0, time), alone});
      }
  }
}

std::optional<double> PathTimes::time_of_beam(const PointInCell& at, std::size_t source) const {
  const BeamSource* const beam = timed_.sources()[source]->as_beam();
  if (beam == nullptr) return std::nullopt;
  std::vector<double> left(timed_.paths().bands());
  for (const Vec3& direction : beam->directions()) {
    if (!timed_.paths().leave(at, -direction, left)) continue;
    const double time = times_of(left, 0).mean;
    if (std::isfinite(time)) return time;
  }
  return std::nullopt;
}

// log f(k a) = log f(0) - k a m + (k a)^2 v / 2 - ..., with the mean m and the variance v of the times.
PathTimes::Times PathTimes::times_of(std::span<const double> copied, std::size_t band) const {
  const std::size_t bands = copied.size() / copies;
  const double once = copied[bands + band], twice = copied[2 * bands + band];
  if (!(once > 0)) return {std::numeric_limits<double>::infinity(), 0};
  const double first = std::log(copied[band] / once) / rate_;
  if (!(twice > 0)) return {first, 0};
  const double second = std::log(copied[band] / twice) / rate_;
  const double variance = (2 * first - second) / rate_, mean = first + rate_ * variance / 2;
  // What rounding leaves of the difference of two logarithms is no depth.
  const double rounding = 1e-10 * mean * mean + 1e-13 / (rate_ * rate_);
  return {std::max(0.0, mean), variance > rounding ? std::sqrt(variance) : 0};
}

void PathTimes::finest_beams_at(const PointInCell& at, std::size_t source, LightBeams& room,
                                const TimedBeamReader& reader) const {
  LightDetail detail = finest_light;
  detail.shadow_edges = &timed_.shadow_edges();
  beams_at(at, source, detail, room, reader);
}

}  // namespace etendue
