// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/timed_sources.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "solver/problem/darkened.h"

namespace etendue {
namespace {

/// Factors below are 0: squares of such light would leave the range of numbers.
constexpr double darkness = 1e-30;

template <class Values>
bool any_positive(const Values& values) {
  return std::ranges::any_of(values, [](double value) { return value > 0; });
}

template <class Formulas>
bool any_formula(const Formulas& formulas) {
  return std::ranges::any_of(formulas, [](const auto& formula) { return formula.has_value(); });
}

Medium without_isotropic_emission(Medium medium) {
  medium.emission.assign(medium.emission.size(), Coefficient(0.0));
  medium.blackbody.clear();
  medium.uncollided = Uncollided::no;
  return medium;
}

Wall without_isotropic_radiance(Wall wall) {
  wall.radiance.assign(wall.radiance.size(), 0.0);
  wall.uncollided = Uncollided::no;
  return wall;
}

/// The problem with those sources alone that depend on the direction and follow a course; they are left to
/// the directions. Null without any.
std::unique_ptr<Problem> directional_part(const Problem& problem, const EmissionCourses& courses,
                                          std::size_t course) {
  bool has_any = false;
  std::vector<Medium> media;
  for (std::size_t r = 0; r < problem.media().size(); ++r) {
    media.push_back(without_isotropic_emission(problem.media()[r]));
    if (courses.regions[r] != course) media.back().emission_by_direction.clear();
    has_any |= any_formula(media.back().emission_by_direction);
  }
  std::vector<Wall> walls;
  for (std::size_t w = 0; w < problem.walls().size(); ++w) {
    walls.push_back(without_isotropic_radiance(problem.walls()[w]));
    if (courses.walls[w] != course) walls.back().radiance_by_direction.clear();
    has_any |= any_formula(walls.back().radiance_by_direction);
  }
  std::vector<Light> lights;
  for (std::size_t l = 0; l < problem.lights().size(); ++l) {
    if (courses.lights[l] != course) continue;
    lights.push_back(problem.lights()[l]);
    lights.back().uncollided = Uncollided::no;
  }
  has_any |= !lights.empty();
  if (!has_any) return nullptr;
  return std::make_unique<Problem>(problem.mesh(), problem.bands(), std::move(media), std::move(walls),
                                   problem.space(), std::move(lights));
}

}  // namespace

bool emits(const Wall& wall) {
  return any_positive(wall.radiance) || any_formula(wall.radiance_by_direction);
}

Problem darkened(const Problem& problem) {
  std::vector<Medium> media(problem.media().begin(), problem.media().end());
  for (Medium& medium : media) {
    darken(medium);
    medium.uncollided = Uncollided::no;
  }
  std::vector<Wall> walls(problem.walls().begin(), problem.walls().end());
  for (Wall& wall : walls) {
    wall.emission_follows = any_positive(wall.radiance);
    darken(wall);
    wall.uncollided = Uncollided::no;
  }
  return Problem(problem.mesh(), problem.bands(), std::move(media), std::move(walls), problem.space());
}

TimedSources::TimedSources(const Problem& problem, const DirectionSet& directions,
                           const EmissionCourses& courses)
    : problem_(problem), courses_(courses), directional_(courses.courses.size()) {
  check(courses);
  for (std::size_t course = 0; course < courses.courses.size(); ++course) {
    add_directional(course, directions);
    add_power(course);
  }
}

void TimedSources::check(const EmissionCourses& courses) const {
  const auto has_courses = [&](const std::vector<std::size_t>& of, std::size_t count) {
    return of.size() == count &&
           std::ranges::all_of(of, [&](std::size_t course) { return course < courses.courses.size(); });
  };
  if (!has_courses(courses.regions, problem_.media().size()) ||
      !has_courses(courses.walls, problem_.walls().size()) ||
      !has_courses(courses.lights, problem_.lights().size()))
    throw std::invalid_argument("a source without a course in time");
  for (std::size_t w = 0; w < problem_.walls().size(); ++w)
    if (courses.courses[courses.walls[w]].is_pulse && emits(problem_.walls()[w]))
      throw std::invalid_argument("a pulse through wall " + problem_.walls()[w].name);
  for (std::size_t l = 0; l < problem_.lights().size(); ++l)
    if (courses.courses[courses.lights[l]].is_pulse &&
        std::holds_alternative<BeamLight>(problem_.lights()[l].kind))
      throw std::invalid_argument("a pulse through a wall, of beam " + problem_.lights()[l].name);
}

void TimedSources::add_directional(std::size_t course, const DirectionSet& directions) {
  Directional& own = directional_[course];
  own.problem = directional_part(problem_, courses_, course);
  if (own.problem == nullptr) return;
  own.lights = std::make_unique<OrdinateLights>(*own.problem, directions, nullptr);
  own.emission = std::make_unique<DirectionalEmission>(*own.problem, directions, own.lights.get());
}

void TimedSources::add_power(std::size_t course) {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  std::vector<double> power(bands, 0);
  const TetrahedralMesh& mesh = problem_.mesh();
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (courses_.regions[static_cast<std::size_t>(mesh.region(cell))] != course) continue;
    for (std::size_t b = 0; b < bands; ++b)
      power[b] +=
          full_range(problem_.space()) * problem_.emission(cell, static_cast<int>(b)) * mesh.volume(cell);
  }
  const Directional& own = directional_[course];
  if (own.problem != nullptr) {
    for (std::size_t b = 0; b < own.lights->power_inside().size(); ++b)
      power[b] += own.lights->power_inside()[b];
    for (const std::vector<double>& region : own.emission->powers().regions)
      for (std::size_t b = 0; b < bands; ++b) power[b] += region[b];
  }
  power_.push_back(std::move(power));
}

