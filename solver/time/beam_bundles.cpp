// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/beam_bundles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/quadrature/cell_rule.h"
#include "base/quadrature/simplex_rules.h"
#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

/// Times that differ by less than this part of those from end to end of a cell, or of those of all beams of
/// a source, are one.
constexpr double part_of_cell = 1. / 32, part_of_all = 1. / 128;

/// Points of a cell: near a point light, which is unlike anything that a rule integrates, those of its parts.
const std::vector<CellRulePoint>& rule_for(const LightSource& source, const Vec3& centroid, double edge) {
  if (source.as_wide() != nullptr || !source.is_near(centroid, edge)) return composite_cell_rule(0);
  if (source.as_point() == nullptr) return composite_cell_rule(1);
  return composite_cell_rule(source.is_near(centroid, edge / 3) ? 3 : 2);
}

BundledBeams in_order(const BundledBeams& place) {
  const std::size_t count = place.bundles.size(), length = count == 0 ? 0 : place.weights.size() / count;
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return place.bundles[k].incident; });
  BundledBeams sorted;
  sorted.bundles.reserve(count);
  sorted.weights.reserve(place.weights.size());
  for (const std::size_t k : order) {
    sorted.bundles.push_back(place.bundles[k]);
    const auto own = place.weights.begin() + static_cast<std::ptrdiff_t>(k * length);
    sorted.weights.insert(sorted.weights.end(), own, own + static_cast<std::ptrdiff_t>(length));
  }
  return sorted;
}

}  // namespace

BeamBundler::BeamBundler(const PathTimes& times, const UncollidedField& steady,
                         std::span<const std::size_t> sources)
    : times_(times),
      steady_(steady),
      sources_(sources),
      bands_(times.lights().paths().bands()),
      phases_(times.lights().problem()),
      matter_(times.lights().paths().matter()),
      room_(times.room()) {}

BundledBeams BeamBundler::cell(CellIndex cell) {
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

BundledBeams BeamBundler::face(FaceIndex face) {
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

void BeamBundler::begin() {
  arrivals_.clear();
  weights_.clear();
  scattering_.clear();
}

void BeamBundler::add(const TimedBeam& beam, std::span<const double> shape, double measure) {
  arrivals_.push_back({beam.direction, beam.time});
  for (const double value : shape)
    for (std::size_t b = 0; b < bands_; ++b) weights_.push_back(measure * value * beam.fluence[b]);
}

void BeamBundler::add_scattering(CellIndex cell, const Vec3& direction, const Vec3& position) {
  const RayMatter::View view = matter_.empty() ? RayMatter::View{} : matter_.view(direction);
  for (std::size_t b = 0; b < bands_; ++b)
    scattering_.push_back(matter_.at(cell, b, view, position).scattering);
}

void BeamBundler::bundle(std::size_t source, double across, const CellIndex* by_direction) {
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

std::optional<OctahedralGrid::Weights> BeamBundler::weights_of(const Vec3& direction,
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

std::size_t BeamBundler::open(const std::pair<std::int32_t, std::int64_t>& key, std::int32_t source,
                              std::size_t length) {
  const auto [at, is_new] = open_.try_emplace(key, place_.bundles.size());
  if (is_new) {
    place_.bundles.push_back({source, key.first, 0, spread_});
    place_.weights.resize(place_.weights.size() + length, 0);
    totals_.push_back(0);
  }
  return at->second;
}

void BeamBundler::add_weights(std::size_t bundle, std::span<const double> weights, double time, double factor,
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

BundledBeams BeamBundler::finished() {
  for (std::size_t k = 0; k < totals_.size(); ++k)
    if (totals_[k] > 0) place_.bundles[k].time /= totals_[k];
  totals_.clear();
  return in_order(place_);
}

}  // namespace etendue
