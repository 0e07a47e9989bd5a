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

StageObserver part_of(const StageObserver& observer, double begin, double end) {
  if (!observer) return {};
  return [=](double share) { return observer(begin + (end - begin) * share); };
}

}  // namespace

UncollidedInTime::UncollidedInTime(const LightSetup& lights, const Slowness& slowness,
                                   std::shared_ptr<const UncollidedField> steady,
                                   const std::vector<TimedPlace>& places, int threads,
                                   const StageObserver& observer)
    : threads_(threads),
      times_(lights, slowness),
      remaining_(lights.remaining()),
      steady_(std::move(steady)),
      places_(places.size()) {
  std::vector<std::vector<std::size_t>> of_lights;
  for (std::size_t i = 0; i < lights.sources().size(); ++i) {
    // The beams of a fibre have one name.
    if (i == 0 || lights.sources()[i]->name() != lights.sources()[i - 1]->name()) of_lights.emplace_back();
    of_lights.back().push_back(i);
  }
  const double part = 1.0 / static_cast<double>(of_lights.size());
  for (std::size_t l = 0; l < of_lights.size(); ++l) {
    if (of_lights.size() == 1)
      fields_.push_back(
          std::make_unique<const DelayedField>(times_, steady_, of_lights.front(), threads_, observer));
    else
      add_light(std::move(of_lights[l]),
                part_of(observer, static_cast<double>(l) * part, static_cast<double>(l + 1) * part));
    if (!fields_.back()->is_complete()) return;
  }
  parallel_for(places.size(), threads, 1, [&](std::size_t i) {
    places_[i] = beams_at(places[i]);
    return true;
  });
}

void UncollidedInTime::add_light(std::vector<std::size_t> sources, const StageObserver& observer) {
  SourceViews views;
  for (const std::size_t i : sources) views.push_back(lights().sources()[i].get());
  auto own = std::make_shared<UncollidedField>(uncollided_field(
      lights().paths(), views, steady_->collisions.shared_directions(), threads_, part_of(observer, 0, 0.5)));
  own->net_flux = {};
  fields_.push_back(std::make_unique<const DelayedField>(times_, std::move(own), std::move(sources), threads_,
                                                         part_of(observer, 0.5, 1)));
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

UncollidedField UncollidedInTime::shaped(const DelayFactors& factors) const {
  const std::size_t count = factors.count(), own = lights().paths().bands();
  std::vector<int> bands(own * count);
  for (std::size_t f = 0; f < count; ++f)
    for (std::size_t b = 0; b < own; ++b) bands[factors.band_of(f, b, own)] = static_cast<int>(b);
  UncollidedField field;
  field.fluence.assign(steady_->fluence.size() * count, 0);
  field.irradiance.assign(steady_->irradiance.size() * count, 0);
  field.collided.assign(steady_->collided.size() * count, 0);
  field.absorbed.assign(steady_->absorbed.size() * count, 0);
  if (!steady_->collisions.empty()) field.collisions = steady_->collisions.with_bands(bands.size());
  field.glossy = steady_->glossy.of_bands(bands);
  return field;
}

UncollidedValues UncollidedInTime::at(const DelayFactors& factors) const {
  const std::size_t bands = factors.count() * lights().paths().bands();
  UncollidedValues values{shaped(factors), std::vector<double>(places_.size() * bands, 0)};
  set(factors, values);
  return values;
}

void UncollidedInTime::set(const DelayFactors& factors, UncollidedValues& values) const {
  UncollidedField& field = values.field;
  for (std::vector<double>* of : {&field.fluence, &field.irradiance, &field.collided, &field.absorbed})
    std::ranges::fill(*of, 0);
  field.collisions.clear_values();
  for (const auto& light : fields_) light->add_to(factors, threads_, field);
  set_places(factors, values.places);
}

void UncollidedInTime::set_places(const DelayFactors& factors, std::vector<double>& places) const {
  const std::size_t bands = lights().paths().bands(), all = factors.count() * bands;
  std::ranges::fill(places, 0);
  std::vector<double> own(factors.count());
  for (std::size_t i = 0; i < places_.size(); ++i)
    for (const Beam& beam : places_[i]) {
      factors.set({beam.source, beam.time, 0}, own);
      for (std::size_t f = 0; f < own.size(); ++f)
        for (std::size_t b = 0; b < bands; ++b)
          places[i * all + factors.band_of(f, b, bands)] += own[f] * beam.light[b];
    }
}

// A cell has some twelve times of a point or beam and some hundred and fifty of a wide light, each from about
// six directions where these count.
std::size_t UncollidedInTime::memory(const LightSetup& lights, std::size_t factors) {
  constexpr std::size_t of_point = 12, of_wide = 150, by_direction = 6;
  std::size_t bundles = 0;
  for (const auto& source : lights.sources()) bundles += source->as_wide() == nullptr ? of_point : of_wide;
  const std::size_t directional = CollisionField::estimate(lights.paths(), lights.sources()).bytes;
  if (directional > 0) bundles *= by_direction;
  const auto cells = static_cast<std::size_t>(lights.problem().mesh().cell_count());
  const std::size_t fields = 4 * lights.paths().bands() * (lights.sources().size() + factors + 4);
  return cells * sizeof(double) * (bundles * (4 * lights.paths().bands() + 2) + fields) +
         (2 + factors) * directional;
}

}  // namespace etendue
