// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/scattering/dense_scattering.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/parallel/processor_timer.h"
#include "solver/angular/kernels/kernel_places.h"
#include "solver/angular/media/directional_absorption.h"
#include "solver/materials/kernels/kernel_formula.h"

namespace etendue {
namespace {

std::size_t at(const Problem& problem, int region, int band) {
  return static_cast<std::size_t>(region * problem.band_count() + band);
}

double mean_extinction(const DenseGroup& group) {
  double sum = 0;
  for (std::size_t m = 0; m < group.kernel().leaving.size(); ++m) sum += group.extinction(m);
  return sum / static_cast<double>(group.kernel().leaving.size());
}

/// Of the extinction in a cell, what the matrix says in its own way.
double replaced(const Problem& problem, const DenseGroup& group, CellIndex cell, int band) {
  return problem.scattering(cell, band) +
         (group.directional.absorbing.empty() ? 0 : problem.absorption(cell, band));
}

[[noreturn]] void refuse_medium(const Medium& medium, const InputError& error,
                                const std::string& where = "") {
  Origin origin = medium.origin;
  if (origin.key.empty()) origin.key = "media." + medium.name;
  throw InputError(fault_at(origin, "", where + error.faults().front().text));
}

DirectionalKernel directional_kernel_of(const Medium& medium, int band, ScatteringBackend backend,
                                        const DirectionSet& directions) {
  const PhaseFunction& phase = medium.phase[static_cast<std::size_t>(band)];
  try {
    if (medium.is_directional(band))
      return directional_kernel(medium.directional[static_cast<std::size_t>(band)], directions);
    return {backend == ScatteringBackend::galerkin ? galerkin_kernel(phase, directions)
                                                   : dense_kernel(phase, directions),
            {},
            1};
  } catch (const InputError& error) {
    refuse_medium(medium, error);
  }
}

/// A group for every place of a kernel that differs from cell to cell.
void add_places(const Problem& problem, const DirectionSet& directions, int region, int band,
                std::vector<KernelPlace> places, std::vector<DenseGroup>& groups) {
  const Medium& medium = problem.medium(region);
  const auto& kernel = std::get<KernelFormula>(medium.directional[static_cast<std::size_t>(band)]);
  const std::size_t first = groups.size();
  groups.resize(first + places.size());
  std::vector<std::string> failed(places.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < places.size(); ++i) {
    try {
      groups[first + i] = {region,
                           {band},
                           std::move(places[i].cells),
                           directional_kernel(kernel_at(kernel, places[i].place), directions)};
    } catch (const InputError& error) {
      failed[i] = error.faults().front().text;
    }
  }
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!failed[i].empty())
      refuse_medium(medium, InputError(failed[i]),
                    fmt::format("at ({:.4g}, {:.4g}, {:.4g}) ", places[i].place.x(), places[i].place.y(),
                                places[i].place.z()));
}

}  // namespace

std::vector<DenseGroup> dense_groups(const Problem& problem, const DirectionSet& directions,
                                     const std::vector<ScatteringTreatment>& plan) {
  std::vector<DenseGroup> groups;
  for (int region = 0; region < static_cast<int>(problem.media().size()); ++region) {
    const Medium& medium = problem.medium(region);
    const std::vector<PhaseFunction>& phases = medium.phase;
    const std::size_t first = groups.size();
    for (int band = 0; band < problem.band_count(); ++band) {
      const ScatteringBackend backend = plan[at(problem, region, band)].backend;
      if (!plan[at(problem, region, band)].is_dense()) continue;
      const auto alike = [&](const DenseGroup& group) {
        const auto other = static_cast<std::size_t>(group.bands.front());
        return plan[at(problem, region, group.bands.front())].backend == backend &&
               phases[other] == phases[static_cast<std::size_t>(band)] &&
               (medium.directional.empty() ||
                medium.directional[other] == medium.directional[static_cast<std::size_t>(band)]);
      };
      const auto found =
          std::find_if(groups.begin() + static_cast<std::ptrdiff_t>(first), groups.end(), alike);
      if (found != groups.end()) {
        for (auto group = found; group != groups.end(); ++group)
          if (alike(*group)) group->bands.push_back(band);
        continue;
      }
      std::vector<KernelPlace> places = kernel_places(problem, region, band);
      if (places.empty())
        groups.push_back({region, {band}, {}, directional_kernel_of(medium, band, backend, directions)});
      else
        add_places(problem, directions, region, band, std::move(places), groups);
    }
  }
  return groups;
}

