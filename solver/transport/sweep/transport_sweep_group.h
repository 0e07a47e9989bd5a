// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// The sweep of a batch of ordinates through the mesh, group by group.
// Part of TransportSweep, for its source file alone.
#include <algorithm>

#include "solver/transport/sweep/sweep_workspace.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {
namespace {

/// So many numbers, rounded up to cache lines.
template <class Real>
std::size_t whole_lines(std::size_t length) {
  constexpr std::size_t line = 64 / sizeof(Real);
  return (length + line - 1) / line * line;
}

}  // namespace

// The scratch row ends with a cache line, so that wide lanes do not straddle two of them in the rows behind
// it.
template <class Real>
std::size_t TransportSweepOf<Real>::angular_length() const {
  if (scattering_.row_count() == 0) return 0;
  return whole_lines<Real>(scattering_.row_length()) +
         whole_lines<Real>(scattering_.row_count() * scattering_.row_length());
}

template <class Real>
Real* TransportSweepOf<Real>::angular_at(std::int32_t place, Workspace& work) const {
  if (work.angular.size() == 0) return nullptr;
  return work.angular.data() + static_cast<std::size_t>(place % schedule_.batch()) * angular_length() +
         whole_lines<Real>(scattering_.row_length()) - scattering_.row_length();
}

template <class Real>
std::vector<Real*> TransportSweepOf<Real>::angular_rows(std::int32_t batch, Workspace& work) const {
  std::vector<Real*> rows;
  const MomentOrbits& orbits = scattering_.orbits();
  const int end = std::min(orbits.count(), first_orbit(batch + 1));
  for (int orbit = first_orbit(batch); orbit < end; ++orbit)
    for (const OrdinateIndex m : orbits.ordinates(orbit))
      rows.push_back(angular_at(schedule_.place_of(m), work) + scattering_.row_length());
  return rows;
}

template <class Real>
MomentTaskOf<Real> TransportSweepOf<Real>::moment_task(const std::vector<Real*>& rows) const {
  MomentTaskOf<Real> task;
  task.row_length = scattering_.row_length();
  task.moments = scattering_.moment_count();
  task.orbit_size = scattering_.orbits().size();
  task.class_begin = scattering_.orbits().class_begin().data();
  task.order = scattering_.orbits().order().data();
  task.orbits = static_cast<int>(rows.size()) / task.orbit_size;
  task.direction_rows = rows.data();
  return task;
}

template <class Real>
bool TransportSweepOf<Real>::shines_by_direction() const {
  return options_.angular_input != nullptr && emission_ == Emission::included;
}

template <class Real>
void TransportSweepOf<Real>::form_angular_source(std::int32_t batch, Workspace& work) {
  const std::int32_t first = batch * schedule_.batch();
  const std::int32_t end = schedule_.batch_end(batch);
  const std::vector<Real*> rows = angular_rows(batch, work);
  MomentTaskOf<Real> task = moment_task(rows);
  task.matrix = evaluation_.data() + factors_begin(batch);
  task.moment_rows = moment_source_.data();
  task.last_row = scattering_.row_count();
  kernels_.moments_to_directions(task);
  for (std::int32_t place = first; !dense_.empty() && place < end; ++place)
    dense_.add_source(schedule_.ordinate(place), scattering_.index(), angular_at(place, work));
  for (std::int32_t place = first; shines_by_direction() && place < end; ++place)
    add_angular_source(schedule_.ordinate(place), angular_at(place, work));
}

template <class Real>
void TransportSweepOf<Real>::sweep_batch(std::int32_t batch, const TransportState& last, TransportState& next,
                                         SweepRecord* record, Workspace& work) {
  if (scattering_.row_count() > 0) form_angular_source(batch, work);
  const std::int32_t end = schedule_.batch_end(batch);
  for (std::int32_t first = batch * schedule_.batch(); first < end;) {
    const std::int32_t group_end = is_tiled() ? schedule_.group_end(first) : first + 1;
    std::vector<Passage> group;
    for (; first < group_end; ++first) {
      const OrdinateIndex m = schedule_.ordinate(first);
      typename Workspace::Member& member = work.members[group.size()];
      group.push_back({m, &orders_->of_pair(m.value() / 2, work.order_maker, member.remade_order),
                       angular_at(first, work), &member});
    }
    if (is_stopped()) return;
    sweep_group(group, last, next, record, work);
  }
}

template <class Real>
bool TransportSweepOf<Real>::pass_alone(const SweepRecord* record) const {
  return !dense_.empty() || (record != nullptr && !options_.keep_ordinates.empty());
}

template <class Real>
void TransportSweepOf<Real>::sweep_group(std::span<const Passage> group, const TransportState& last,
                                         TransportState& next, SweepRecord* record, Workspace& work) {
  for (const Passage& passage : group) begin_passage(passage, last, record, work);
  if (pass_alone(record)) {
    for (const Passage& passage : group) run_alone(passage, record, work);
  } else if (!run_together(group, record, work)) {
    return;
  }
  for (const Passage& passage : group) end_passage(passage, next, record, work);
}

