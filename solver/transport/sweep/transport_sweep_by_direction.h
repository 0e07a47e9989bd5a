// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// What a sweep takes in and gives out ordinate by ordinate: sources and inflow by direction, lagged faces,
// meters, radiance that is kept.
// Part of TransportSweep, for its source file alone.
#include <algorithm>

#include "solver/transport/order/projected_area.h"
#include "solver/transport/order/sweep_order.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

// Adds the input of one cell to its right-hand side [node][stride]; `values` [4][band] is scratch.
template <class Real>
void TransportSweepOf<Real>::add_input(OrdinateIndex m, CellIndex cell, std::vector<double>& values,
                                       Real* right) const {
  const auto bands = static_cast<std::size_t>(cells_.bands());
  const auto stride = static_cast<std::size_t>(cells_.stride());
  const auto nodes = static_cast<std::size_t>(cells_.nodes());
  const auto add = [&](std::size_t b, const CellCoefficients::SourceFactors& mass) {
    const double total = values[b] + values[bands + b] + values[2 * bands + b] + values[3 * bands + b];
    for (std::size_t i = 0; i < nodes; ++i) {
      // A constant element has the mean of the four values.
      const double own = nodes == 1 ? total / 4 : values[i * bands + b];
      right[i * stride + b] += mass.sum * total + mass.own * own;
    }
  };
  std::fill(values.begin(), values.end(), 0.0);
  options_.angular_input->add_source(m, cell, values);
  for (std::size_t b = 0; b < bands; ++b) add(b, cells_.source_factors(cell, static_cast<int>(b)));
  std::fill(values.begin(), values.end(), 0.0);
  options_.angular_input->add_projected_source(m, cell, values);
  for (std::size_t b = 0; b < bands; ++b) add(b, cells_.projected_source_factors(cell));
}

template <class Real>
void TransportSweepOf<Real>::add_isotropic_source(std::int32_t first, std::int32_t last) {
  const RecordLayout& layout = cells_.layout();
  std::vector<double> values(4 * static_cast<std::size_t>(cells_.bands()));
  for (std::int32_t c = first; c < last; ++c) {
    const CellIndex cell(c);
    const bool has_row = scattering_.index() != nullptr && scattering_.row(cell) > 0;
    if (!has_row)
      add_input(OrdinateIndex(0), cell, values, records_.data() + cell.at() * layout.length + layout.source);
  }
}

template <class Real>
void TransportSweepOf<Real>::add_angular_source(OrdinateIndex m, Real* angular) const {
  std::vector<double> values(4 * static_cast<std::size_t>(cells_.bands()));
  for (const std::int32_t c : scattering_.angular_cells())
    add_input(m, CellIndex(c), values,
              angular + static_cast<std::size_t>(scattering_.row(CellIndex(c))) * scattering_.row_length());
}

template <class Real>
void TransportSweepOf<Real>::add_angular_inflow(OrdinateIndex m, const SweepSlotsOf<Real>& slots,
                                                std::span<double> exitance) const {
  const auto bands = static_cast<std::size_t>(cells_.bands());
  const auto stride = static_cast<std::size_t>(cells_.stride());
  const auto nodes = static_cast<std::size_t>(cells_.face_nodes());
  std::vector<double> values(3 * bands);
  for (std::int32_t f = 0; f < problem_.mesh().boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const double seen = projected_area(problem_.mesh().area_normal(face), directions_.direction(m));
    if (seen >= 0) continue;
    std::fill(values.begin(), values.end(), 0.0);
    options_.angular_input->add_inflow(m, face, values);
    const double factor = -seen / problem_.mesh().area(face) * directions_.weight(m);
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t b = 0; b < bands; ++b) {
        const double value =
            nodes == 1 ? (values[b] + values[bands + b] + values[2 * bands + b]) / 3 : values[i * bands + b];
        slots.slot(orders_->walls().inflow(f))[i * stride + b] += value;
        if (!exitance.empty()) exitance[(face.at() * nodes + i) * stride + b] += factor * value;
      }
  }
}