std::vector<DenseGroup> of_bands(const std::vector<DenseGroup>& groups, std::span<const int> bands) {
  std::vector<DenseGroup> result;
  for (const DenseGroup& group : groups) {
    std::vector<int> kept;
    for (std::size_t i = 0; i < bands.size(); ++i)
      if (std::find(group.bands.begin(), group.bands.end(), bands[i]) != group.bands.end())
        kept.push_back(static_cast<int>(i));
    if (!kept.empty()) result.push_back({group.region, std::move(kept), group.cells, group.directional});
  }
  return result;
}

std::vector<double> effective_extinction(const Problem& problem, std::span<const double> extinction,
                                         const std::vector<ScatteringTreatment>& plan,
                                         const std::vector<DenseGroup>& groups) {
  std::vector<const DenseGroup*> group_of(plan.size(), nullptr), group_in(extinction.size(), nullptr);
  for (const DenseGroup& group : groups)
    for (const int band : group.bands) {
      group_of[at(problem, group.region, band)] = &group;
      for (const CellIndex cell : group.cells)
        group_in[cell.at() * static_cast<std::size_t>(problem.band_count()) +
                 static_cast<std::size_t>(band)] = &group;
    }
  std::vector<double> result(extinction.begin(), extinction.end());
  for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c)
    for (int band = 0; band < problem.band_count(); ++band) {
      const CellIndex cell(c);
      const std::size_t of_plan = at(problem, problem.mesh().region(cell), band);
      const auto place = static_cast<std::size_t>(c * problem.band_count() + band);
      double& value = result[place];
      if (const DenseGroup* group = group_in[place] != nullptr ? group_in[place] : group_of[of_plan])
        value += group->amplitude(problem, cell, band) * mean_extinction(*group) -
                 replaced(problem, *group, cell, band);
      else
        value -= plan[of_plan].forward * problem.scattering(cell, band);
    }
  return result;
}

double DenseGroup::amplitude(const Problem& problem, CellIndex cell, int band) const {
  return !cells.empty() ? 1 : replaced(problem, *this, cell, band) / directional.reference;
}

DenseScattering::DenseScattering(const Problem& problem, const DirectionSet& directions,
                                 const CellCoefficients& cells, std::span<const double> extinction,
                                 const std::vector<ScatteringTreatment>& plan,
                                 const std::vector<DenseGroup>& groups)
    : problem_(problem),
      directions_(directions),
      cells_(cells),
      groups_(groups),
      row_of_(static_cast<std::size_t>(problem.mesh().cell_count()), -1),
      row_length_(cells.cell_length()) {
  for (const CellIndex cell : dense_cells(problem, plan)) {
    row_of_[cell.at()] = static_cast<std::int32_t>(rows_.size());
    rows_.push_back(cell.value());
    for (int band = 0; band < problem.band_count(); ++band)
      removed_.push_back(extinction[cell.at() * static_cast<std::size_t>(problem.band_count()) +
                                    static_cast<std::size_t>(band)]);
  }
  for (const DenseGroup& group : groups_) add_group(group);
  source_ = AlignedArray(radiance_size());
}

std::vector<CellIndex> DenseScattering::cells_of(const DenseGroup& group) const {
  if (!group.cells.empty()) return group.cells;
  std::vector<CellIndex> cells;
  for (const std::int32_t c : rows_)
    if (problem_.mesh().region(CellIndex(c)) == group.region) cells.emplace_back(c);
  return cells;
}

void DenseScattering::add_group(const DenseGroup& group) {
  Lanes lanes;
  for (const CellIndex cell : cells_of(group))
    for (const int band : group.bands) {
      lanes.rows.push_back(row_of_[cell.at()]);
      lanes.bands.push_back(band);
      lanes.amplitude.push_back(group.amplitude(problem_, cell, band));
      removed_[static_cast<std::size_t>(lanes.rows.back() * problem_.band_count() + band)] -=
          replaced(problem_, group, cell, band);
    }
  const Eigen::Index count = group.kernel().rate.rows();
  lanes.matrix = AlignedArray(static_cast<std::size_t>(count * count));
  for (Eigen::Index m = 0; m < count; ++m)
    for (Eigen::Index n = 0; n < count; ++n)
      lanes.matrix.data()[m * count + n] =
          group.kernel().rate(m, n) * directions_.weights()[static_cast<std::size_t>(n)];
  add_absorption(group, lanes);
  lanes_.push_back(std::move(lanes));
}

