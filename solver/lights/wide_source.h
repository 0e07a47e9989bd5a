// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <bitset>
#include <optional>
#include <span>

#include "solver/lights/emitter_tree.h"
#include "solver/lights/even_light.h"
#include "solver/lights/light_source.h"

namespace etendue {

/// Light that comes to a place from more than a few directions: what is left of it on its way is looked at
/// from the vertices of the mesh.
class WideSource : public LightSource {
 public:
  using LightSource::LightSource;

  const WideSource* as_wide() const override { return this; }
  /// What would arrive through matter of this extinction [band] and nothing opaque, by way of mirrors too,
  /// without the images behind this plane of a mirror. `beams` is room to work in.
  virtual void look_even(const Vec3& place, std::span<const double> extinction, std::optional<int> without,
                         LightBeams& beams, EvenLight& light) const = 0;
  /// Whether light through even matter is added up from many parts of it, emitting each in its own way: slow,
  /// and without steps.
  virtual bool is_in_parts() const { return false; }
  /// The triangles that all of it is made of, each even, if it is: few_triangles().
  virtual std::span<const EmitterPart> flat_parts() const { return {}; }
  /// The sides of its rim that a place lies on but for a distance.
  virtual std::bitset<32> rim_sides_at(const Vec3&, double) const { return {}; }
  /// Whether it fills so much of the sphere that the visible part of it is linear in cells.
  virtual bool is_soft() const { return false; }
};

}  // namespace etendue
