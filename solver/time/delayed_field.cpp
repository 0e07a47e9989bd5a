// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/delayed_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/parallel/parallel_for.h"

namespace etendue {
namespace {

template <std::size_t nodes>
double sum_of(const std::array<double, nodes>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

/// Integrals with the functions of a simplex of so many corners and this measure, of nodal values, and back.
template <std::size_t nodes>
std::array<double, nodes> moments_of(const std::array<double, nodes>& nodal, double measure) {
  constexpr double n = nodes;
  const double sum = sum_of(nodal);
  std::array<double, nodes> moments;
  for (std::size_t i = 0; i < nodes; ++i) moments[i] = measure / (n * (n + 1)) * (nodal[i] + sum);
  return moments;
}
template <std::size_t nodes>
std::array<double, nodes> nodal_of(const std::array<double, nodes>& moments, double measure) {
  constexpr double n = nodes;
  const double sum = sum_of(moments);
  std::array<double, nodes> nodal;
  for (std::size_t i = 0; i < nodes; ++i) nodal[i] = n / measure * ((n + 1) * moments[i] - sum);
  return nodal;
}

/// Of one band of a cell or face, values [node][band].
template <std::size_t nodes>
std::array<double, nodes> band_of(const double* values, std::size_t bands, std::size_t band) {
  std::array<double, nodes> of_band;
  for (std::size_t i = 0; i < nodes; ++i) of_band[i] = values[i * bands + band];
  return of_band;
}
template <std::size_t nodes>
void add_band(double* values, std::size_t bands, std::size_t band, const std::array<double, nodes>& more) {
  for (std::size_t i = 0; i < nodes; ++i) values[i * bands + band] += more[i];
}

bool any_positive(std::span<const double> values) {
  return std::ranges::any_of(values, [](double value) { return value > 0; });
}

}  // namespace

/// Sums over bundles that have one incident number: of the weights, and of these times the factors.
template <std::size_t nodes>
class DelayedField::Sums {
 public:
  /// `factors` are [bundle][factor].
  Sums(const BundledBeams& place, std::int32_t incident, std::size_t bands, std::span<const double> factors,
       std::size_t factor_count)
      : bands_(bands), weights_(nodes * bands, 0), multiplied_(factor_count * nodes * bands, 0) {
    auto bundle = std::ranges::lower_bound(place.bundles, incident, {}, &BeamBundle::incident);
    for (; bundle != place.bundles.end() && bundle->incident == incident; ++bundle) {
      const auto k = static_cast<std::size_t>(bundle - place.bundles.begin());
      const double* const own = place.weights.data() + k * weights_.size();
      for (std::size_t i = 0; i < weights_.size(); ++i) {
        weights_[i] += own[i];
        for (std::size_t f = 0; f < factor_count; ++f)
          multiplied_[f * weights_.size() + i] += factors[k * factor_count + f] * own[i];
      }
    }
  }

  double weight(std::size_t node, std::size_t band) const { return weights_[node * bands_ + band]; }
  double multiplied(std::size_t f, std::size_t node, std::size_t band) const {
    return multiplied_[(f * nodes + node) * bands_ + band];
  }
  double ratio(std::size_t f, std::size_t node, std::size_t band) const {
    const double weight = this->weight(node, band);
    return weight > 0 ? multiplied(f, node, band) / weight : 0;
  }

