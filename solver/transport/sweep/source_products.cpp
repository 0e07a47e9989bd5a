// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/source_products.h"

#include <algorithm>

#include "solver/transport/order/projected_area.h"

namespace etendue {
namespace {

/// Masses of cells and faces in the equations of a sweep are those of the integrals times this.
constexpr double mass_factor = 12;

OrdinateIndex opposite(OrdinateIndex m) { return OrdinateIndex(m.value() ^ 1); }

}  // namespace

template <class Real>
void SourceProducts::add_cell(const AngularInput& source, OrdinateIndex m, CellIndex cell,
                              const Real* radiance, double weight, std::span<double> products) const {
  const auto bands = static_cast<std::size_t>(d_.cells.bands());
  const auto stride = static_cast<std::size_t>(d_.cells.stride());
  const auto nodes = static_cast<std::size_t>(d_.cells.nodes());
  // Of constant elements the mass is the volume.
  const double factor = weight * d_.cells.scale(cell) / (nodes == 1 ? 1 : mass_factor);
  std::vector<double> values(4 * bands);
  const auto add = [&](std::size_t b, const CellCoefficients::SourceFactors& mass) {
    double total = 0, all = 0, own = 0;
    for (std::size_t i = 0; i < 4; ++i) total += values[i * bands + b];
    for (std::size_t i = 0; i < nodes; ++i) {
      const auto u = static_cast<double>(radiance[i * stride + b]);
      all += u;
      own += u * (nodes == 1 ? total / 4 : values[i * bands + b]);
    }
    products[b] += factor * (mass.sum * total * all + mass.own * own);
  };
  source.add_source(m, cell, values);
  for (std::size_t b = 0; b < bands; ++b) add(b, d_.cells.source_factors(cell, static_cast<int>(b)));
  std::ranges::fill(values, 0.0);
  source.add_projected_source(m, cell, values);
  for (std::size_t b = 0; b < bands; ++b) add(b, d_.cells.projected_source_factors(cell));
}

template <class Real>
void SourceProducts::add_walls(const AngularInput& source, OrdinateIndex m, const SweepSlotsOf<Real>& slots,
                               std::span<double> products) const {
  const TetrahedralMesh& mesh = d_.problem.mesh();
  const auto bands = static_cast<std::size_t>(d_.cells.bands());
  const auto nodes = static_cast<std::size_t>(d_.cells.face_nodes());
  std::vector<double> values(3 * bands);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const double seen = projected_area(mesh.area_normal(face), d_.directions.direction(m));
    if (seen <= 0) continue;
    std::ranges::fill(values, 0.0);
    source.add_inflow(opposite(m), face, values);
    const double factor = seen * d_.directions.weight(m);
    for (std::size_t b = 0; b < bands; ++b) {
      const double total = values[b] + values[bands + b] + values[2 * bands + b];
      double all = 0, own = 0;
      for (std::size_t i = 0; i < nodes; ++i) {
        const auto u = static_cast<double>(slots.face_node(d_.orders->walls().inside(f), i)[b]);
        all += u;
        own += u * values[i * bands + b];
      }
      products[b] += factor * (nodes == 1 ? total * all / 3 : (total * all + own) / mass_factor);
    }
  }
}

template <class Real>
void SourceProducts::add(OrdinateIndex m, const Real* rows, const SweepSlotsOf<Real>& slots,
                         std::span<double> products) const {
  const auto stride = static_cast<std::size_t>(d_.cells.stride());
  for (std::size_t s = 0; s < d_.options.paired_sources.size(); ++s) {
    const AngularInput& source = *d_.options.paired_sources[s];
    const std::span<double> to = products.subspan(s * stride, stride);
    for (const std::int32_t c : d_.moments.angular_cells()) {
      const auto row = static_cast<std::size_t>(d_.moments.row(CellIndex(c)));
      if (source.depends_on_direction(CellIndex(c)))
        add_cell(source, opposite(m), CellIndex(c), rows + row * d_.moments.row_length(),
                 d_.directions.weight(m), to);
    }
    add_walls(source, m, slots, to);
  }
}

void SourceProducts::add_isotropic(std::span<const double> fluence, std::span<double> products) const {
  const auto stride = static_cast<std::size_t>(d_.cells.stride());
  for (std::size_t s = 0; s < d_.options.paired_sources.size(); ++s) {
    const AngularInput& source = *d_.options.paired_sources[s];
    for (std::int32_t c = 0; c < d_.problem.mesh().cell_count(); ++c)
      if (!source.depends_on_direction(CellIndex(c)))
        add_cell(source, OrdinateIndex(0), CellIndex(c),
                 fluence.data() + static_cast<std::size_t>(c) * d_.cells.cell_length(), 1,
                 products.subspan(s * stride, stride));
  }
}

template void SourceProducts::add(OrdinateIndex, const double*, const SweepSlotsOf<double>&,
                                  std::span<double>) const;
template void SourceProducts::add(OrdinateIndex, const float*, const SweepSlotsOf<float>&,
                                  std::span<double>) const;

}  // namespace etendue
