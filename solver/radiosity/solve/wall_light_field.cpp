// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/solve/wall_light_field.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/random/even_points.h"

namespace etendue {
namespace {

using std::numbers::pi;

struct PatchView {
  double solid_angle = 0;
  Vec3 vector = Vec3::Zero();
};

PatchView view_of(const Vec3& point, const FlatPatch& patch) {
  PatchView view;
  for (const TriangleCorners& t : patch.triangles()) {
    view.solid_angle += solid_angle(point, t);
    view.vector += lambert_vector(point, t);
  }
  return view;
}

/// Of the radius of a patch: points nearer to its plane lie on it, up to rounding.
constexpr double on_plane = 1e-9;
/// The same: seen from points nearer than this, a patch fills half of all directions to this part of them, or
/// none where the point lies beside it.
constexpr double close_to_plane = 1e-4;

/// From where a point sees the front of a patch.
struct Outlook {
  Vec3 point;
  bool is_close;
};

/// None behind the patch. A point on it has its light from half of all directions, as one just in front.
std::optional<Outlook> outlook(const Vec3& point, const FlatPatch& patch) {
  const double distance = patch.normal().dot(point - patch.centroid()), least = on_plane * patch.radius();
  if (distance < -least) return {};
  if (distance > least) return Outlook{point, distance < close_to_plane * patch.radius()};
  return Outlook{point + (least - distance) * patch.normal(), true};
}

}  // namespace

WallLightField::WallLightField(const Exchange& exchange, std::vector<double> exitance, std::size_t bands,
                               int rays)
    : exchange_(exchange), exitance_(std::move(exitance)), bands_(bands), rays_(rays) {}

/// Calls add(direction to look into, band, radiance times its part of the sphere [power/length^2]) for what
/// comes after a first wall.
template <class Add>
void WallLightField::look(const Vec3& point, Add add) const {
  if (paths_ == nullptr) return;
  // Each point looks into other directions, so that neighbours do not err alike.
  std::uint64_t place = 0;
  for (int axis = 0; axis < 3; ++axis)
    place = place * 0x9E3779B97F4A7C15ULL + std::bit_cast<std::uint64_t>(point[axis]);
  EvenPoints<5> points(place, RandomUse::path_start);
  std::vector<double> weight;
  const double part = 4 * pi / path_rays_;
  for (int i = 0; i < path_rays_; ++i) {
    const std::array<double, 5>& at = points.next();
    const Vec3 towards = direction_about(Vec3::UnitZ(), 2 * at[0] - 1, at[1]);
    const PathNumbers numbers(place + static_cast<std::uint64_t>(i), {at[2], at[3], at[4]});
    paths_->follow(point, towards, numbers, weight, [&](const ExtendedPaths::Meeting& meeting) {
      if (meeting.first) return;
      for (std::size_t b = 0; b < bands_; ++b)
        add(towards, b, part * meeting.weight[b] * exitance_[meeting.patch * bands_ + b] / pi);
    });
  }
}

void WallLightField::add_at(const Vec3& point, std::span<double> fluence, std::span<double> net_flux) const {
  for (std::size_t p = 0; p < exchange_.size(); ++p) {
    const FlatPatch& patch = exchange_.patches()[p];
    // Only fronts shine.
    const std::optional<Outlook> from = outlook(point, patch);
    if (!from) continue;
    const double* exitance = exitance_.data() + p * bands_;
    if (std::all_of(exitance, exitance + bands_, [](double e) { return e == 0; })) continue;
    // Rays cannot tell a point so close from one behind the patch.
    const double share = from->is_close ? 1 : exchange_.visibility().share_from(from->point, p, rays_);
    if (share == 0) continue;
    const PatchView view = view_of(from->point, patch);
    for (std::size_t b = 0; b < bands_; ++b) {
      const double radiance = share * exitance[b] / pi;
      fluence[b] += radiance * view.solid_angle;
      for (std::size_t x = 0; x < 3; ++x)
        net_flux[x * bands_ + b] -= radiance * view.vector[static_cast<Eigen::Index>(x)];
    }
  }
  look(point, [&](const Vec3& towards, std::size_t b, double light) {
    fluence[b] += light;
    for (std::size_t x = 0; x < 3; ++x)
      net_flux[x * bands_ + b] -= light * towards[static_cast<Eigen::Index>(x)];
  });
}

WallLightValue WallLightField::at(const Vec3& point, const std::optional<Vec3>& normal) const {
  WallLightValue value{std::vector<double>(bands_, 0), std::vector<Vec3>(bands_, Vec3::Zero()), {}};
  std::vector<double> net_flux(3 * bands_, 0);
  add_at(point, value.fluence, net_flux);
  for (std::size_t b = 0; b < bands_; ++b)
    value.net_flux[b] = {net_flux[b], net_flux[bands_ + b], net_flux[2 * bands_ + b]};
  if (!normal) return value;
  value.irradiance.assign(bands_, 0);
  for (std::size_t p = 0; p < exchange_.size(); ++p) {
    double factor = 0;
    for (const TriangleCorners& t : exchange_.patches()[p].triangles())
      factor += point_factor(point, *normal, t);
    if (factor > 0) factor *= exchange_.visibility().share_from(point, p, rays_);
    for (std::size_t b = 0; b < bands_; ++b) value.irradiance[b] += factor * exitance_[p * bands_ + b];
  }
  look(point, [&](const Vec3& towards, std::size_t b, double light) {
    value.irradiance[b] += std::max(0.0, towards.dot(*normal)) * light;
  });
  return value;
}

}  // namespace etendue
