// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "solver/uncollided/closed_form/emitter_tree.h"
#include "solver/uncollided/sources/light_source.h"

namespace etendue {

class ExtendedSource;
class SkySource;

/// Light that comes to a place from more than a few directions.
class WideSource : public LightSource {
 public:
  using LightSource::LightSource;

  const WideSource* as_wide() const override { return this; }
  /// The light as one with an area or a volume, or as a sky: it is one of both.
  virtual const ExtendedSource* as_extended() const { return nullptr; }
  virtual const SkySource* as_sky() const { return nullptr; }
  /// The triangles that all of it is made of, each even, if it is: few_triangles().
  virtual std::span<const EmitterPart> flat_parts() const { return {}; }
};

}  // namespace etendue
