// SPDX-License-Identifier: AGPL-3.0-or-later
#include <type_traits>

#include "solver/problem/band_selection.h"
#include "solver/problem/problem.h"

namespace etendue {
namespace {

/// The parts of a problem with the bands that are wanted.
class Selection {
 public:
  Selection(std::size_t count, std::span<const int> bands) : count_(count), bands_(bands) {}

  /// Lists by band; empty ones say the same of all bands.
  template <class... Lists>
  void cut(Lists&... lists) const {
    ((lists = select_bands(std::span<const typename Lists::value_type>(lists), count_, bands_)), ...);
  }

  void cut(Medium& medium) const {
    cut(medium.absorption, medium.scattering, medium.emission, medium.phase, medium.choice,
        medium.directional, medium.absorption_by_direction, medium.emission_by_direction, medium.blackbody,
        medium.reradiation);
  }
  void cut(Wall& wall) const {
    cut(wall.radiance, wall.diffuse, wall.specular, wall.radiance_by_direction, wall.glossy,
        wall.transmittance, wall.reradiation);
  }
  void cut(PointLight& light) const { cut(light.power); }
  void cut(BeamLight& light) const { cut(light.irradiance); }
  void cut(SurfaceLight& light) const { cut(light.radiance); }

 private:
  std::size_t count_;
  std::span<const int> bands_;
};

Bands cut_bands(const Bands& bands, std::span<const int> wanted) {
  Bands result{{}, {}};
  // Edges hold between neighbours alone.
  for (const int band : wanted) result.names.push_back(bands.names[static_cast<std::size_t>(band)]);
  return result;
}

}  // namespace

Problem Problem::of_bands(std::span<const int> bands) const {
  const Selection selection(bands_.names.size(), bands);
  Problem result = *this;
  result.bands_ = cut_bands(bands_, bands);
  for (Medium& medium : result.media_) selection.cut(medium);
  for (Wall& wall : result.walls_) selection.cut(wall);
  for (Light& light : result.lights_) std::visit([&](auto& kind) { selection.cut(kind); }, light.kind);
  selection.cut(result.absorption_, result.scattering_);
  result.emission_ = emission_.of_bands(bands);
  result.own_emission_ = own_emission_.of_bands(bands);
  result.following_.cells = following_.cells.of_bands(bands);
  selection.cut(result.following_.radiance);
  return result;
}

}  // namespace etendue
