// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solver/problem/lights/light.h"
#include "solver/uncollided/sources/wide_source.h"

namespace etendue {

/// Light from all over a sky: beams, each for a part of it, which enter through the same walls,
/// with their images behind mirrors. Of the lights of a problem beams in a row that have one name are a sky.
class SkySource : public WideSource {
 public:
  SkySource(std::string name, std::vector<BeamLight> parts, const LightPaths& paths);

  void add_beams(const PointInCell& at, Sight sight, LightDetail detail, LightBeams& beams) const override;
  bool is_near(const Vec3&, double) const override { return false; }
  const SkySource* as_sky() const override { return this; }
  std::span<const BeamLight> parts() const { return parts_; }
  bool comes_in_by(int wall) const;
  /// Returns whether its parts have solid angles: then rays see it.
  bool shows_radiance() const { return !radiance_.empty(); }
  /// [band] Radiance that comes from where a unit vector points, that of the nearest part.
  std::span<const double> radiance(const Vec3& towards) const;

  /// Unit, in which it travels, images behind mirrors included, each once.
  std::span<const Vec3> directions() const { return directions_; }
  /// Where light of one of these directions comes in: the face, and the part that it is of.
  struct Entry {
    FaceIndex face;
    std::size_t part;
  };
  /// With the transmittance [band] of the path to a point, reflectances included; empty if none comes.
  std::optional<Entry> transmit(const PointInCell& at, std::size_t direction,
                                std::span<double> transmittance) const;
  /// Of the parts between which light of a direction changes where it is reflected once more, those that
  /// leave no trace of it, as bright ones and mirrors that reflect all of it, have the same number.
  std::size_t kind(std::size_t part) const { return kinds_[part]; }

 private:
  std::vector<BeamLight> parts_;
  std::vector<double> radiance_;  ///< [part][band] [power/(length^2 sr)]; empty where it is not known
  const LightPaths& paths_;
  std::vector<MirrorSet> images_;
  std::vector<Vec3> directions_;
  std::vector<std::vector<std::size_t>> from_;  ///< [direction] the parts it may be of
  std::vector<std::size_t> kinds_;              ///< [part] one that is like it
};

/// Returns whether a light is a part of the same sky as the one before it.
bool continues_sky(std::span<const Light> lights, std::size_t light);

}  // namespace etendue