void DenseScattering::add_absorption(const DenseGroup& group, Lanes& lanes) {
  const Medium& medium = problem_.medium(group.region);
  const std::size_t pairs = lanes.rows.size();
  if (std::ranges::none_of(group.bands, [&](int band) { return medium.absorbs_by_direction(band); })) return;
  lanes.absorption.resize(static_cast<std::size_t>(directions_.count()) * pairs);
  for (const int band : group.bands) {
    std::vector<std::size_t> places;
    std::vector<CellIndex> cells;
    std::vector<double> amplitude;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
      if (lanes.bands[pair] != band) continue;
      places.push_back(pair);
      cells.emplace_back(rows_[static_cast<std::size_t>(lanes.rows[pair])]);
      amplitude.push_back(lanes.amplitude[pair]);
      removed_[static_cast<std::size_t>(lanes.rows[pair] * problem_.band_count() + band)] -=
          problem_.absorption(cells.back(), band);
    }
    const bool varies = medium.absorbs_by_direction(band);
    const std::vector<double> table =
        varies ? directional_absorption(problem_, directions_, medium, band, group.kernel(), cells, amplitude)
               : std::vector<double>();
    for (std::size_t m = 0; m < directions_.directions().size(); ++m)
      for (std::size_t i = 0; i < places.size(); ++i)
        lanes.absorption[m * pairs + places[i]] =
            varies ? table[m * places.size() + i] : problem_.absorption(cells[i], band);
  }
}

void DenseScattering::form_source(const TransportState& last, MatrixProduct kernel, int threads,
                                  double& seconds) {
  const std::size_t pairs = product_lanes / static_cast<std::size_t>(cells_.nodes());
  const std::size_t panel = static_cast<std::size_t>(directions_.count()) * product_lanes;
  // A medium with one matrix has many blocks, one with a matrix in every cell many matrices.
  std::vector<std::pair<const Lanes*, std::size_t>> blocks;
  for (const Lanes& lanes : lanes_)
    for (std::size_t first = 0; first < lanes.rows.size(); first += pairs) blocks.emplace_back(&lanes, first);
#pragma omp parallel num_threads(threads)
  {
    const ProcessorTimer timer(seconds);
    AlignedArray factor(panel), result(panel);
#pragma omp for schedule(static)
    for (std::size_t block = 0; block < blocks.size(); ++block)
      product(*blocks[block].first, blocks[block].second, last, kernel, factor.data(), result.data());
  }
}

void DenseScattering::product(const Lanes& lanes, std::size_t first, const TransportState& last,
                              MatrixProduct kernel, double* factor, double* result) {
  const auto nodes = static_cast<std::size_t>(cells_.nodes());
  const auto stride = static_cast<std::size_t>(cells_.stride());
  const auto count = static_cast<std::size_t>(directions_.count());
  const std::size_t end = std::min(lanes.rows.size(), first + product_lanes / nodes);
  const std::size_t of_ordinate = rows_.size() * row_length_;
  // The mass terms of the right-hand side go in with the radiance: K acts on each node alike.
  CellCoefficients::SourceFactors mass[product_lanes];
  std::size_t place[product_lanes];
  for (std::size_t pair = first; pair < end; ++pair) {
    const auto row = static_cast<std::size_t>(lanes.rows[pair]);
    mass[pair - first] = cells_.source_factors(CellIndex(rows_[row]), lanes.bands[pair]);
    mass[pair - first].sum *= lanes.amplitude[pair];
    mass[pair - first].own *= lanes.amplitude[pair];
    place[pair - first] = row * row_length_ + static_cast<std::size_t>(lanes.bands[pair]);
  }
  for (std::size_t n = 0; n < count; ++n) {
    const double* radiance = last.radiance().data() + n * of_ordinate;
    double* to = factor + n * product_lanes;
    for (std::size_t pair = 0; pair < end - first; ++pair, to += nodes) {
      const double* u = radiance + place[pair];
      double total = 0;
      for (std::size_t i = 0; i < nodes; ++i) total += u[i * stride];
      for (std::size_t i = 0; i < nodes; ++i) to[i] = mass[pair].sum * total + mass[pair].own * u[i * stride];
    }
  }
  kernel({static_cast<int>(count), static_cast<int>(count), lanes.matrix.data(), factor, result});
  for (std::size_t m = 0; m < count; ++m) {
    double* source = source_.data() + m * of_ordinate;
    const double* from = result + m * product_lanes;
    for (std::size_t pair = 0; pair < end - first; ++pair, from += nodes)
      for (std::size_t i = 0; i < nodes; ++i) source[place[pair] + i * stride] = from[i];
  }
}

template <class Real>
void DenseScattering::add_source(OrdinateIndex m, const std::int32_t* index, Real* angular) const {
  const double* from = source_.data() + m.at() * rows_.size() * row_length_;
  for (const std::int32_t c : rows_) {
    Real* right = angular + static_cast<std::size_t>(index[c]) * row_length_;
    for (std::size_t i = 0; i < row_length_; ++i) right[i] += static_cast<Real>(from[i]);
    from += row_length_;
  }
}