 private:
  std::size_t bands_;
  std::vector<double> weights_;     ///< [node][band]
  std::vector<double> multiplied_;  ///< [factor][node][band]
};

DelayedField::DelayedField(const PathTimes& times, std::shared_ptr<const UncollidedField> steady,
                           std::vector<std::size_t> sources, int threads, const StageObserver& observer)
    : times_(times),
      steady_(std::move(steady)),
      sources_(std::move(sources)),
      bands_(static_cast<std::size_t>(times.lights().problem().band_count())) {
  const TetrahedralMesh& mesh = times.lights().problem().mesh();
  cells_.resize(static_cast<std::size_t>(mesh.cell_count()));
  faces_.resize(static_cast<std::size_t>(mesh.boundary_face_count()));
  StageCounter counter(cells_.size() + faces_.size(), observer);
  const auto make = [&] { return BeamBundler(times, *steady_, sources_); };
  parallel_for(cells_.size(), threads, 64, make, [&](std::size_t c, BeamBundler& bundler) {
    if (any_positive(std::span(steady_->fluence).subspan(c * 4 * bands_, 4 * bands_)))
      cells_[c] = bundler.cell(CellIndex(static_cast<std::int64_t>(c)));
    return counter.add();
  });
  parallel_for(faces_.size(), threads, 64, make, [&](std::size_t f, BeamBundler& bundler) {
    if (any_positive(std::span(steady_->irradiance).subspan(f * 3 * bands_, 3 * bands_)))
      faces_[f] = bundler.face(FaceIndex(static_cast<std::int64_t>(f)));
    return counter.add();
  });
  complete_ = !counter.stopped();
  if (complete_) fill_gaps();
}

void DelayedField::fill_gaps() {
  const TetrahedralMesh& mesh = times_.lights().problem().mesh();
  const auto is_gap = [&](std::size_t c) {
    return cells_[c].bundles.empty() &&
           any_positive(std::span(steady_->fluence).subspan(c * 4 * bands_, 4 * bands_));
  };
  for (std::size_t c = 0; c < cells_.size(); ++c)
    if (is_gap(c)) fill_from_beams(CellIndex(static_cast<std::int64_t>(c)));
  for (bool any = true; any;) {
    any = false;
    // Those that are filled in one round do not fill others in it: the order of cells does not matter.
    std::vector<std::pair<std::size_t, std::size_t>> filled;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (!is_gap(c)) continue;
      for (const std::int32_t f : mesh.faces(CellIndex(static_cast<std::int64_t>(c)))) {
        if (f < mesh.boundary_face_count()) continue;
        const FaceIndex face(f);
        const std::size_t owner = mesh.owner(face).at(), other = mesh.neighbour(face).at();
        const std::size_t beside = owner == c ? other : owner;
        if (cells_[beside].bundles.empty()) continue;
        filled.emplace_back(c, beside);
        break;
      }
    }
    for (const auto& [gap, beside] : filled) {
      cells_[gap] = cells_[beside];
      any = true;
    }
  }
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (!faces_[f].bundles.empty() ||
        !any_positive(std::span(steady_->irradiance).subspan(f * 3 * bands_, 3 * bands_)))
      continue;
    const BundledBeams& cell = cells_[mesh.owner(FaceIndex(static_cast<std::int64_t>(f))).at()];
    for (std::size_t k = 0; k < cell.bundles.size(); ++k) {
      if (cell.bundles[k].incident >= 0) continue;
      faces_[f].bundles.push_back(cell.bundles[k]);
      const double* const own = cell.weights.data() + k * 4 * bands_;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t b = 0; b < bands_; ++b)
          faces_[f].weights.push_back(own[b] + own[bands_ + b] + own[2 * bands_ + b] + own[3 * bands_ + b]);
    }
  }
}

void DelayedField::fill_from_beams(CellIndex cell) {
  BundledBeams& place = cells_[cell.at()];
  const TetrahedralMesh& mesh = times_.lights().problem().mesh();
  const double spread =
      std::cbrt(mesh.volume(cell)) * times_.slowness()[static_cast<std::size_t>(mesh.region(cell))];
  for (const std::size_t source : sources_) {
    const std::optional<double> time = times_.time_of_beam({cell, mesh.centroid(cell)}, source);
    if (!time) continue;
    place.bundles.push_back({static_cast<std::int32_t>(source), -1, *time, spread});
    place.weights.insert(place.weights.end(), 4 * bands_, 1.0);
  }
}

void DelayedField::add_to(const DelayFactors& factors, int threads, UncollidedField& field) const {
  parallel_for(cells_.size(), threads, 64, [&](std::size_t c) {
    add_cell(CellIndex(static_cast<std::int64_t>(c)), factors, field);
    return true;
  });
  parallel_for(faces_.size(), threads, 64, [&](std::size_t f) {
    add_face(FaceIndex(static_cast<std::int64_t>(f)), factors, field);
    return true;
  });
}

