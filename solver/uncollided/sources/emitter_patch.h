// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/uncollided/closed_form/emitter_tree.h"
#include "solver/uncollided/sources/light_source.h"
#include "solver/uncollided/sources/mirrored_emitter.h"

namespace etendue {

/// Point from which a light is sampled. Through mirrors the eye is moved behind them instead of the light,
/// but for those across which an emitter is mirrored: its images behind these are part of it.
struct LightView {
  MirrorSet mirrors;
  Vec3 eye;
  const MirroredEmitter* body;  ///< if there is one
};

/// Part of a light as seen from a point, sampled by a few points: a group of its parts, or directions in
/// which a triangle of it is met, or a volume is entered and left.
struct EmitterPatch {
  LightView view;
  int group = -1;  ///< of the tree; if it is none:
  const EmitterPart* part = nullptr;
  Wedge wedge = {};  ///< about the eye, with unit corners; a triangle is where it is entered
  TriangleRule rule = {};
  bool one_point = false;  ///< samples the group
};

/// A point of a light as the moved eye sees it.
struct LightPoint {
  Vec3 looking;     ///< unit
  double distance;  ///< to where the light begins [length]
  double length;    ///< of the path through a volume behind [length]
  double weight;    ///< times the brightness, and the attenuated length of the volume: fluence
};

/// Rays from the points of an extended light, with the transmittance and fluence of each.
struct VisibleRaySamples {
  explicit VisibleRaySamples(std::size_t bands) : clear(bands) {}
  /// Appends rays of others, from the first to before the last.
  void append(const VisibleRaySamples& other, std::size_t first, std::size_t last);
  bool is_open(std::size_t beam) const { return passed[beam * clear.bands()] >= 0; }

  LightBeams clear;  ///< as in empty space, mirrors included
  /// [beam][band] Transmittance of the path up to the light; below zero where the path is blocked.
  std::vector<double> passed;
  std::vector<double> arriving;  ///< [beam][band] fluence [power/length^2]
};

}  // namespace etendue