template <class Real>
void TransportSweepOf<Real>::read_meters(OrdinateIndex m, const Real* angular,
                                         std::span<double> meters) const {
  const auto stride = static_cast<std::size_t>(cells_.stride());
  for (std::size_t i = 0; i < options_.meters.size(); ++i) {
    const double cosine = directions_.direction(m).dot(options_.meters[i].normal);
    if (cosine >= 0) continue;
    double volume = 0;
    for (const CellPoint& point : options_.meters[i].cells) volume += problem_.mesh().volume(point.cell);
    for (const CellPoint& point : options_.meters[i].cells) {
      const double factor = -cosine * directions_.weight(m) * problem_.mesh().volume(point.cell) / volume;
      const Real* u =
          angular + static_cast<std::size_t>(scattering_.row(point.cell)) * scattering_.row_length();
      for (std::size_t node = 0; node < static_cast<std::size_t>(cells_.nodes()); ++node) {
        const double share = cells_.nodes() == 1 ? 1 : point.barycentric[node];
        for (std::size_t b = 0; b < stride; ++b)
          meters[i * stride + b] += factor * share * u[node * stride + b];
      }
    }
  }
}

// Every cell gets a row, so that the kernel leaves the radiance of all of them.
template <class Real>
void TransportSweepOf<Real>::sweep_and_keep(SweepTaskOf<Real> task, OrdinateRadiance& kept,
                                            std::span<Real> whole_rows) const {
  Real* angular = task.angular;
  const std::size_t length = scattering_.row_length();
  Real* whole = whole_rows.data() + length;
  const RecordLayout layout = cells_.layout();
  for (std::size_t c = 0; c < static_cast<std::size_t>(problem_.mesh().cell_count()); ++c) {
    const Real* source = records_.data() + c * layout.length + layout.source;
    std::copy(source, source + length, whole + c * length);
  }
  for (const std::int32_t cell : scattering_.angular_cells()) {
    const Real* row = angular + static_cast<std::size_t>(scattering_.row(CellIndex(cell))) * length;
    std::copy(row, row + length, whole + static_cast<std::size_t>(cell) * length);
  }
  task.angular_index = all_cells_index_.data();
  task.angular = whole_rows.data();
  run_kernel(task);
  std::copy(whole, whole + fluence_size(), kept.values.begin());
  for (const std::int32_t cell : scattering_.angular_cells()) {
    const Real* row = whole + static_cast<std::size_t>(cell) * length;
    std::copy(row, row + length,
              angular + static_cast<std::size_t>(scattering_.row(CellIndex(cell))) * length);
  }
}

// The cell before a lagged face holds, until its turn comes, what it held in the last sweep.
template <class Real>
void TransportSweepOf<Real>::set_lagged(OrdinateIndex m, const SweepOrder& order, const TransportState& last,
                                        const SweepSlotsOf<Real>& slots) const {
  const auto stride = static_cast<std::size_t>(cells_.stride());
  const auto length = cells_.trace_length();
  const std::size_t parity = m.at() % 2;
  for (std::size_t i = 0; i < order.lagged.size(); ++i) {
    const FaceCode before = parity == 0 ? order.lagged[i].upwind : order.lagged[i].downwind;
    const double* value =
        last.lagged().data() + (2 * (orders_->lagged_start(m.value() / 2) + i) + parity) * length;
    for (std::size_t at = 0; at < length; at += stride)
      std::copy(value + at, value + at + stride, slots.face_node(before, at / stride));
  }
}

template <class Real>
void TransportSweepOf<Real>::keep_lagged(OrdinateIndex m, const SweepOrder& order, TransportState& next,
                                         const SweepSlotsOf<Real>& slots) const {
  const auto stride = static_cast<std::size_t>(cells_.stride());
  const auto length = cells_.trace_length();
  const std::size_t parity = m.at() % 2;
  for (std::size_t i = 0; i < order.lagged.size(); ++i) {
    const FaceCode before = parity == 0 ? order.lagged[i].upwind : order.lagged[i].downwind;
    double* value = next.lagged().data() + (2 * (orders_->lagged_start(m.value() / 2) + i) + parity) * length;
    for (std::size_t at = 0; at < length; at += stride) {
      const Real* node = slots.face_node(before, at / stride);
      std::copy(node, node + stride, value + at);
    }
  }
}

}  // namespace etendue
