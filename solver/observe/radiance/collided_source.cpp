// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/radiance/collided_source.h"

#include <algorithm>
#include <numeric>

#include "solver/observe/radiance/quadratic_reconstruction.h"

namespace etendue {
namespace {

/// Values that a cell has in each band.
std::size_t nodes_of(const SolveOptions& options, const SavedState& state, std::size_t cells_and_bands) {
  if (options.order != SpaceOrder::linear) return 1;
  return state.fluence.size() == quadratic_nodes * cells_and_bands ? quadratic_nodes : 4;
}

}  // namespace

CollidedSource::CollidedSource(const LightSetup& lights, const DirectionSet& directions,
                               const SolveOptions& options, const SavedState& state)
    : lights_(lights),
      problem_(lights.problem()),
      directions_(directions),
      state_(state),
      bands_(lights.paths().bands()),
      nodes_(nodes_of(options, state, static_cast<std::size_t>(problem_.mesh().cell_count()) * bands_)),
      plan_(plan_scattering(problem_, directions)),
      harmonics_(directions, highest_degree(plan_)),
      phases_(problem_),
      matter_(problem_, directions),
      swept_lights_(problem_, directions, nullptr) {
  const auto cells = static_cast<std::size_t>(problem_.mesh().cell_count());
  find_rows(lights, options);
  const auto rows = static_cast<std::size_t>(*std::max_element(row_.begin(), row_.end()));
  const auto dense = static_cast<std::size_t>(*std::max_element(dense_row_.begin(), dense_row_.end()) + 1);
  if (state.fluence.size() != cells * nodes_ * bands_ ||
      state.moments.size() != rows * count() * nodes_ * bands_ ||
      state.radiance.size() != static_cast<std::size_t>(directions.count()) * dense * nodes_ * bands_)
    throw InputError(
        "the saved state is not of this kind (other elements, directions, scattering or probes)");
  factors_.assign(problem_.media().size() * count() * bands_, 0);
  for (std::size_t region = 0; region < problem_.media().size(); ++region)
    for (std::size_t b = 0; b < bands_; ++b) {
      const ScatteringTreatment& how = plan_[region * bands_ + b];
      for (std::size_t k = 0; k < count() && !how.is_dense(); ++k) {
        const int degree = harmonics_.discrete().degree_of(static_cast<int>(k));
        if (degree > how.degree) continue;
        factors_[(region * count() + k) * bands_ + b] =
            (1 - how.forward) * reduced_moment(problem_.media()[region].phase[b], degree, how.forward) /
            full_range(problem_.space());
      }
    }
  for (std::size_t c = 0; c < cells; ++c) {
    const auto region = static_cast<std::size_t>(problem_.mesh().region(CellIndex(static_cast<int>(c))));
    for (std::size_t b = 0; b < bands_; ++b)
      extinction_.push_back(problem_.absorption()[c * bands_ + b] +
                            (1 - plan_[region * bands_ + b].forward) * problem_.scattering()[c * bands_ + b]);
  }
  take_dense_radiance(directions);
}

// The cells whose moments a sweep keeps: where scattering is anisotropic, where it wrote each direction for
// light that scatters first or that lights left to the directions send, and where a meter stood.
void CollidedSource::find_rows(const LightSetup& lights, const SolveOptions& options) {
  const TetrahedralMesh& mesh = problem_.mesh();
  row_.assign(static_cast<std::size_t>(mesh.cell_count()), 0);
  dense_row_.assign(row_.size(), -1);
  for (const IrradianceMeter& meter : options.meters)
    for (const CellPoint& point : meter.cells) row_[point.cell.at()] = 1;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const int region = mesh.region(cell);
    if (swept_lights_.depends_on_direction(cell)) row_[cell.at()] = 1;
    for (std::size_t b = 0; b < bands_; ++b) {
      const ScatteringTreatment& how = plan_[static_cast<std::size_t>(region) * bands_ + b];
      const bool scatters = problem_.scattering(cell, static_cast<int>(b)) > 0;
      const bool lit = !lights.empty() && phases_.of(region, b) >= 0;
      if (how.is_dense() || (scatters && (how.degree > 0 || lit))) row_[cell.at()] = 1;
    }
  }
  std::int32_t rows = 0;
  for (std::int32_t& row : row_)
    if (row > 0) row = ++rows;
  std::int32_t dense = 0;
  for (const CellIndex cell : dense_cells(problem_, plan_)) dense_row_[cell.at()] = dense++;
}

