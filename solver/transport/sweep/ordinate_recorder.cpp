// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/ordinate_recorder.h"

#include <algorithm>
#include <numeric>

namespace etendue {

void OrdinateRecorder::begin(SweepRecord& record, std::span<const int> ordinates) {
  const auto cells = static_cast<std::size_t>(d_.problem.mesh().cell_count());
  record.net_flux = AlignedArray(3 * d_.fluence_size());
  record.exitance = AlignedArray(d_.walls.irradiance_size());
  record.meters.assign(d_.options.meters.size() * static_cast<std::size_t>(d_.cells.stride()), 0);
  record.source_products.assign(
      d_.options.paired_sources.size() * static_cast<std::size_t>(d_.cells.stride()), 0);
  record.absorbed.assign(
      d_.dense.absorbs_by_direction() ? cells * static_cast<std::size_t>(d_.cells.bands()) : 0, 0);
  record.radiance.clear();
  for (const int ordinate : ordinates)
    record.radiance.push_back({ordinate, std::vector<double>(d_.fluence_size())});
  if (ordinates.empty()) return;
  all_cells_index_.resize(cells + 1);
  std::iota(all_cells_index_.begin(), all_cells_index_.end() - 1, 1);
  all_cells_index_.back() = 0;
}

OrdinateRadiance* OrdinateRecorder::kept(OrdinateIndex m, SweepRecord* record) const {
  if (record == nullptr) return nullptr;
  const auto found = std::ranges::find(record->radiance, m.value(), &OrdinateRadiance::ordinate);
  return found == record->radiance.end() ? nullptr : &*found;
}

template <class Real>
void OrdinateRecorder::add_meters(OrdinateIndex m, const Real* rows, std::span<double> meters) const {
  const TetrahedralMesh& mesh = d_.problem.mesh();
  const auto stride = static_cast<std::size_t>(d_.cells.stride());
  for (std::size_t i = 0; i < d_.options.meters.size(); ++i) {
    const double cosine = d_.directions.direction(m).dot(d_.options.meters[i].normal);
    if (cosine >= 0) continue;
    double volume = 0;
    for (const CellPoint& point : d_.options.meters[i].cells) volume += mesh.volume(point.cell);
    for (const CellPoint& point : d_.options.meters[i].cells) {
      const double factor = -cosine * d_.directions.weight(m) * mesh.volume(point.cell) / volume;
      const Real* u = rows + static_cast<std::size_t>(d_.moments.row(point.cell)) * d_.moments.row_length();
      for (std::size_t node = 0; node < static_cast<std::size_t>(d_.cells.nodes()); ++node) {
        const double share = d_.cells.nodes() == 1 ? 1 : point.barycentric[node];
        for (std::size_t b = 0; b < stride; ++b)
          meters[i * stride + b] += factor * share * u[node * stride + b];
      }
    }
  }
}

template <class Real>
SweepTaskOf<Real> OrdinateRecorder::with_all_rows(SweepTaskOf<Real> task, std::span<Real> all_rows) const {
  const RecordLayout layout = d_.cells.layout();
  const std::size_t length = d_.moments.row_length();
  Real* cell_rows = all_rows.data() + length;
  for (std::size_t c = 0; c < static_cast<std::size_t>(d_.problem.mesh().cell_count()); ++c) {
    const Real* source = task.records + c * layout.length + layout.source;
    std::copy(source, source + length, cell_rows + c * length);
  }
  for (const std::int32_t cell : d_.moments.angular_cells()) {
    const Real* row = task.angular + static_cast<std::size_t>(d_.moments.row(CellIndex(cell))) * length;
    std::copy(row, row + length, cell_rows + static_cast<std::size_t>(cell) * length);
  }
  task.angular_index = all_cells_index_.data();
  task.angular = all_rows.data();
  return task;
}

template <class Real>
void OrdinateRecorder::keep(std::span<const Real> all_rows, OrdinateRadiance& kept, Real* rows) const {
  const std::size_t length = d_.moments.row_length();
  const Real* cell_rows = all_rows.data() + length;
  std::copy(cell_rows, cell_rows + d_.fluence_size(), kept.values.begin());
  for (const std::int32_t cell : d_.moments.angular_cells()) {
    const Real* row = cell_rows + static_cast<std::size_t>(cell) * length;
    std::copy(row, row + length, rows + static_cast<std::size_t>(d_.moments.row(CellIndex(cell))) * length);
  }
}

template void OrdinateRecorder::add_meters(OrdinateIndex, const double*, std::span<double>) const;
template void OrdinateRecorder::add_meters(OrdinateIndex, const float*, std::span<double>) const;
template SweepTaskOf<double> OrdinateRecorder::with_all_rows(SweepTaskOf<double>, std::span<double>) const;
template SweepTaskOf<float> OrdinateRecorder::with_all_rows(SweepTaskOf<float>, std::span<float>) const;
template void OrdinateRecorder::keep(std::span<const double>, OrdinateRadiance&, double*) const;
template void OrdinateRecorder::keep(std::span<const float>, OrdinateRadiance&, float*) const;

}  // namespace etendue