template <class Real>
void DenseScattering::keep_radiance(OrdinateIndex m, const std::int32_t* index, const Real* angular,
                                    TransportState& next) const {
  double* to = next.radiance().data() + m.at() * rows_.size() * row_length_;
  for (const std::int32_t c : rows_) {
    const Real* u = angular + static_cast<std::size_t>(index[c]) * row_length_;
    to = std::copy(u, u + row_length_, to);
  }
}

template <class Real>
void DenseScattering::set_mass(OrdinateIndex m, Real* records) const {
  const RecordLayout layout = cells_.layout();
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  for (std::size_t g = 0; g < lanes_.size(); ++g) {
    const Lanes& lanes = lanes_[g];
    const double of_unit = groups_[g].extinction(m.at());
    const double* absorption =
        lanes.absorption.empty() ? nullptr : &lanes.absorption[m.at() * lanes.rows.size()];
    for (std::size_t pair = 0; pair < lanes.rows.size(); ++pair) {
      const auto row = static_cast<std::size_t>(lanes.rows[pair]);
      const double extinction = removed_[row * bands + static_cast<std::size_t>(lanes.bands[pair])] +
                                lanes.amplitude[pair] * of_unit +
                                (absorption == nullptr ? 0 : absorption[pair]);
      const CellIndex cell(rows_[row]);
      records[cell.at() * layout.length + layout.mass + static_cast<std::size_t>(lanes.bands[pair])] =
          static_cast<Real>(cells_.mass(cell, lanes.bands[pair], extinction));
    }
  }
}

bool DenseScattering::absorbs_by_direction() const {
  return std::any_of(groups_.begin(), groups_.end(),
                     [](const DenseGroup& group) { return !group.directional.absorbing.empty(); }) ||
         std::any_of(lanes_.begin(), lanes_.end(),
                     [](const Lanes& lanes) { return !lanes.absorption.empty(); });
}

bool DenseScattering::absorbs_by_direction(CellIndex cell, int band) const {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const DenseGroup& group = groups_[g];
    if (group.region == problem_.mesh().region(cell) &&
        std::count(group.bands.begin(), group.bands.end(), band) > 0)
      return !group.directional.absorbing.empty() || !lanes_[g].absorption.empty();
  }
  return false;
}

template <class Real>
void DenseScattering::add_absorbed(OrdinateIndex m, const std::int32_t* index, const Real* angular,
                                   std::span<double> absorbed) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  const auto stride = static_cast<std::size_t>(cells_.stride());
  const auto nodes = static_cast<std::size_t>(cells_.nodes());
  for (std::size_t g = 0; g < lanes_.size(); ++g) {
    const Lanes& lanes = lanes_[g];
    const bool of_kernel = !groups_[g].directional.absorbing.empty();
    if (!of_kernel && lanes.absorption.empty()) continue;
    const double factor = directions_.weight(m) / static_cast<double>(nodes);
    for (std::size_t pair = 0; pair < lanes.rows.size(); ++pair) {
      const auto cell = static_cast<std::size_t>(rows_[static_cast<std::size_t>(lanes.rows[pair])]);
      const auto band = static_cast<std::size_t>(lanes.bands[pair]);
      const Real* u = angular + static_cast<std::size_t>(index[cell]) * row_length_ + band;
      double sum = 0;
      for (std::size_t i = 0; i < nodes; ++i) sum += u[i * stride];
      const double absorption = of_kernel ? lanes.amplitude[pair] * groups_[g].directional.absorbing[m.at()]
                                          : lanes.absorption[m.at() * lanes.rows.size() + pair];
      absorbed[cell * bands + band] += factor * absorption * sum;
    }
  }
}

template void DenseScattering::add_source(OrdinateIndex, const std::int32_t*, double*) const;
template void DenseScattering::keep_radiance(OrdinateIndex, const std::int32_t*, const double*,
                                             TransportState&) const;
template void DenseScattering::add_absorbed(OrdinateIndex, const std::int32_t*, const double*,
                                            std::span<double>) const;
template void DenseScattering::set_mass(OrdinateIndex, double*) const;

template void DenseScattering::add_source(OrdinateIndex, const std::int32_t*, float*) const;
template void DenseScattering::keep_radiance(OrdinateIndex, const std::int32_t*, const float*,
                                             TransportState&) const;
template void DenseScattering::add_absorbed(OrdinateIndex, const std::int32_t*, const float*,
                                            std::span<double>) const;
template void DenseScattering::set_mass(OrdinateIndex, float*) const;

}  // namespace etendue