void CollidedSource::take_dense_radiance(const DirectionSet& directions) {
  const auto ordinates = static_cast<std::size_t>(directions.count());
  const std::size_t values = state_.radiance.size() / ordinates;
  dense_radiance_.resize(state_.radiance.size());
  for (std::size_t n = 0; n < ordinates; ++n)
    for (std::size_t i = 0; i < values; ++i)
      dense_radiance_[i * ordinates + n] = state_.radiance[n * values + i];
}

CollidedSource::View CollidedSource::view(const Vec3& travel) const {
  View view;
  view.harmonics.resize(count());
  harmonics_.at(travel, view.harmonics);
  if (dense_radiance_.empty()) return view;
  view.matter = matter_.views(travel);
  for (const PhaseFunction& phase : phases_.phases()) {
    const std::size_t first = view.weights.size();
    for (std::size_t n = 0; n < directions_.directions().size(); ++n)
      view.weights.push_back(
          directions_.weights()[n] *
          phase_value(phase, std::clamp(travel.dot(directions_.directions()[n]), -1., 1.)));
    const double sum =
        std::accumulate(view.weights.begin() + static_cast<std::ptrdiff_t>(first), view.weights.end(), 0.0);
    for (std::size_t n = first; n < view.weights.size(); ++n) view.weights[n] /= sum;
  }
  return view;
}

double CollidedSource::dense(std::size_t row, std::size_t node, std::size_t band,
                             const double* weights) const {
  const auto ordinates = static_cast<std::size_t>(directions_.count());
  return std::inner_product(
      weights, weights + ordinates,
      dense_radiance_.begin() +
          static_cast<std::ptrdiff_t>(((row * nodes_ + node) * bands_ + band) * ordinates),
      0.0);
}

void CollidedSource::values(CellIndex cell, const View& view, std::span<double> values) const {
  const int region = problem_.mesh().region(cell);
  const bool emits = !lights_.has_region(region);
  const auto row = static_cast<std::size_t>(row_[cell.at()]);
  for (std::size_t i = 0; i < value_count(); ++i) {
    const std::size_t node = nodes_ == 1 ? 0 : i;
    for (std::size_t b = 0; b < bands_; ++b) {
      const auto band = static_cast<int>(b);
      double value = emits && i < 4 ? problem_.cell_emission().at(cell, b, i) : 0;
      const double scattering = problem_.scattering(cell, band);
      if (const int matter = matter_.of(region, b); matter >= 0) {
        const DirectionalMatter::View& seen = view.matter[static_cast<std::size_t>(matter)];
        value += matter_.density(cell, b) * seen.scattered *
                 dense(static_cast<std::size_t>(dense_row_[cell.at()]), node, b, seen.weights.data());
      } else if (scattering > 0) {
        const int phase = phases_.of(region, b);
        double sum = factor(region, 0, b) * state_.fluence[(cell.at() * nodes_ + node) * bands_ + b];
        for (std::size_t k = 1; row > 0 && k < count(); ++k)
          sum += factor(region, k, b) * view.harmonics[k] *
                 state_.moments[(((row - 1) * count() + k) * nodes_ + node) * bands_ + b];
        if (plan_[static_cast<std::size_t>(region) * bands_ + b].is_dense())
          sum = phase < 0
                    ? state_.fluence[(cell.at() * nodes_ + node) * bands_ + b] / full_range(problem_.space())
                    : dense(static_cast<std::size_t>(dense_row_[cell.at()]), node, b,
                            &view.weights[static_cast<std::size_t>(phase) *
                                          static_cast<std::size_t>(directions_.count())]);
        value += scattering * sum;
      }
      values[i * bands_ + b] = value;
    }
  }
}

}  // namespace etendue
