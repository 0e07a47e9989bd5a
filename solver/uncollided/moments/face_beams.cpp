// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/moments/face_beams.h"

#include <algorithm>

#include "base/clipped_polygon.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/uncollided/sources/beam_source.h"
#include "solver/uncollided/sources/point_source.h"

namespace etendue {
namespace {

/// Part of the distance to the centroid from which a corner is sampled: obstacles on its edges do not
/// occlude it.
constexpr double step_inside = 1e-3;

/// Adds the mean irradiance of a face by a beam with a cross-section, which may lie between its corners.
void add_mean_irradiance(const BeamSource& beam, const TetrahedralMesh& mesh, FaceIndex face,
                         LightBeams& arriving) {
  const std::array<Vec3, 3> corners = corners_of(mesh, face);
  std::vector<double> fluence(arriving.bands());
  for (std::size_t image = 0; image < beam.directions().size(); ++image) {
    const Vec3& direction = beam.directions()[image];
    const double cosine = direction.dot(mesh.area_normal(face)) / mesh.area(face);
    if (cosine <= 0) continue;
    std::vector<double> sum(arriving.bands(), 0);
    for (const std::array<Vec3, 3>& lit : beam.lit_parts(image, corners)) {
      if (!beam.arrives({mesh.owner(face), (lit[0] + lit[1] + lit[2]) / 3}, direction, fluence)) continue;
      const double part = cosine * triangle_area(lit) / mesh.area(face);
      for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += part * fluence[b];
    }
    if (std::ranges::any_of(sum, [](double value) { return value > 0; }))
      std::ranges::copy(sum, arriving.add(direction).begin());
  }
}

/// Largest number of times that a face is cut in four where no corner shows a source: of a spot, whose cone
/// may end between the corners, and where obstacles may leave light between them.
constexpr int deepest_for_spots = 5, deepest_behind_obstacles = 2;
/// Beams with which the mean is good enough for the directions of what a lobe reflects.
constexpr std::size_t enough_between_corners = 8;

using Triangle = std::array<Vec3, 3>;

std::vector<Triangle> quartered(const std::vector<Triangle>& triangles) {
  std::vector<Triangle> parts;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
    parts.insert(parts.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return parts;
}

void add_all(const LightBeams& from, double factor, LightBeams& to) {
  for (std::size_t k = 0; k < from.size(); ++k) {
    const std::span<double> values = to.add(from.direction(k));
    for (std::size_t b = 0; b < values.size(); ++b) values[b] = factor * from.fluence(k)[b];
  }
}

/// Finds the beams that arrive on the outer side of one face.
class FaceBeams {
 public:
  FaceBeams(const LightPaths& paths, FaceIndex face)
      : mesh_(paths.problem().mesh()),
        face_(face),
        normal_(mesh_.area_normal(face).normalized()),
        corners_(corners_of(mesh_, face)),
        scratch_(paths.bands()) {}

  /// At the corners.
  std::array<LightBeams, 3> find(const LightSources& sources) {
    const LightBeams dark(scratch_.bands());
    std::array<LightBeams, 3> beams = {dark, dark, dark};
    for (const auto& source : sources) add(*source, beams);
    std::array<bool, 3> is_dark{};
    LightBeams lit = dark;
    for (std::size_t i = 0; i < 3; ++i) {
      is_dark[i] = beams[i].size() == 0;
      add_all(beams[i], 1.0 / 3, lit);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_dark[i]) continue;
      for (const auto& source : sources)
        if (!has_profile(*source)) add_irradiance(*source, corners_[i], Sight::clear, beams[i]);
      // The face may be lit although nothing shines on this corner, as at the rim of a spot.
      if (beams[i].size() == 0) beams[i] = lit;
    }
    return beams;
  }

 private:
  static bool has_profile(const LightSource& source) {
    return source.as_beam() != nullptr && source.as_beam()->has_profile();
  }

  void add(const LightSource& source, std::array<LightBeams, 3>& beams) {
    LightBeams mean(scratch_.bands());
    if (has_profile(source)) {
      add_mean_irradiance(*source.as_beam(), mesh_, face_, mean);
    } else {
      bool is_seen = false;
      for (std::size_t i = 0; i < 3; ++i)
        is_seen = add_irradiance(source, corners_[i], Sight::attenuated, beams[i]) || is_seen;
      if (!is_seen) add_between_corners(source, mean);
    }
    for (LightBeams& corner : beams) add_all(mean, 1, corner);
  }

  /// Adds the mean irradiance over parts of the face that are small enough for several of them to be lit.
  void add_between_corners(const LightSource& source, LightBeams& mean) {
    if (is_behind(source)) return;
    LightBeams found(scratch_.bands());
    const bool is_hidden = std::ranges::any_of(
        corners_, [&](const Vec3& corner) { return add_irradiance(source, corner, Sight::clear, found); });
    const int deepest =
        source.as_point() != nullptr && !is_hidden ? deepest_for_spots : deepest_behind_obstacles;
    std::vector<Triangle> parts = {corners_};
    found.clear();
    for (int level = 0; level < deepest && found.size() < enough_between_corners; ++level) {
      parts = quartered(parts);
      found.clear();
      for (const auto& [a, b, c] : parts) add_where_visible(source, (a + b + c) / 3, found);
    }
    add_all(found, 1 / static_cast<double>(parts.size()), mean);
  }

  /// Returns whether a point and all its images can only shine on the back of the face.
  bool is_behind(const LightSource& source) const {
    return source.as_point() != nullptr &&
           std::ranges::all_of(source.as_point()->images(), [&](const PointSource::Image& image) {
             return normal_.dot(corners_[0] - image.position) <= 0;
           });
  }

  /// Rays are walked only where there is light without obstacles.
  void add_where_visible(const LightSource& source, const Vec3& point, LightBeams& beams) {
    LightBeams clear(scratch_.bands());
    if (add_irradiance(source, point, Sight::clear, clear))
      add_irradiance(source, point, Sight::attenuated, beams);
  }

  /// Adds the irradiance at a point of the face. Returns whether there is some.
  bool add_irradiance(const LightSource& source, const Vec3& point, Sight sight, LightBeams& arriving) {
    const Vec3 inside = point + step_inside * (mesh_.centroid(face_) - point);
    scratch_.clear();
    source.add_beams({mesh_.owner(face_), inside}, sight, coarse_light, scratch_);
    bool is_lit = false;
    for (std::size_t k = 0; k < scratch_.size(); ++k) {
      const double cosine = scratch_.direction(k).dot(normal_);
      const auto fluence = scratch_.fluence(k);
      if (cosine <= 0 || std::ranges::none_of(fluence, [](double value) { return value > 0; })) continue;
      is_lit = true;
      const std::span<double> irradiance = arriving.add(scratch_.direction(k));
      for (std::size_t b = 0; b < irradiance.size(); ++b) irradiance[b] = cosine * fluence[b];
    }
    return is_lit;
  }

  const TetrahedralMesh& mesh_;
  FaceIndex face_;
  Vec3 normal_;
  std::array<Vec3, 3> corners_;
  LightBeams scratch_;
};

}  // namespace

std::array<LightBeams, 3> beams_at_corners(const LightPaths& paths, FaceIndex face,
                                           const LightSources& sources) {
  return FaceBeams(paths, face).find(sources);
}

}  // namespace etendue
