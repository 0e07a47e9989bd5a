// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/lights/light_beams.h"

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

  void clear() { values_.assign(values_.size(), 0); }
  void add(const NodalMoments& other) {
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] += other.values_[i];
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
};

}  // namespace etendue
