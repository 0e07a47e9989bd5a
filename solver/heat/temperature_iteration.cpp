// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/temperature_iteration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/vector_sums.h"
#include "solver/heat/heat_sinks.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue {
namespace {

constexpr std::size_t remembered_steps = 5;
/// Largest factor between two temperatures that follow each other: emission grows as T^4. And of T^4.
constexpr double largest_factor = 1.5, largest_factor_of_power = 5;
/// Largest change of T^4 over the highest of them, where it may pass through zero.
constexpr double largest_change = 0.1;
/// Of the highest temperature: colder ones are as cold as this where changes are measured.
constexpr double least_part = 1e-3;

std::vector<double> divided(std::vector<double> values, double divisor) {
  for (double& value : values) value /= divisor;
  return values;
}

}  // namespace

TemperatureIteration::TemperatureIteration(const Problem& problem, const HeatProblem& heat)
    : problem_(problem),
      space_(problem, heat),
      balance_(problem, heat, space_),
      diffusion_(problem, space_, balance_),
      storage_(problem, heat, space_),
      mixing_(balance_.volumes(), remembered_steps),
      values_(storage_.start()) {
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = space_.value(i, values_[i]);
  check_media();
  if (!heat.changes_in_time) {
    check_conductors();
    check_heat_sinks(problem, heat, space_);
  }
  set_sources();
}

void TemperatureIteration::check_media() const {
  const std::vector<double> capacity = storage_.capacity(storage_.start());
  const TetrahedralMesh& mesh = problem_.mesh();
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (!space_.has(cell) || space_.conducts(cell)) continue;
    if (absorption_of_all_bands(problem_, cell) > 0) continue;
    if (capacity[static_cast<std::size_t>(space_.unknown(cell, 0))] > 0) continue;
    const Vec3 place = mesh.centroid(cell);
    throw InputError(fault_at(
        problem_.medium(mesh.region(cell)).origin, "",
        fmt::format("neither absorbs nor conducts at ({:.6g}, {:.6g}, {:.6g}), so its temperature does not "
                    "follow from its heat; give absorption, conductivity or a heat capacity",
                    place.x(), place.y(), place.z())));
  }
}

void TemperatureIteration::check_conductors() const {
  const TetrahedralMesh& mesh = problem_.mesh();
  std::vector<char> is_checked(static_cast<std::size_t>(mesh.cell_count()), 0);
  std::vector<char> is_held(is_checked.size(), 0);
  for (const HeldFace& held : balance_.conduction().held_faces()) is_held[held.cell.at()] = 1;
  for (std::int32_t first = 0; first < mesh.cell_count(); ++first) {
    if (is_checked[static_cast<std::size_t>(first)] != 0 || !space_.conducts(CellIndex(first))) continue;
    bool gives_heat = false;
    std::vector<CellIndex> waiting = {CellIndex(first)};
    is_checked[static_cast<std::size_t>(first)] = 1;
    while (!waiting.empty()) {
      const CellIndex cell = waiting.back();
      waiting.pop_back();
      gives_heat = gives_heat || is_held[cell.at()] != 0 || absorption_of_all_bands(problem_, cell) > 0;
      for (const std::int32_t f : mesh.faces(cell)) {
        if (f < mesh.boundary_face_count()) continue;
        const CellIndex other =
            mesh.owner(FaceIndex(f)) == cell ? mesh.neighbour(FaceIndex(f)) : mesh.owner(FaceIndex(f));
        if (!space_.conducts(other) || is_checked[other.at()] != 0) continue;
        is_checked[other.at()] = 1;
        waiting.push_back(other);
      }
    }
    if (gives_heat) continue;
    const Vec3 place = mesh.centroid(CellIndex(first));
    throw InputError(fault_at(problem_.medium(mesh.region(CellIndex(first))).origin, "",
                              fmt::format("neither absorbs nor touches a wall with a temperature about "
                                          "({:.6g}, {:.6g}, {:.6g}), so nothing "
                                          "takes its heat away; give a wall a temperature",
                                          place.x(), place.y(), place.z())));
  }
}

void TemperatureIteration::set_sources() {
  temperature_ = space_.temperatures(values_);
  balance_.set_temperature(temperature_);
  blackbodies_ = balance_.blackbodies(temperature_);
  sources_ = balance_.sources(blackbodies_);
}

void TemperatureIteration::start_from(std::span<const double> state) {
  if (state.size() != values_.size())
    throw InputError(
        fmt::format("the solution to start from has {} temperatures where this case has {}; start without it",
                    state.size(), values_.size()));
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = space_.value(i, state[i]);
  set_sources();
}

