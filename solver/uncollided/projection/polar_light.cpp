// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/uncollided/closed_form/solid_angle.h"
#include "solver/uncollided/closed_form/triangle.h"
#include "solver/uncollided/projection/arriving_light.h"
#include "solver/uncollided/projection/cell_light.h"
#include "solver/uncollided/projection/ray_segment.h"

namespace etendue {
namespace {

/// Chords of the unit sphere up to which a rule of degree 5 sees a wedge of an empty cell to about 1e-6.
constexpr double largest_wedge_side = 0.35;
/// Ratio and difference in optical depth of the paths to where the edges of a part come in and go out, and
/// the factor between the light along its rays, up to which the rule sees as much of it.
constexpr double even_wedge_ratio = 1.5, even_wedge_depth = 0.7, even_wedge_factor = 2;
/// Of what would arrive in empty space; it may vary as it likes.
constexpr double negligible_arrival = 1e-13;
constexpr int most_wedge_cuts = 8, most_wedge_cuts_in_shadow = 3;
/// Part of the distance from a corner to the middle of a cell.
constexpr double inside_corner = 1e-3;

/// The light of a point, or of its image behind mirrors, in the wedges of a cell.
class PointInWedges {
 public:
  PointInWedges(const LightPaths& paths, const PointSource& source, const PointSource::Image& image,
                const LitCell& cell, bool parted, NodalMoments& moments)
      : paths_(paths),
        source_(source),
        image_(image),
        cell_(cell),
        extinction_(cell.thickness / cell.size),
        gradients_(shape_gradients(cell)),
        parted_(parted),
        moments_(moments),
        transmittance_(paths.bands()),
        trifle_(paths.bands(), negligible_arrival) {}

  /// Returns whether no more than a trifle of the light is left at the corners and in the middle of the cell.
  bool is_dark() {
    transmittance_.clear();
    std::array<Vec3, 5> places{cell_.centroid};
    // Rays from a corner itself run along faces and edges.
    for (std::size_t i = 0; i < 4; ++i)
      places[i + 1] = cell_.corners[i] + inside_corner * (cell_.centroid - cell_.corners[i]);
    for (const Vec3& place : places) {
      const Vec3 separation = place - image_.position;
      const double length = separation.norm();
      const std::span<double> transmittance = transmittance_.add();
      std::ranges::fill(transmittance, 1.0);
      // Where something opaque is in between others may see the light.
      if (!paths_.transmit({cell_.index, place}, -separation / length, length, image_.mirrors, transmittance))
        return false;
    }
    return transmittance_.is_trifle(trifle_);
  }

  void add(const Wedge& wedge, const SphericalTriangle& part, int cuts = 0) {
    check_solid_angle_cuts(cuts);
    if (longest_side(part) > largest_wedge_side || (cuts < most_wedge_cuts && !is_alike(wedge, part)))
      return add_quarters(wedge, part, cuts + 1);
    points_.clear();
    append_points(part, 2, TriangleRule::seven_points, points_);
    transmittance_.clear();
    for (const SolidAnglePoint& point : points_) look(wedge, point.direction, transmittance_.add());
    if (cuts < most_wedge_cuts && !transmittance_.is_even(even_wedge_factor, trifle_))
      return add_quarters(wedge, part, cuts + 1);
    const std::size_t lit = transmittance_.lit();
    if (!parted_ && lit > 0 && lit < points_.size() && cuts < most_wedge_cuts_in_shadow)
      return add_quarters(wedge, part, cuts + 1);
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (!transmittance_.is_dark(i)) add_ray(wedge, points_[i], transmittance_.at(i));
  }

 private:
  void add_quarters(const Wedge& wedge, const SphericalTriangle& part, int cuts) {
    for (const SphericalTriangle& quarter : quarters(part)) add(wedge, quarter, cuts);
  }

  bool is_alike(const Wedge& wedge, const SphericalTriangle& part) const {
    std::array<double, 3> in{}, out{};
    for (std::size_t i = 0; i < 3; ++i) {
      in[i] = wedge.distance_in(part[i]);
      out[i] = wedge.distance_out(part[i]);
    }
    const auto differ = [&](const std::array<double, 3>& lengths) {
      const auto [least, most] = std::ranges::minmax(lengths);
      return most > even_wedge_ratio * least || extinction_ * (most - least) > even_wedge_depth;
    };
    return !differ(in) && !differ(out);
  }

  /// Leaves zero where something is in between.
  void look(const Wedge& wedge, const Vec3& direction, std::span<double> transmittance) const {
    const double in = wedge.distance_in(direction);
    std::ranges::fill(transmittance, 1.0);
    if (in > 0 && !paths_.transmit({cell_.index, image_.position + in * direction}, -direction, in,
                                   image_.mirrors, transmittance))
      std::ranges::fill(transmittance, 0.0);
  }
  void add_ray(const Wedge& wedge, const SolidAnglePoint& point, std::span<double> power) {
    const double intensity = source_.intensity(image_, point.direction) * point.weight;
    if (intensity == 0) return;
    for (std::size_t b = 0; b < power.size(); ++b) power[b] *= source_.power()[b] * intensity;
    const double in = wedge.distance_in(point.direction), out = wedge.distance_out(point.direction);
    const Vec3 entry = image_.position + in * point.direction;
    add_segment(paths_.matter(), cell_, segment_through(cell_, gradients_, entry, point.direction, out - in),
                power, moments_);
  }

  const LightPaths& paths_;
  const PointSource& source_;
  const PointSource::Image& image_;
  const LitCell& cell_;
  double extinction_;
  std::array<Vec3, 4> gradients_;
  bool parted_;  ///< along all edges of shadows
  NodalMoments& moments_;
  std::vector<SolidAnglePoint> points_;
  ArrivingLight transmittance_;  ///< to the cell
  std::vector<double> trifle_;   ///< [band]
};

}  // namespace

void add_in_polar_frame(const LightPaths& paths, const PointSource& source, const ShadowPlanes& shadows,
                        const LitCell& cell, NodalMoments& moments) {
  std::vector<ShadowPlane> planes;
  for (std::size_t i = 0; i < source.images().size(); ++i) {
    const PointSource::Image& image = source.images()[i];
    const bool parted = shadows.find(i, cell.corners, planes);
    std::array<Vec3, 4> corners = cell.corners;
    for (Vec3& corner : corners) corner -= image.position;
    PointInWedges light(paths, source, image, cell, parted, moments);
    if (light.is_dark()) continue;
    for (const Wedge& wedge : wedges_of(corners))
      for (const SphericalTriangle& part : cut_by_planes(wedge.directions, planes))
        if (const auto unit = on_sphere(part)) light.add(wedge, *unit);
  }
}

}  // namespace etendue
