// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/scattering_moments.h"

#include <fmt/format.h>

#include <algorithm>

namespace etendue {
namespace {

int highest(const std::vector<std::vector<int>>& degrees) {
  int degree = 0;
  for (const auto& bands : degrees)
    for (const int d : bands) degree = std::max(degree, d);
  return degree;
}

/// The degree that each medium and band needs on this set, and why.
std::vector<std::vector<int>> needed_degrees(const Problem& problem, const DirectionSet& directions,
                                             std::vector<std::string>& reasons) {
  std::vector<std::vector<int>> degrees;
  for (const Medium& medium : problem.media()) {
    degrees.emplace_back();
    for (const PhaseFunction& phase : medium.phase) {
      const ScatteringDegree chosen = scattering_degree(phase, directions);
      degrees.back().push_back(chosen.degree);
      reasons.push_back(chosen.reason);
    }
  }
  return degrees;
}

}  // namespace

ScatteringMoments::ScatteringMoments(const Problem& problem, const DirectionSet& directions,
                                     const CellCoefficients& cells, std::span<const CellIndex> observed)
    : problem_(problem),
      directions_(directions),
      cells_(cells),
      degree_(needed_degrees(problem, directions, reason_)),
      harmonics_(directions, highest(degree_)),
      row_length_(cells.cell_length()) {
  find_angular_cells(observed);
  fill_factors();
  report_kernels();
}

void ScatteringMoments::find_angular_cells(std::span<const CellIndex> observed) {
  const TetrahedralMesh& mesh = problem_.mesh();
  index_.assign(static_cast<std::size_t>(mesh.cell_count()) + 1, 0);
  for (const CellIndex cell : observed) index_[cell.at()] = 1;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const auto& degrees = degree_[static_cast<std::size_t>(mesh.region(cell))];
    for (int band = 0; band < problem_.band_count(); ++band)
      if (degrees[static_cast<std::size_t>(band)] > 0 && problem_.scattering(cell, band) > 0)
        index_[cell.at()] = 1;
    if (index_[cell.at()] == 0) continue;
    angular_cells_.push_back(c);
    index_[cell.at()] = static_cast<std::int32_t>(angular_cells_.size());
  }
}

void ScatteringMoments::fill_factors() {
  for (std::int32_t m = 0; m < directions_.count(); ++m)
    for (int k = 0; k < moment_count(); ++k) {
      const double value = harmonics_.value(k, OrdinateIndex(m));
      evaluation_.push_back(value);
      integration_.push_back(value * directions_.weight(OrdinateIndex(m)));
    }
  const auto stride = static_cast<std::size_t>(cells_.stride());
  phase_moments_.assign(degree_.size() * count() * stride, 0);
  for (std::size_t region = 0; region < degree_.size(); ++region)
    for (std::size_t band = 0; band < degree_[region].size(); ++band)
      for (std::size_t k = 0; k < count(); ++k) {
        const int degree = harmonics_.degree_of(static_cast<int>(k));
        if (degree > degree_[region][band]) continue;
        phase_moments_[(region * count() + k) * stride + band] =
            phase_moment(problem_.medium(static_cast<int>(region)).phase[band], degree);
      }
}

void ScatteringMoments::form_source(const TransportState& state, Emission emission, std::int32_t first,
                                    std::int32_t last, double* records, double* moments) const {
  const RecordLayout layout = cells_.layout();
  const std::size_t nodes = static_cast<std::size_t>(cells_.nodes());
  const std::size_t stride = static_cast<std::size_t>(cells_.stride());
  const int bands = problem_.band_count();
  // right_i = sum (s_0 + s_1 + s_2 + s_3) + own s_i with s = constant + factor phi
  const auto apply = [&](const double* field, std::size_t band, double constant, double factor,
                         CellCoefficients::SourceFactors mass, double* right) {
    double total = 0;
    for (std::size_t i = 0; i < nodes; ++i) total += constant + factor * field[i * stride + band];
    for (std::size_t i = 0; i < nodes; ++i)
      right[i * stride + band] = mass.sum * total + mass.own * (constant + factor * field[i * stride + band]);
  };
  for (std::int32_t c = first; c < last; ++c) {
    const CellIndex cell(c);
    const std::int32_t row = index_[cell.at()];
    const double* fluence = state.fluence().data() + cell.at() * row_length_;
    double* right = row > 0 ? moments + static_cast<std::size_t>(row - 1) * count() * row_length_
                            : records + cell.at() * layout.length + layout.source;
    const auto region = static_cast<std::size_t>(problem_.mesh().region(cell));
    for (int b = 0; b < bands; ++b) {
      const auto band = static_cast<std::size_t>(b);
      const CellCoefficients::SourceFactors mass = cells_.source_factors(cell, b);
      const double factor = problem_.scattering(cell, b) / full_range(problem_.space());
      apply(fluence, band, emission == Emission::included ? problem_.emission(cell, b) : 0, factor, mass,
            right);
      for (std::size_t k = 1; row > 0 && k < count(); ++k) {
        const std::size_t at = static_cast<std::size_t>(row - 1) * count() + k;
        apply(state.moments().data() + at * row_length_, band, 0,
              factor * phase_moments_[(region * count() + k) * stride + band], mass,
              moments + at * row_length_);
      }
    }
  }
}

void ScatteringMoments::form_unit_source(double* records, double* moments) const {
  const RecordLayout layout = cells_.layout();
  const auto nodes = static_cast<std::size_t>(cells_.nodes());
  const auto stride = static_cast<std::size_t>(cells_.stride());
  std::fill(moments, moments + moments_size(), 0.0);
  for (std::int32_t c = 0; c < problem_.mesh().cell_count(); ++c) {
    const CellIndex cell(c);
    const auto row = static_cast<std::size_t>(index_[cell.at()]);
    double* right = row > 0 ? moments + (row - 1) * count() * row_length_
                            : records + cell.at() * layout.length + layout.source;
    for (int b = 0; b < problem_.band_count(); ++b) {
      const CellCoefficients::SourceFactors mass = cells_.source_factors(cell, b);
      for (std::size_t i = 0; i < nodes; ++i)
        right[i * stride + static_cast<std::size_t>(b)] = mass.sum * static_cast<double>(nodes) + mass.own;
    }
  }
}

void ScatteringMoments::report_kernels() {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  for (std::size_t region = 0; region < degree_.size(); ++region) {
    const Medium& medium = problem_.medium(static_cast<int>(region));
    for (std::size_t band = 0; band < bands; ++band) {
      if (medium.scattering[band].is_constant() && medium.scattering[band].at(Vec3::Zero()) == 0) continue;
      const ScatteringAccuracy accuracy =
          scattering_accuracy(medium.phase[band], degree_[region][band], directions_);
      kernels_.push_back(
          {medium.name, problem_.bands().names[band], accuracy.asymmetry, accuracy.energy_error,
           fmt::format("moments, degree {} ({})", degree_[region][band], reason_[region * bands + band])});
    }
  }
}

}  // namespace etendue
