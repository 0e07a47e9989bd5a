// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "solver/uncollided/moments/directional_moments.h"
#include "solver/uncollided/rays/light_beams.h"

namespace etendue {

/// Integrals of a fluence and its net flux against the four linear functions of a cell (three of a face),
/// and the nodal values of their projection on these.
class NodalMoments {
 public:
  /// `components`: 4 for fluence and net flux, with `absorbed` and `collided` 6; 1 for an irradiance.
  NodalMoments(std::size_t nodes, std::size_t components, std::size_t bands)
      : nodes_(nodes), components_(components), bands_(bands), values_(nodes * components * bands, 0) {}

  /// Components beside fluence and net flux: power densities of light that is absorbed and that scatters.
  static constexpr std::size_t absorbed = 4, collided = 5;
  std::size_t components() const { return components_; }

  /// What scatters by the direction of the light; null where nobody asks.
  DirectionalMoments* by_direction() { return by_direction_ ? &*by_direction_ : nullptr; }
  const DirectionalMoments* by_direction() const { return by_direction_ ? &*by_direction_ : nullptr; }
  void keep_directions(const IncidentDirections& directions, AngularDetail detail) {
    by_direction_.emplace(directions, bands_);
    by_direction_->set_detail(detail);
  }
  void leave_out_directions() { by_direction_.reset(); }

  void clear() {
    values_.assign(values_.size(), 0);
    if (by_direction_) by_direction_->clear();
  }
  void add(const NodalMoments& other) {
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] += other.values_[i];
    if (by_direction_ && other.by_direction_) by_direction_->add(*other.by_direction_);
  }
  /// Adds to what scatters by direction, where that is asked for.
  void add_scattered(const Vec3& direction, std::span<const double> shape, std::size_t band, double power) {
    if (by_direction_) by_direction_->add(direction, shape, band, power);
  }
  double& at(std::size_t node, std::size_t component, std::size_t band) {
    return values_[(node * components_ + component) * bands_ + band];
  }
  double at(std::size_t node, std::size_t component, std::size_t band) const {
    return values_[(node * components_ + component) * bands_ + band];
  }
  /// Adds fluence and net flux of light at a point: `shape` are the values of the functions, `measure` is the
  /// point's part of the volume.
  void add(std::span<const double> shape, double measure, const Vec3& direction,
           std::span<const double> fluence);
  /// Adds one component in one band.
  void add(std::span<const double> shape, double measure, std::size_t band, double value,
           std::size_t component = 0) {
    for (std::size_t i = 0; i < nodes_; ++i) at(i, component, band) += measure * shape[i] * value;
  }

  /// The first components' integrals, summed over the bands, and how much those of another differ.
  double size() const;
  double difference(const NodalMoments& other) const;
  /// The nodal value of the projection: the mass matrix of a simplex with n corners is
  /// |K| / (n (n + 1)) (1 + delta_ij), so u_i = n / |K| ((n + 1) b_i - sum of b).
  double nodal(std::size_t node, std::size_t component, std::size_t band, double measure) const;
  /// The integral: the functions sum to 1.
  double integral(std::size_t component, std::size_t band) const;

 private:
  std::size_t nodes_, components_, bands_;
  std::vector<double> values_;  ///< [node][component][band]
  std::optional<DirectionalMoments> by_direction_;
};

}  // namespace etendue