std::vector<double> TimedSources::factors_at(double t) const {
  std::vector<double> factors;
  for (const Course& course : courses_.courses) {
    const double factor = course.is_pulse ? 0 : course.factor(t);
    factors.push_back(std::abs(factor) < darkness ? 0 : factor);
  }
  return factors;
}

FollowingSources TimedSources::isotropic_at(double t) const {
  const std::vector<double> factors = factors_at(t);
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  FollowingSources sources;
  sources.cells = CellEmission(static_cast<std::size_t>(mesh.cell_count()), bands);
  const CellEmission& emission = problem_.cell_emission();
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const double factor = factors[courses_.regions[static_cast<std::size_t>(mesh.region(cell))]];
    if (factor == 0) continue;
    for (std::size_t b = 0; b < bands; ++b) {
      std::array<double, 4> slope = {};
      for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = factor * emission.slope(cell, b, i);
      sources.cells.add(cell, b, factor * emission.mean(cell, b), slope);
    }
  }
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const auto w = static_cast<std::size_t>(mesh.wall(FaceIndex(f)));
    const Wall& wall = problem_.walls()[w];
    // Radiance grows by the square of the index where light enters.
    const double factor = factors[courses_.walls[w]] * std::pow(wall.refractive_index, 2);
    for (int vertex = 0; vertex < 3; ++vertex)
      for (std::size_t b = 0; b < bands; ++b) sources.radiance.push_back(factor * wall.radiance[b]);
  }
  return sources;
}

template <class Add>
void TimedSources::add_scaled(std::span<const double> factors, std::span<double> values,
                              const Add& add) const {
  for (std::size_t course = 0; course < directional_.size(); ++course) {
    if (directional_[course].problem == nullptr || factors[course] == 0) continue;
    std::vector<double> part(values.size(), 0);
    add(*directional_[course].emission, part);
    for (std::size_t i = 0; i < part.size(); ++i) values[i] += factors[course] * part[i];
  }
}

void TimedSources::add_source(std::span<const double> factors, OrdinateIndex m, CellIndex cell,
                              std::span<double> values) const {
  add_scaled(factors, values,
             [&](const AngularInput& of, std::span<double> to) { of.add_source(m, cell, to); });
}

void TimedSources::add_inflow(std::span<const double> factors, OrdinateIndex m, FaceIndex face,
                              std::span<double> values) const {
  add_scaled(factors, values,
             [&](const AngularInput& of, std::span<double> to) { of.add_inflow(m, face, to); });
}

void TimedSources::add_pulses(OrdinateIndex m, CellIndex cell, std::span<double> values) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  const std::size_t region = static_cast<std::size_t>(problem_.mesh().region(cell));
  if (courses_.courses[courses_.regions[region]].is_pulse)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t b = 0; b < bands; ++b)
        values[i * bands + b] += problem_.cell_emission().at(cell, b, i);
  for (std::size_t course = 0; course < directional_.size(); ++course)
    if (directional_[course].problem != nullptr && courses_.courses[course].is_pulse)
      directional_[course].emission->add_source(m, cell, values);
}

bool TimedSources::has_pulses() const {
  return std::ranges::any_of(courses_.courses, [](const Course& course) { return course.is_pulse; });
}

std::vector<double> TimedSources::power_inside(double t) const {
  const std::vector<double> factors = factors_at(t);
  std::vector<double> power(static_cast<std::size_t>(problem_.band_count()), 0);
  for (std::size_t course = 0; course < factors.size(); ++course)
    for (std::size_t b = 0; b < power.size(); ++b) power[b] += factors[course] * power_[course][b];
  return power;
}

}  // namespace etendue
