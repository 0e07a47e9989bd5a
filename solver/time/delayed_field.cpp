// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/delayed_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "base/field_view.h"
#include "base/parallel/parallel_for.h"
#include "base/quadrature/cell_rule.h"
#include "base/quadrature/simplex_rules.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/problem/phase_list.h"

namespace etendue {
namespace {

/// Times that differ by less than this part of those from end to end of a cell, or of those of all beams of
/// a source, are one.
constexpr double part_of_cell = 1. / 32, part_of_all = 1. / 128;

template <std::size_t nodes>
double sum_of(const std::array<double, nodes>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

/// Points of a cell: near a point light, which is unlike anything that a rule integrates, those of its parts.
const std::vector<CellRulePoint>& rule_for(const LightSource& source, const Vec3& centroid, double edge) {
  if (source.as_wide() != nullptr || !source.is_near(centroid, edge)) return composite_cell_rule(0);
  if (source.as_point() == nullptr) return composite_cell_rule(1);
  return composite_cell_rule(source.is_near(centroid, edge / 3) ? 3 : 2);
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

/// Gathers the beams of one cell or face; of one thread.
class DelayedField::Collector {
 public:
  Collector(const PathTimes& times, const UncollidedField& steady, std::span<const std::size_t> sources,
            std::size_t bands)
      : times_(times),
        steady_(steady),
        sources_(sources),
        bands_(bands),
        phases_(times.lights().problem()),
        matter_(times.lights().paths().matter()),
        room_(times.room()) {}

  Place cell(CellIndex cell) {
    const Problem& problem = times_.lights().problem();
    const TetrahedralMesh& mesh = problem.mesh();
    const std::array<Vec3, 4> corners = corners_of(mesh, cell);
    const double volume = mesh.volume(cell);
    const double edge = std::cbrt(6 * std::numbers::sqrt2 * volume);  // of a regular one
    const double slow = times_.slowness()[static_cast<std::size_t>(mesh.region(cell))];
    const bool by_direction =
        !steady_.collisions.empty() && scatters_by_direction(problem, phases_, matter_, cell);
    place_ = {};
    for (const std::size_t source : sources_) {
      begin();
      const auto& rule = rule_for(times_.source(source), mesh.centroid(cell), edge);
      spread_ = slow * edge / std::cbrt(static_cast<double>(rule.size()));
      for (const CellRulePoint& point : rule) {
        const Vec3 position = point_at(point.barycentric, corners);
        times_.beams_at({cell, position}, source, coarse_light, room_, [&](const TimedBeam& beam) {
          add(beam, point.barycentric, point.weight * volume);
          if (by_direction) add_scattering(cell, beam.direction, position);
        });
      }
      bundle(source, slow * edge, by_direction ? &cell : nullptr);
    }
    return finished();
  }

  Place face(FaceIndex face) {
    const TetrahedralMesh& mesh = times_.lights().problem().mesh();
    const std::array<Vec3, 3> corners = corners_of(mesh, face);
    const CellIndex cell = mesh.owner(face);
    const double area = mesh.area(face);
    const Vec3 normal = mesh.area_normal(face) / area;
    const double slow = times_.slowness()[static_cast<std::size_t>(mesh.region(cell))];
    place_ = {};
    for (const std::size_t source : sources_) {
      begin();
      spread_ = slow * std::sqrt(2 * area / static_cast<double>(seven_point_rule().size()));
      for (const FacePointWeight& point : seven_point_rule()) {
        const auto& b = point.barycentric;
        const Vec3 position = b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2];
        times_.beams_at({cell, position}, source, coarse_light, room_, [&](const TimedBeam& beam) {
          const double cosine = normal.dot(beam.direction);
          if (cosine > 0) add(beam, b, point.weight * area * cosine);
        });
      }
      bundle(source, slow * std::sqrt(2 * area), nullptr);
    }
    return finished();
  }

 private:
  void begin() {
    arrivals_.clear();
    weights_.clear();
    scattering_.clear();
  }

  void add(const TimedBeam& beam, std::span<const double> shape, double measure) {
    arrivals_.push_back({beam.direction, beam.time});
    for (const double value : shape)
      for (std::size_t b = 0; b < bands_; ++b) weights_.push_back(measure * value * beam.fluence[b]);
  }

  void add_scattering(CellIndex cell, const Vec3& direction, const Vec3& position) {
    const RayMatter::View view = matter_.empty() ? RayMatter::View{} : matter_.view(direction);
    for (std::size_t b = 0; b < bands_; ++b)
      scattering_.push_back(matter_.at(cell, b, view, position).scattering);
  }

  /// Adds beams of a source to the place, in intervals of their times; by direction in a cell.
  void bundle(std::size_t source, double across, const CellIndex* by_direction) {
    if (arrivals_.empty()) return;
    const auto [first, last] = std::ranges::minmax(arrivals_, {}, &Arrival::time);
    const double width = std::max(across * part_of_cell, part_of_all * (last.time - first.time));
    const std::size_t length = weights_.size() / arrivals_.size();
    open_.clear();
    for (std::size_t k = 0; k < arrivals_.size(); ++k) {
      const auto interval = static_cast<std::int64_t>((arrivals_[k].time - first.time) / width);
      const std::span<const double> own(weights_.data() + k * length, length);
      const auto number = static_cast<std::int32_t>(source);
      add_weights(open({-1, interval}, number, length), own, arrivals_[k].time, 1, {});
      if (by_direction == nullptr) continue;
      const std::optional<OctahedralGrid::Weights> incident =
          weights_of(arrivals_[k].direction, steady_.collisions.directions_at(*by_direction));
      for (std::size_t v = 0; v < 3 && incident; ++v)
        if (incident->weight[v] != 0)
          add_weights(open({incident->point[v], interval}, number, length), own, arrivals_[k].time,
                      incident->weight[v], std::span(scattering_).subspan(k * bands_, bands_));
    }
  }

  /// On the finest grid of which the cell has the directions around this one; empty where it has them of
  /// none.
  std::optional<OctahedralGrid::Weights> weights_of(const Vec3& direction,
                                                    std::span<const std::int32_t> known) const {
    for (const AngularDetail detail : {AngularDetail::fine, AngularDetail::medium, AngularDetail::coarse}) {
      const OctahedralGrid::Weights weights = steady_.collisions.directions().weights(direction, detail);
      bool all = true;
      for (std::size_t v = 0; v < 3; ++v)
        all = all && (weights.weight[v] == 0 || std::ranges::binary_search(known, weights.point[v]));
      if (all) return weights;
    }
    return std::nullopt;
  }

  /// The bundle of an incident number and an interval of times of the source at hand.
  std::size_t open(const std::pair<std::int32_t, std::int64_t>& key, std::int32_t source,
                   std::size_t length) {
    const auto [at, is_new] = open_.try_emplace(key, place_.bundles.size());
    if (is_new) {
      place_.bundles.push_back({source, key.first, 0, spread_});
      place_.weights.resize(place_.weights.size() + length, 0);
      totals_.push_back(0);
    }
    return at->second;
  }

  /// Adds weights, times a factor and another one [band]; the time is the sum until all are in.
  void add_weights(std::size_t bundle, std::span<const double> weights, double time, double factor,
                   std::span<const double> of_band) {
    double* const to = place_.weights.data() + bundle * weights.size();
    double total = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double weight = factor * weights[i] * (of_band.empty() ? 1 : of_band[i % bands_]);
      to[i] += weight;
      total += weight;
    }
    place_.bundles[bundle].time += total * time;
    totals_[bundle] += total;
  }

  Place finished() {
    for (std::size_t k = 0; k < totals_.size(); ++k)
      if (totals_[k] > 0) place_.bundles[k].time /= totals_[k];
    totals_.clear();
    return in_order(place_);
  }

  static Place in_order(const Place& place) {
    const std::size_t count = place.bundles.size(), length = count == 0 ? 0 : place.weights.size() / count;
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return place.bundles[k].incident; });
    Place sorted;
    sorted.bundles.reserve(count);
    sorted.weights.reserve(place.weights.size());
    for (const std::size_t k : order) {
      sorted.bundles.push_back(place.bundles[k]);
      const auto own = place.weights.begin() + static_cast<std::ptrdiff_t>(k * length);
      sorted.weights.insert(sorted.weights.end(), own, own + static_cast<std::ptrdiff_t>(length));
    }
    return sorted;
  }