template <class Real>
void TransportSweepOf<Real>::begin_passage(const Passage& passage, const TransportState& last,
                                           SweepRecord* record, Workspace& work) {
  const OrdinateIndex m = passage.ordinate;
  typename Workspace::Member& member = *passage.member;
  // What comes in by direction is added to the slots, which then have to be filled again.
  const bool shines = shines_by_direction();
  if (shines || !member.is_filled) walls_.fill(inflow_.span(), member.slots);
  member.is_filled = true;
  walls_.reflect(m, last, passing_.span(), inflow_.span(), member.slots);
  if (record != nullptr) walls_.add_exitance(m, member.slots, work.exitance.span());
  if (shines) add_angular_inflow(m, member.slots, work.exitance.span());
  set_lagged(m, *passage.order, last, member.slots);
}

template <class Real>
void TransportSweepOf<Real>::end_passage(const Passage& passage, TransportState& next, SweepRecord* record,
                                         Workspace& work) {
  const OrdinateIndex m = passage.ordinate;
  const SweepSlotsOf<Real>& slots = passage.member->slots;
  if (!dense_.empty()) dense_.keep_radiance(m, scattering_.index(), passage.angular, next);
  if (record != nullptr && dense_.absorbs_by_direction())
    dense_.add_absorbed(m, scattering_.index(), passage.angular, work.absorbed);
  walls_.accumulate_irradiance(m, slots, record != nullptr ? AccumulateAt::all : AccumulateAt::reflecting,
                               work.irradiance.span(), next.mirrors(), passing_.span());
  keep_lagged(m, *passage.order, next, slots);
  if (record != nullptr && !options_.meters.empty()) read_meters(m, passage.angular, work.meters);
}

template <class Real>
SweepTaskOf<Real> TransportSweepOf<Real>::make_task(const Passage& passage, SweepRecord* record,
                                                    Workspace& work) {
  const OrdinateIndex m = passage.ordinate;
  SweepTaskOf<Real> task;
  task.visits = passage.order->visits.data();
  task.levels = passage.order->levels.data();
  task.level_count = static_cast<std::int32_t>(passage.order->levels.size()) - 1;
  task.idle_cell = static_cast<std::uint32_t>(problem_.mesh().cell_count());
  task.backwards = m.value() % 2 == 1;
  for (int axis = 0; axis < 3; ++axis) task.direction[axis] = directions_.direction(m)[axis];
  task.weight = directions_.weight(m);
  task.stride = cells_.stride();
  task.records = records_.data();
  if (!dense_.empty()) {
    dense_.set_mass(m, work.records.data());
    task.records = work.records.data();
  }
  task.slots = passage.member->slots.radiance;
  task.fetches_slots = is_tiled();
  task.fluence = work.fluence.data();
  task.angular_index = scattering_.index();
  task.angular = passage.angular;
  task.net_flux = record != nullptr ? work.net_flux.data() : nullptr;
  if (!census_.empty() && emission_ == Emission::included) {
    task.volumes = problem_.mesh().volumes().data();
    task.fixup = fixup_;
    task.census = &census_[m.at() * static_cast<std::size_t>(cells_.stride())];
  }
  return task;
}

template <class Real>
void TransportSweepOf<Real>::run_kernel(const SweepTaskOf<Real>& task) const {
  if (task.census != nullptr) {
    kernels_.sweep_positive(task);
  } else {
    kernels_.sweep(task);
  }
}

template <class Real>
void TransportSweepOf<Real>::run_alone(const Passage& passage, SweepRecord* record, Workspace& work) {
  const SweepTaskOf<Real> task = make_task(passage, record, work);
  const auto kept =
      std::find(options_.keep_ordinates.begin(), options_.keep_ordinates.end(), passage.ordinate.value());
  if (record == nullptr || kept == options_.keep_ordinates.end()) {
    run_kernel(task);
    return;
  }
  sweep_and_keep(task, record->radiance[static_cast<std::size_t>(kept - options_.keep_ordinates.begin())],
                 work.whole.span());
}

// Tile by tile, so that what one ordinate has brought into the cache serves all of the group.
template <class Real>
bool TransportSweepOf<Real>::run_together(std::span<const Passage> group, SweepRecord* record,
                                          Workspace& work) {
  std::vector<SweepTaskOf<Real>> tasks;
  for (const Passage& passage : group) tasks.push_back(make_task(passage, record, work));
  const std::int32_t steps = orders_->step_count();
  for (std::int32_t step = 0; step < steps; ++step)
    for (std::size_t i = 0; i < group.size(); ++i) {
      const SweepOrder& order = *group[i].order;
      const auto at = static_cast<std::size_t>(tasks[i].backwards ? steps - 1 - step : step);
      tasks[i].levels = order.levels.data() + order.steps[at];
      tasks[i].level_count = order.steps[at + 1] - order.steps[at];
      run_kernel(tasks[i]);
      if (is_stopped()) return false;
    }
  return true;
}

}  // namespace etendue