double TemperatureIteration::improve(const LightAtVertices& light) {
  std::vector<double> fluence(light.fluence.begin(), light.fluence.end());
  std::vector<double> irradiance(light.irradiance.begin(), light.irradiance.end());
  if (!unswept_.fluence.empty()) add_to(fluence, unswept_.fluence);
  if (!unswept_.irradiance.empty()) add_to(irradiance, unswept_.irradiance);
  const std::vector<double> gains = residual({fluence, irradiance, light.half_range});
  std::vector<double> inertia(values_.size(), 0);
  if (stage_) inertia = divided(storage_.capacity(temperature_), stage_->length);
  const std::vector<double> changes = diffusion_.changes(temperature_, blackbodies_, gains, inertia);
  const std::vector<double> step = mixing_.step(values_, changes);
  const double highest = highest_temperature(temperature_);
  change_ = 0;
  for (std::size_t i = 0; i < step.size(); ++i) {
    if (!std::isfinite(step[i]))
      throw NotFiniteError(
          "the temperatures that follow from heat grow without end: something must take the heat away, or "
          "steps in time be shorter");
    // Stored heat counts kelvins, and steady heat what is emitted at the highest temperature.
    const double kelvin = stage_ ? std::max(std::abs(temperature_[i]), least_part * highest) : highest;
    change_ = std::max(change_, std::abs(changes[i]) * space_.kelvin_per_value(i, kelvin) / highest);
    values_[i] += limited(i, step[i], highest);
  }
  set_sources();
  return change_;
}

/// What the unknowns gain and do not store [W].
std::vector<double> TemperatureIteration::residual(const LightAtVertices& light) const {
  std::vector<double> gains = balance_.gains(temperature_, blackbodies_, light);
  if (!stage_) return gains;
  const std::vector<double> held = storage_.heat(stage_->before, temperature_);
  for (std::size_t i = 0; i < gains.size(); ++i) gains[i] -= (held[i] - stage_->stored[i]) / stage_->length;
  return gains;
}

double TemperatureIteration::missing_heat(const Solution& solution) const {
  const std::vector<double> left = residual({solution.fluence, solution.irradiance, solution.half_range});
  return std::accumulate(left.begin(), left.end(), 0.0);
}

void TemperatureIteration::set_stage(HeatStage stage) {
  balance_.set_time(stage.t);
  stage_ = std::move(stage);
  mixing_ = AndersonMixing(balance_.volumes(), remembered_steps);
}

/// A change that does not go too far; `highest` is the highest temperature [K].
double TemperatureIteration::limited(std::size_t unknown, double change, double highest) const {
  const double value = values_[unknown];
  if (space_.is_temperature(unknown))
    return std::clamp(change, value / largest_factor - value, value * largest_factor - value);
  const double room = largest_change * space_.value(unknown, highest);
  return std::clamp(change, -std::abs(value) - room, (largest_factor_of_power - 1) * std::abs(value) + room);
}

std::string TemperatureIteration::note() const {
  return fmt::format("largest change of a temperature in the last one: {:.2g} of the highest", change_);
}

std::vector<double> TemperatureIteration::temperatures() const {
  const auto cells = static_cast<std::size_t>(problem_.mesh().cell_count());
  std::vector<double> result(4 * cells, 0);
  for (std::size_t c = 0; c < cells; ++c) {
    const CellIndex cell(static_cast<std::int32_t>(c));
    for (std::size_t i = 0; i < 4 && space_.has(cell); ++i)
      result[4 * c + i] = std::max(0.0, temperature_[static_cast<std::size_t>(space_.unknown(cell, i))]);
  }
  return result;
}

std::vector<double> TemperatureIteration::wall_temperatures() const {
  std::vector<double> result(static_cast<std::size_t>(3 * problem_.mesh().boundary_face_count()), 0);
  for (const FollowingFace& face : balance_.walls().faces())
    for (std::size_t i = 0; i < 3; ++i)
      result[3 * face.face.at() + i] = std::max(0.0, temperature_[face.unknowns[i]]);
  return result;
}

double TemperatureIteration::cells_per_layer() const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  double most = 0;
  for (const HeldFace& held : balance_.conduction().held_faces()) {
    const double height = 3 * problem_.mesh().volume(held.cell) / held.area;
    for (const std::size_t corner : held.corners) {
      const auto unknown = static_cast<std::size_t>(space_.unknown(held.cell, corner));
      double emission = 0;  // w of (T3)
      for (std::size_t band = 0; band < bands; ++band)
        emission += 4 * std::numbers::pi * problem_.absorption(held.cell, static_cast<int>(band)) *
                    blackbodies_.slope[unknown * bands + band];
      most = std::max(most, height * std::sqrt(emission / balance_.conduction().conductivity(held.cell)));
    }
  }
  return most;
}

HeatSolution TemperatureIteration::solution() const {
  return {temperatures(), wall_temperatures(), balance_.conduction().conducted(temperature_),
          balance_.walls().convected(temperature_), cells_per_layer()};
}

}  // namespace etendue
