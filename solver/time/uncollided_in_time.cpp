// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/uncollided_in_time.h"

#include <algorithm>
#include <utility>

#include "base/parallel/parallel_for.h"
#include "base/vector_sums.h"

namespace etendue {
namespace {

/// Beams whose times differ by less than this part of them are one.
constexpr double together = 1e-4;

}  // namespace

UncollidedInTime::UncollidedInTime(const LightSetup& lights, const Slowness& slowness,
                                   std::shared_ptr<const UncollidedField> steady,
                                   const std::vector<TimedPlace>& places, int threads,
                                   const StageObserver& observer)
    : threads_(threads),
      times_(lights, slowness),
      remaining_(lights.remaining()),
      steady_(std::move(steady)),
      field_(times_, *steady_, threads, observer),
      places_(places.size()) {
  parallel_for(places.size(), threads, 1, [&](std::size_t i) {
    places_[i] = beams_at(places[i]);
    return true;
  });
}

std::vector<UncollidedInTime::Beam> UncollidedInTime::beams_at(const TimedPlace& place) const {
  std::vector<Beam> beams;
  LightBeams room = times_.room();
  for (std::size_t source = 0; source < times_.source_count(); ++source) {
    std::vector<Beam> own;
    times_.finest_beams_at(place.at, source, room, [&](const TimedBeam& beam) {
      const double seen = place.normal ? -place.normal->dot(beam.direction) : 1;
      if (seen <= 0) return;
      std::vector<double> light(beam.fluence.begin(), beam.fluence.end());
      for (double& value : light) value *= seen;
      own.push_back({source, beam.time, std::move(light)});
    });
    std::ranges::stable_sort(own, {}, &Beam::time);
    for (const Beam& beam : own)
      if (beams.empty() || beams.back().source != source || beam.time > beams.back().time * (1 + together))
        beams.push_back(beam);
      else
        add_to(beams.back().light, beam.light);
  }
  return beams;
}

EmissionCourses remaining_courses(const LightSetup& lights, const EmissionCourses& courses) {
  EmissionCourses result = courses;
  result.lights.clear();
  const auto all = lights.problem().lights();
  for (std::size_t l = 0; l < all.size(); ++l)
    if (all[l].uncollided == Uncollided::no) result.lights.push_back(courses.lights[l]);
  return result;
}

std::size_t UncollidedInTime::course_of(std::size_t source, const EmissionCourses& courses) const {
  const LightSetup::Emitter& emitter = lights().emitters()[source];
  switch (emitter.kind) {
    case LightSetup::Emitter::Kind::light:
      return courses.lights[emitter.number];
    case LightSetup::Emitter::Kind::region:
      return courses.regions[emitter.number];
    case LightSetup::Emitter::Kind::wall:
      break;
  }
  return courses.walls[emitter.number];
}

UncollidedValues UncollidedInTime::at(const DelayFactors& factors) const {
  const std::size_t bands = factors.count() * lights().paths().bands();
  UncollidedValues values{field_.shaped(factors), std::vector<double>(places_.size() * bands, 0)};
  set(factors, values);
  return values;
}

void UncollidedInTime::set(const DelayFactors& factors, UncollidedValues& values) const {
  field_.set(factors, threads_, values.field);
  set_places(factors, values.places);
}

void UncollidedInTime::set_places(const DelayFactors& factors, std::vector<double>& places) const {
  const std::size_t bands = lights().paths().bands(), all = factors.count() * bands;
  std::ranges::fill(places, 0);
  std::vector<double> own(factors.count());
  for (std::size_t i = 0; i < places_.size(); ++i)
    for (const Beam& beam : places_[i]) {
      factors.set(beam.source, beam.time, own);
      for (std::size_t f = 0; f < own.size(); ++f)
        for (std::size_t b = 0; b < bands; ++b)
          places[i * all + factors.band_of(f, b, bands)] += own[f] * beam.light[b];
    }
}

// A cell has some ten times of a point or beam, and some sixty of a wide light.
std::size_t UncollidedInTime::memory(const LightSetup& lights) {
  constexpr std::size_t of_point = 12, of_wide = 70, by_direction = 4;
  const Problem& problem = lights.problem();
  std::size_t bundles = 0;
  for (const auto& source : lights.sources()) bundles += source->as_wide() == nullptr ? of_point : of_wide;
  const std::size_t directional = CollisionField::estimate(lights.paths(), lights.sources()).bytes;
  if (directional > 0) bundles *= by_direction;
  const auto cells = static_cast<std::size_t>(problem.mesh().cell_count());
  return cells * bundles * sizeof(double) * (4 * lights.paths().bands() + 2) + 2 * directional;
}

}  // namespace etendue
