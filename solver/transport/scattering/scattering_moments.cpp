// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/scattering/scattering_moments.h"

#include <algorithm>
#include <array>

namespace etendue {
ScatteringMoments::ScatteringMoments(const Problem& problem, const DirectionSet& directions,
                                     const CellCoefficients& cells,
                                     const std::vector<ScatteringTreatment>& plan,
                                     const OrdinateSchedule& schedule, std::span<const CellIndex> observed)
    : problem_(problem),
      directions_(directions),
      cells_(cells),
      plan_(plan),
      harmonics_(directions, highest_degree(plan)),
      orbits_(directions, harmonics_, schedule),
      row_length_(cells.cell_length()) {
  find_angular_cells(observed);
  fill_phase_moments();
}

void ScatteringMoments::find_angular_cells(std::span<const CellIndex> observed) {
  const TetrahedralMesh& mesh = problem_.mesh();
  index_.assign(static_cast<std::size_t>(mesh.cell_count()) + 1, 0);
  for (const CellIndex cell : observed) index_[cell.at()] = 1;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    for (int band = 0; band < problem_.band_count(); ++band) {
      const ScatteringTreatment& how = treatment(mesh.region(cell), band);
      if (how.is_dense() || (how.degree > 0 && problem_.scattering(cell, band) > 0)) index_[cell.at()] = 1;
    }
    if (index_[cell.at()] == 0) continue;
    angular_cells_.push_back(c);
    index_[cell.at()] = static_cast<std::int32_t>(angular_cells_.size());
  }
}

void ScatteringMoments::fill_phase_moments() {
  const auto stride = static_cast<std::size_t>(cells_.stride());
  phase_moments_.assign(problem_.media().size() * count() * stride, 0);
  for (std::size_t region = 0; region < problem_.media().size(); ++region)
    for (int b = 0; b < problem_.band_count(); ++b) {
      const ScatteringTreatment& how = treatment(static_cast<int>(region), b);
      const auto band = static_cast<std::size_t>(b);
      const PhaseFunction& phase = problem_.media()[region].phase[band];
      for (std::size_t k = 0; k < count() && !how.is_dense(); ++k) {
        const int degree = harmonics_.degree_of(static_cast<int>(k));
        if (degree > how.degree) continue;
        phase_moments_[(region * count() + k) * stride + band] =
            (1 - how.forward) * reduced_moment(phase, degree, how.forward);
      }
    }
}

template <class Real>
void ScatteringMoments::form_source(const TransportState& state, Emission emission, std::int32_t first,
                                    std::int32_t last, Real* records, Real* moments) const {
  const RecordLayout layout = cells_.layout();
  const std::size_t nodes = static_cast<std::size_t>(cells_.nodes());
  const std::size_t stride = static_cast<std::size_t>(cells_.stride());
  const int bands = problem_.band_count();
  // right_i = sum (s_0 + s_1 + s_2 + s_3) + own s_i with s = emitted + factor phi
  const auto apply = [&](const double* field, std::size_t band, const std::array<double, 4>& emitted,
                         double factor, CellCoefficients::SourceFactors mass, Real* right) {
    double total = 0;
    for (std::size_t i = 0; i < nodes; ++i) total += emitted[i] + factor * field[i * stride + band];
    for (std::size_t i = 0; i < nodes; ++i)
      right[i * stride + band] =
          static_cast<Real>(mass.sum * total + mass.own * (emitted[i] + factor * field[i * stride + band]));
  };
  const CellEmission& emitted = problem_.cell_emission();
  const auto emitted_in = [&](CellIndex cell, std::size_t band) {
    std::array<double, 4> values = {};
    for (std::size_t i = 0; i < nodes && emission == Emission::included; ++i)
      values[i] = nodes == 1 ? emitted.mean(cell, band) : emitted.at(cell, band, i);
    return values;
  };
  for (std::int32_t c = first; c < last; ++c) {
    const CellIndex cell(c);
    const std::int32_t row = index_[cell.at()];
    const double* fluence = state.fluence().data() + cell.at() * row_length_;
    Real* right = row > 0 ? moments + static_cast<std::size_t>(row - 1) * count() * row_length_
                          : records + cell.at() * layout.length + layout.source;
    const auto region = static_cast<std::size_t>(problem_.mesh().region(cell));
    for (int b = 0; b < bands; ++b) {
      const auto band = static_cast<std::size_t>(b);
      const CellCoefficients::SourceFactors mass = cells_.source_factors(cell, b);
      const double factor = problem_.scattering(cell, b) / full_range(problem_.space());
      apply(fluence, band, emitted_in(cell, band), factor * phase_moments_[region * count() * stride + band],
            mass, right);
      for (std::size_t k = 1; row > 0 && k < count(); ++k) {
        const std::size_t at = static_cast<std::size_t>(row - 1) * count() + k;
        apply(state.moments().data() + at * row_length_, band, {},
              factor * phase_moments_[(region * count() + k) * stride + band], mass,
              moments + at * row_length_);
      }
    }
  }
}

template <class Real>
void ScatteringMoments::form_unit_source(Real* records, Real* moments) const {
  const RecordLayout layout = cells_.layout();
  const auto nodes = static_cast<std::size_t>(cells_.nodes());
  const auto stride = static_cast<std::size_t>(cells_.stride());
  std::fill(moments, moments + moments_size(), Real{});
  for (std::int32_t c = 0; c < problem_.mesh().cell_count(); ++c) {
    const CellIndex cell(c);
    const auto row = static_cast<std::size_t>(index_[cell.at()]);
    Real* right = row > 0 ? moments + (row - 1) * count() * row_length_
                          : records + cell.at() * layout.length + layout.source;
    for (int b = 0; b < problem_.band_count(); ++b) {
      const CellCoefficients::SourceFactors mass = cells_.source_factors(cell, b);
      for (std::size_t i = 0; i < nodes; ++i)
        right[i * stride + static_cast<std::size_t>(b)] =
            static_cast<Real>(mass.sum * static_cast<double>(nodes) + mass.own);
    }
  }
}

template void ScatteringMoments::form_source(const TransportState&, Emission, std::int32_t, std::int32_t,
                                             double*, double*) const;
template void ScatteringMoments::form_unit_source(double*, double*) const;

template void ScatteringMoments::form_source(const TransportState&, Emission, std::int32_t, std::int32_t,
                                             float*, float*) const;
template void ScatteringMoments::form_unit_source(float*, float*) const;

}  // namespace etendue
