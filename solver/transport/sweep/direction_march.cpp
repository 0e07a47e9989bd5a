// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/direction_march.h"

#include "solver/transport/sweep/lagged_faces.h"

namespace etendue {

template <class Real>
void DirectionMarch<Real>::keep_positive(Fixup fixup) {
  fixup_ = fixup;
  census_.resize(static_cast<std::size_t>(d_.directions.count()) *
                 static_cast<std::size_t>(d_.cells.stride()));
}

template <class Real>
void DirectionMarch<Real>::merge_census(RankGroup& ranks) {
  std::vector<double> numbers;
  for (const FixupCensus& of : census_)
    for (const double number :
         {static_cast<double>(of.cells), static_cast<double>(of.failed), of.smallest, of.moved})
      numbers.push_back(number);
  ranks.merge(numbers);
  for (std::size_t i = 0; i < census_.size(); ++i)
    census_[i] = {static_cast<std::int64_t>(numbers[4 * i]), static_cast<std::int64_t>(numbers[4 * i + 1]),
                  numbers[4 * i + 2], numbers[4 * i + 3]};
}

template <class Real>
void DirectionMarch<Real>::form_rows(std::int32_t batch, const SweepPass& pass, Workspace& work) {
  const std::int32_t first = batch * d_.schedule.batch();
  const std::int32_t end = d_.schedule.batch_end(batch);
  moments_.moments_to_directions(batch, work.rows);
  for (std::int32_t place = first; !d_.dense.empty() && place < end; ++place)
    d_.dense.add_source(d_.schedule.ordinate(place), d_.moments.index(), moments_.rows_at(place, work.rows));
  for (std::int32_t place = first; input_.acts(pass.emission) && place < end; ++place)
    input_.add_source(d_.schedule.ordinate(place), moments_.rows_at(place, work.rows));
}

template <class Real>
void DirectionMarch<Real>::march(std::int32_t batch, const SweepPass& pass, Workspace& work) {
  if (d_.moments.row_count() > 0) form_rows(batch, pass, work);
  const std::int32_t end = d_.schedule.batch_end(batch);
  for (std::int32_t first = batch * d_.schedule.batch(); first < end;) {
    const std::int32_t group_end = is_tiled() ? d_.schedule.group_end(first) : first + 1;
    std::vector<Passage> group;
    for (; first < group_end; ++first) {
      const OrdinateIndex m = d_.schedule.ordinate(first);
      if (pass.skips(m)) continue;
      typename Workspace::Member& member = work.members[group.size()];
      group.push_back({m, &d_.orders->of_pair(m.value() / 2, work.order_maker, member.remade_order),
                       moments_.rows_at(first, work.rows), &member});
    }
    if (stop_.ask()) return;
    if (!group.empty()) march_group(group, pass, work);
  }
}

template <class Real>
void DirectionMarch<Real>::march_group(std::span<const Passage> group, const SweepPass& pass,
                                       Workspace& work) {
  for (const Passage& passage : group) begin_passage(passage, pass, work);
  if (pass_alone(pass.record)) {
    for (const Passage& passage : group) run_alone(passage, pass, work);
  } else if (!run_together(group, pass, work)) {
    return;
  }
  for (const Passage& passage : group) end_passage(passage, pass, work);
}

template <class Real>
void DirectionMarch<Real>::begin_passage(const Passage& passage, const SweepPass& pass, Workspace& work) {
  const OrdinateIndex m = passage.ordinate;
  typename Workspace::Member& member = *passage.member;
  // Directional inflow is added to the slots, which then have to be filled again.
  const bool has_input = input_.acts(pass.emission);
  if (has_input || !member.is_filled) walls_.fill(member.slots);
  member.is_filled = true;
  walls_.reflect(m, pass.last, member.slots);
  if (pass.record != nullptr) walls_.add_exitance(m, member.slots, work.exitance.span());
  if (has_input) input_.add_inflow(m, member.slots, work.exitance.span());
  set_lagged(d_, m, *passage.order, pass.last, member.slots);
}

template <class Real>
void DirectionMarch<Real>::end_passage(const Passage& passage, const SweepPass& pass, Workspace& work) {
  const OrdinateIndex m = passage.ordinate;
  const SweepSlotsOf<Real>& slots = passage.member->slots;
  const bool records = pass.record != nullptr;
  if (!d_.dense.empty()) d_.dense.keep_radiance(m, d_.moments.index(), passage.rows, pass.next);
  if (records && d_.dense.absorbs_by_direction())
    d_.dense.add_absorbed(m, d_.moments.index(), passage.rows, work.absorbed);
  walls_.receive(m, slots, records ? AccumulateAt::all : AccumulateAt::reflecting, work.irradiance.span(),
                 pass.next);
  keep_lagged(d_, m, *passage.order, pass.next, slots);
  if (records && !d_.options.meters.empty()) recorder_.add_meters(m, passage.rows, work.meters);
  if (records) products_.add(m, passage.rows, slots, work.source_products);
}

template <class Real>
SweepTaskOf<Real> DirectionMarch<Real>::task_of(const Passage& passage, const SweepPass& pass,
                                                Workspace& work) {
  const OrdinateIndex m = passage.ordinate;
  SweepTaskOf<Real> task;
  task.visits = passage.order->visits.data();
  task.levels = passage.order->levels.data();
  task.level_count = static_cast<std::int32_t>(passage.order->levels.size()) - 1;
  task.idle_cell = static_cast<std::uint32_t>(d_.problem.mesh().cell_count());
  task.backwards = m.value() % 2 == 1;
  for (int axis = 0; axis < 3; ++axis) task.direction[axis] = d_.directions.direction(m)[axis];
  task.weight = d_.directions.weight(m);
  task.stride = d_.cells.stride();
  task.records = records_.data();
  if (!d_.dense.empty()) {
    d_.dense.set_mass(m, work.records.data());
    task.records = work.records.data();
  }
  task.slots = passage.member->slots.radiance;
  task.fetches_slots = is_tiled();
  task.fluence = work.fluence.data();
  task.angular_index = d_.moments.index();
  task.angular = passage.rows;
  task.net_flux = pass.record != nullptr ? work.net_flux.data() : nullptr;
  if (!census_.empty() && pass.emission == Emission::included) {
    task.volumes = d_.problem.mesh().volumes().data();
    task.fixup = fixup_;
    task.census = &census_[m.at() * static_cast<std::size_t>(d_.cells.stride())];
  }
  return task;
}

template <class Real>
void DirectionMarch<Real>::run_alone(const Passage& passage, const SweepPass& pass, Workspace& work) {
  const SweepTaskOf<Real> task = task_of(passage, pass, work);
  OrdinateRadiance* kept = recorder_.kept(passage.ordinate, pass.record);
  if (kept == nullptr) {
    run_kernel(task);
    return;
  }
  run_kernel(recorder_.with_all_rows(task, work.all_rows.span()));
  recorder_.keep(std::span<const Real>(work.all_rows.span()), *kept, passage.rows);
}

// Tile by tile, so that cells that one ordinate has brought into the cache serve all of the group.
template <class Real>
bool DirectionMarch<Real>::run_together(std::span<const Passage> group, const SweepPass& pass,
                                        Workspace& work) {
  std::vector<SweepTaskOf<Real>> tasks;
  for (const Passage& passage : group) tasks.push_back(task_of(passage, pass, work));
  const std::int32_t steps = d_.orders->step_count();
  for (std::int32_t step = 0; step < steps; ++step)
    for (std::size_t i = 0; i < group.size(); ++i) {
      const SweepOrder& order = *group[i].order;
      const auto at = static_cast<std::size_t>(tasks[i].backwards ? steps - 1 - step : step);
      tasks[i].levels = order.levels.data() + order.steps[at];
      tasks[i].level_count = order.steps[at + 1] - order.steps[at];
      run_kernel(tasks[i]);
      if (stop_.ask()) return false;
    }
  return true;
}

template class DirectionMarch<double>;
template class DirectionMarch<float>;

}  // namespace etendue
