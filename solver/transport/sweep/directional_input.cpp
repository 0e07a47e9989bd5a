// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/directional_input.h"

#include <algorithm>

#include "solver/solution/angular_input.h"
#include "solver/transport/order/projected_area.h"

namespace etendue {

template <class Real>
void DirectionalInput::add_cell(OrdinateIndex m, CellIndex cell, std::vector<double>& values,
                                Real* right) const {
  const auto bands = static_cast<std::size_t>(d_.cells.bands());
  const auto stride = static_cast<std::size_t>(d_.cells.stride());
  const auto nodes = static_cast<std::size_t>(d_.cells.nodes());
  const auto add = [&](std::size_t b, const CellCoefficients::SourceFactors& mass) {
    const double total = values[b] + values[bands + b] + values[2 * bands + b] + values[3 * bands + b];
    for (std::size_t i = 0; i < nodes; ++i) {
      // A constant element has the mean of the four values.
      const double own = nodes == 1 ? total / 4 : values[i * bands + b];
      right[i * stride + b] += mass.sum * total + mass.own * own;
    }
  };
  std::fill(values.begin(), values.end(), 0.0);
  d_.options.angular_input->add_source(m, cell, values);
  for (std::size_t b = 0; b < bands; ++b) add(b, d_.cells.source_factors(cell, static_cast<int>(b)));
  std::fill(values.begin(), values.end(), 0.0);
  d_.options.angular_input->add_projected_source(m, cell, values);
  for (std::size_t b = 0; b < bands; ++b) add(b, d_.cells.projected_source_factors(cell));
}

template <class Real>
void DirectionalInput::add_isotropic_source(std::int32_t first, std::int32_t last, Real* records) const {
  const RecordLayout layout = d_.cells.layout();
  std::vector<double> values(4 * static_cast<std::size_t>(d_.cells.bands()));
  for (std::int32_t c = first; c < last; ++c) {
    const CellIndex cell(c);
    const bool has_row = d_.moments.index() != nullptr && d_.moments.row(cell) > 0;
    if (!has_row)
      add_cell(OrdinateIndex(0), cell, values, records + cell.at() * layout.length + layout.source);
  }
}

template <class Real>
void DirectionalInput::add_source(OrdinateIndex m, Real* rows) const {
  std::vector<double> values(4 * static_cast<std::size_t>(d_.cells.bands()));
  for (const std::int32_t c : d_.moments.angular_cells())
    add_cell(m, CellIndex(c), values,
             rows + static_cast<std::size_t>(d_.moments.row(CellIndex(c))) * d_.moments.row_length());
}

template <class Real>
void DirectionalInput::add_inflow(OrdinateIndex m, const SweepSlotsOf<Real>& slots,
                                  std::span<double> exitance) const {
  const TetrahedralMesh& mesh = d_.problem.mesh();
  const auto bands = static_cast<std::size_t>(d_.cells.bands());
  const auto stride = static_cast<std::size_t>(d_.cells.stride());
  const auto nodes = static_cast<std::size_t>(d_.cells.face_nodes());
  std::vector<double> values(3 * bands);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const double projected = projected_area(mesh.area_normal(face), d_.directions.direction(m));
    if (projected >= 0) continue;
    std::fill(values.begin(), values.end(), 0.0);
    d_.options.angular_input->add_inflow(m, face, values);
    const double factor = -projected / mesh.area(face) * d_.directions.weight(m);
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t b = 0; b < bands; ++b) {
        const double value =
            nodes == 1 ? (values[b] + values[bands + b] + values[2 * bands + b]) / 3 : values[i * bands + b];
        slots.slot(d_.orders->walls().inflow(f))[i * stride + b] += value;
        if (!exitance.empty()) exitance[(face.at() * nodes + i) * stride + b] += factor * value;
      }
  }
}

template void DirectionalInput::add_isotropic_source(std::int32_t, std::int32_t, double*) const;
template void DirectionalInput::add_isotropic_source(std::int32_t, std::int32_t, float*) const;
template void DirectionalInput::add_source(OrdinateIndex, double*) const;
template void DirectionalInput::add_source(OrdinateIndex, float*) const;
template void DirectionalInput::add_inflow(OrdinateIndex, const SweepSlotsOf<double>&,
                                           std::span<double>) const;
template void DirectionalInput::add_inflow(OrdinateIndex, const SweepSlotsOf<float>&,
                                           std::span<double>) const;

}  // namespace etendue