std::vector<double> DelayedField::factors_of(const BundledBeams& place, const DelayFactors& factors) {
  std::vector<double> values(place.bundles.size() * factors.count());
  for (std::size_t k = 0; k < place.bundles.size(); ++k)
    factors.set(
        {static_cast<std::size_t>(place.bundles[k].source), place.bundles[k].time, place.bundles[k].spread},
        std::span(values).subspan(k * factors.count(), factors.count()));
  return values;
}

void DelayedField::add_cell(CellIndex cell, const DelayFactors& factors, UncollidedField& field) const {
  const BundledBeams& place = cells_[cell.at()];
  if (place.bundles.empty()) return;
  const std::size_t count = factors.count(), all = bands_ * count;
  const double volume = times_.lights().problem().mesh().volume(cell);
  const std::vector<double> values = factors_of(place, factors);
  const Sums<4> sums(place, -1, bands_, values, count);
  const auto scaled = [&](const double* steady, std::size_t f, std::size_t b) {
    std::array<double, 4> moments = moments_of(band_of<4>(steady, bands_, b), volume);
    for (std::size_t i = 0; i < 4; ++i) moments[i] *= sums.ratio(f, i, b);
    return moments;
  };
  for (std::size_t f = 0; f < count; ++f)
    for (std::size_t b = 0; b < bands_; ++b) {
      const std::size_t band = factors.band_of(f, b, bands_), at = cell.at() * 4;
      const double* const fluence = &steady_->fluence[at * bands_];
      const std::array<double, 4> moments = scaled(fluence, f, b);
      add_band(&field.fluence[at * all], all, band, nodal_of(moments, volume));
      if (steady_->collided.empty()) continue;
      add_band(&field.collided[at * all], all, band,
               nodal_of(scaled(&steady_->collided[at * bands_], f, b), volume));
      const double steady = sum_of(moments_of(band_of<4>(fluence, bands_, b), volume));
      field.absorbed[cell.at() * all + band] +=
          steady > 0 ? steady_->absorbed[cell.at() * bands_ + b] * sum_of(moments) / steady : 0;
    }
  if (steady_->collisions.empty()) return;
  const std::span<const std::int32_t> incident = steady_->collisions.directions_at(cell);
  const std::span<const std::int32_t> known = field.collisions.directions_at(cell);
  for (std::size_t k = 0; k < incident.size(); ++k) {
    const auto at = std::ranges::lower_bound(known, incident[k]);
    if (at == known.end() || *at != incident[k]) continue;  // a trifle beside other sources
    const Sums<4> own(place, incident[k], bands_, values, count);
    const double* const steady = steady_->collisions.values(cell, k).data();
    double* const to = field.collisions.values(cell, static_cast<std::size_t>(at - known.begin())).data();
    for (std::size_t f = 0; f < count; ++f)
      for (std::size_t b = 0; b < bands_; ++b) {
        std::array<double, 4> moments = scaled(steady, f, b);
        for (std::size_t i = 0; i < 4; ++i)
          moments[i] += own.multiplied(f, i, b) - sums.ratio(f, i, b) * own.weight(i, b);
        add_band(to, all, factors.band_of(f, b, bands_), nodal_of(moments, volume));
      }
  }
}

void DelayedField::add_face(FaceIndex face, const DelayFactors& factors, UncollidedField& field) const {
  const BundledBeams& place = faces_[face.at()];
  if (place.bundles.empty()) return;
  const std::size_t count = factors.count(), all = bands_ * count;
  const double area = times_.lights().problem().mesh().area(face);
  const Sums<3> sums(place, -1, bands_, factors_of(place, factors), count);
  for (std::size_t f = 0; f < count; ++f)
    for (std::size_t b = 0; b < bands_; ++b) {
      std::array<double, 3> moments =
          moments_of(band_of<3>(&steady_->irradiance[face.at() * 3 * bands_], bands_, b), area);
      for (std::size_t i = 0; i < 3; ++i) moments[i] *= sums.ratio(f, i, b);
      add_band(&field.irradiance[face.at() * 3 * all], all, factors.band_of(f, b, bands_),
               nodal_of(moments, area));
    }
}

}  // namespace etendue