  struct Arrival {
    Vec3 direction;
    double time;
  };

  const PathTimes& times_;
  const UncollidedField& steady_;
  std::span<const std::size_t> sources_;
  std::size_t bands_;
  PhaseList phases_;
  const RayMatter& matter_;
  LightBeams room_;
  double spread_ = 0;               ///< of times in the part of a place that a point has
  std::vector<Arrival> arrivals_;   ///< of one source
  std::vector<double> weights_;     ///< [arrival][node][band]
  std::vector<double> scattering_;  ///< [arrival][band]; empty where it does not matter by direction
  Place place_;
  std::vector<double> totals_;                                         ///< [bundle] all weights
  std::map<std::pair<std::int32_t, std::int64_t>, std::size_t> open_;  ///< bundles of one source
};

/// Sums over bundles that have one incident number: of the weights, and of these times the factors.
template <std::size_t nodes>
class DelayedField::Sums {
 public:
  /// `factors` are [bundle][factor].
  Sums(const Place& place, std::int32_t incident, std::size_t bands, std::span<const double> factors,
       std::size_t factor_count)
      : bands_(bands), weights_(nodes * bands, 0), multiplied_(factor_count * nodes * bands, 0) {
    const auto [first, last] = std::ranges::equal_range(place.bundles, incident, {}, &Bundle::incident);
    for (auto bundle = first; bundle != last; ++bundle) {
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
  const auto make = [&] { return Collector(times, *steady_, sources_, bands_); };
  parallel_for(cells_.size(), threads, 64, make, [&](std::size_t c, Collector& collector) {
    if (any_positive(std::span(steady_->fluence).subspan(c * 4 * bands_, 4 * bands_)))
      cells_[c] = collector.cell(CellIndex(static_cast<std::int64_t>(c)));
    return counter.add();
  });
  parallel_for(faces_.size(), threads, 64, make, [&](std::size_t f, Collector& collector) {
    if (any_positive(std::span(steady_->irradiance).subspan(f * 3 * bands_, 3 * bands_)))
      faces_[f] = collector.face(FaceIndex(static_cast<std::int64_t>(f)));
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
    const Place& cell = cells_[mesh.owner(FaceIndex(static_cast<std::int64_t>(f))).at()];
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
  Place& place = cells_[cell.at()];
  std::vector<double> one(bands_);
  const TetrahedralMesh& mesh = times_.lights().problem().mesh();
  const double spread =
      std::cbrt(mesh.volume(cell)) * times_.slowness()[static_cast<std::size_t>(mesh.region(cell))];
  for (const std::size_t source : sources_) {
    const auto beam = times_.time_of_beam({cell, mesh.centroid(cell)}, source, one);
    if (!beam) continue;
    place.bundles.push_back({static_cast<std::int32_t>(source), -1, beam->time, spread});
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

std::vector<double> DelayedField::factors_of(const Place& place, const DelayFactors& factors) {
  std::vector<double> values(place.bundles.size() * factors.count());
  for (std::size_t k = 0; k < place.bundles.size(); ++k)
    factors.set(
        {static_cast<std::size_t>(place.bundles[k].source), place.bundles[k].time, place.bundles[k].spread},
        std::span(values).subspan(k * factors.count(), factors.count()));
  return values;
}

void DelayedField::add_cell(CellIndex cell, const DelayFactors& factors, UncollidedField& field) const {
  const Place& place = cells_[cell.at()];
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
  const Place& place = faces_[face.at()];
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
