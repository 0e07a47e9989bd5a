// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "solver/transport/state/aligned_array.h"

namespace etendue {

/// Whether a sweep includes all sources: emission, the radiance of walls and the angular input.
enum class Emission { included, left_out };

/// Sizes of the parts of a state, in doubles. The band, padded to `stride`, is the fastest index everywhere.
struct StateLayout {
  std::size_t fluence = 0;     ///< [cell][node][stride]
  std::size_t moments = 0;     ///< [angular cell][moment][node][stride]; moment 0 repeats the fluence
  std::size_t radiance = 0;    ///< [ordinate][dense cell][node][stride] where scattering is by a matrix
  std::size_t irradiance = 0;  ///< [boundary face][face node][stride]
  std::size_t mirrors = 0;     ///< [mirror face][pair of ordinates][face node][stride] outflow
  std::size_t lagged = 0;      ///< [lagged face of all pairs][2 ordinates][face node][stride]

  std::size_t total() const { return fluence + moments + radiance + irradiance + mirrors + lagged; }
};

/// The unknowns x of the iteration (docs/theory/theory.md, section 7), which one sweep hands to the next: the
/// angular solution itself is kept only where scattering is by a matrix. One contiguous array, for linear
/// algebra.
class TransportState {
 public:
  explicit TransportState(const StateLayout& layout) : layout_(layout), values_(layout.total()) {}

  std::span<double> fluence() { return part(0, layout_.fluence); }
  std::span<double> moments() { return part(layout_.fluence, layout_.moments); }
  std::span<double> radiance() { return part(layout_.fluence + layout_.moments, layout_.radiance); }
  std::span<double> irradiance() {
    return part(layout_.fluence + layout_.moments + layout_.radiance, layout_.irradiance);
  }
  std::span<double> mirrors() {
    return part(layout_.total() - layout_.lagged - layout_.mirrors, layout_.mirrors);
  }
  std::span<double> lagged() { return part(layout_.total() - layout_.lagged, layout_.lagged); }
  std::span<const double> fluence() const { return const_cast<TransportState*>(this)->fluence(); }
  std::span<const double> moments() const { return const_cast<TransportState*>(this)->moments(); }
  std::span<const double> radiance() const { return const_cast<TransportState*>(this)->radiance(); }
  std::span<const double> irradiance() const { return const_cast<TransportState*>(this)->irradiance(); }
  std::span<const double> mirrors() const { return const_cast<TransportState*>(this)->mirrors(); }
  std::span<const double> lagged() const { return const_cast<TransportState*>(this)->lagged(); }
  std::span<double> values() { return values_.span(); }
  std::span<const double> values() const { return values_.span(); }
  const StateLayout& layout() const { return layout_; }

 private:
  std::span<double> part(std::size_t first, std::size_t size) { return values_.span().subspan(first, size); }

  StateLayout layout_;
  AlignedArray values_;
};

}  // namespace etendue
