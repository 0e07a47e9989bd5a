// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/extended/extended_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <typeinfo>

#include "solver/problem/mirror.h"

namespace etendue {
namespace {

// A path with less weight than this survives by Russian roulette.
constexpr double light_path = 0.05;
// Lobes of one model and the same shape are wide by the same, but for what a Fresnel factor changes.
constexpr double same_width = 0.1;

bool are_alike(const Reflectance& a, const Reflectance& b) {
  return &a == &b || (typeid(a) == typeid(b) &&
                      std::abs(a.width() - b.width()) <= same_width * std::max(a.width(), b.width()));
}

}  // namespace

double redirected_part(const Wall& wall, std::size_t band, double cosine, Redirection by) {
  const Reflectance* lobe = by == Redirection::mirrors_alone ? nullptr : wall.glossy_in(band);
  return mirrored_part(wall, band, cosine) + (lobe != nullptr ? lobe->albedo(cosine) : 0);
}

double redirected_part_of_isotropic(const Wall& wall, std::size_t band, Redirection by) {
  const Reflectance* lobe = by == Redirection::mirrors_alone ? nullptr : wall.glossy_in(band);
  return mirrored_part_of_isotropic(wall, band) + (lobe != nullptr ? lobe->albedo().mean() : 0);
}

bool redirects(const Wall& wall, Redirection by) {
  return is_mirror(wall) || (by == Redirection::mirrors_and_lobes && wall.is_glossy());
}

std::array<double, 3> PathNumbers::next() {
  if (!begun_) {
    begun_ = true;
    return next_;
  }
  std::uint32_t word[4];
  stream_.next(word);
  return {uniform(word[0]), uniform(word[1]), uniform(word[2])};
}

Vec3 direction_about(const Vec3& z, double cosine, double part_of_turn) {
  const Vec3 x = z.unitOrthogonal(), y = z.cross(x);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)),
               azimuth = 2 * std::numbers::pi * part_of_turn;
  return sine * std::cos(azimuth) * x + sine * std::sin(azimuth) * y + cosine * z;
}

ExtendedPaths::ExtendedPaths(const Problem& problem, const WallPatches& patches, Redirection by, int threads)
    : problem_(problem),
      patches_(patches),
      by_(by),
      bands_(static_cast<std::size_t>(problem.band_count())),
      scene_(triangles_of(patches.patches), threads) {
  for (const Wall& wall : problem.walls()) {
    redirects_.push_back(redirects(wall, by) ? 1 : 0);
    lobes_.push_back(lobes_of(wall, bands_));
  }
  for (std::size_t p = 0; p < patches.patches.size(); ++p)
    patch_of_.insert(patch_of_.end(), patches.patches[p].triangles().size(), p);
}

// Mirror or lobe is drawn in proportion to what they leave, on the mean over the bands.
bool ExtendedPaths::turn_on(std::size_t patch, PathNumbers& numbers, Vec3& towards,
                            std::vector<double>& weight) const {
  const auto number = static_cast<std::size_t>(patches_.walls[patch]);
  if (redirects_[number] == 0) return false;
  const Wall& wall = problem_.wall(patches_.walls[patch]);
  const Vec3& normal = patches_.patches[patch].normal();
  const double cosine = std::min(1.0, -towards.dot(normal));
  if (cosine <= 0) return false;
  double mirrored = 0, whole = 0, left = 0;  // the first two summed over the bands
  for (std::size_t b = 0; b < bands_; ++b) {
    const double part = weight[b] * redirected_part(wall, b, cosine, by_);
    mirrored += weight[b] * mirrored_part(wall, b, cosine);
    whole += part;
    left = std::max(left, part);
  }
  if (left <= 0) return false;
  const auto [lot, u, v] = numbers.next();
  const double by_mirror = mirrored / whole;
  // One number serves for both choices: its remainder is uniform again.
  const double stays = left < light_path ? left / light_path : 1;
  if (lot >= stays) return false;
  const double choice = lot / stays;
  if (choice < by_mirror) {
    towards = (towards + 2 * cosine * normal).normalized();
    for (std::size_t b = 0; b < bands_; ++b)
      weight[b] *= mirrored_part(wall, b, cosine) / (by_mirror * stays);
    return true;
  }
  for (double& one : weight) one /= (1 - by_mirror) * stays;
  return turn_by_lobe(number, normal, u, v, towards, weight);
}

ExtendedPaths::Lobes ExtendedPaths::lobes_of(const Wall& wall, std::size_t bands) {
  Lobes lobes{{}, std::vector<std::size_t>(bands, 0)};
  for (std::size_t b = 0; b < bands; ++b) {
    const Reflectance* lobe = wall.glossy_in(b);
    if (lobe == nullptr) continue;
    std::size_t& shape = lobes.shape[b];
    while (shape < lobes.drawn.size() && !are_alike(*lobes.drawn[shape], *lobe)) ++shape;
    if (shape == lobes.drawn.size()) lobes.drawn.push_back(lobe);
  }
  return lobes;
}

// Where lobes differ from band to band one of them is drawn, and the path is of its bands alone.
bool ExtendedPaths::turn_by_lobe(std::size_t wall, const Vec3& normal, double u, double v, Vec3& towards,
                                 std::vector<double>& weight) const {
  const Lobes& lobes = lobes_[wall];
  const auto count = static_cast<double>(lobes.drawn.size());
  const auto which = std::min(lobes.drawn.size() - 1, static_cast<std::size_t>(u * count));
  const Reflectance& drawn = *lobes.drawn[which];
  const Vec3 light = -towards;
  const ReflectedRay ray =
      drawn.sample(std::min(1.0, light.dot(normal)), u * count - static_cast<double>(which), v);
  if (ray.weight <= 0) return false;
  const Vec3 out = from_frame(ray.direction, light, normal);
  const double value = drawn.between(towards, out, normal);
  if (value <= 0) return false;
  for (std::size_t b = 0; b < bands_; ++b) {
    const Reflectance* lobe = problem_.wall(static_cast<int>(wall)).glossy_in(b);
    if (lobe == nullptr || lobes.shape[b] != which)
      weight[b] = 0;
    else
      weight[b] *= count * ray.weight * (lobe == &drawn ? 1 : lobe->between(towards, out, normal) / value);
  }
  towards = out;
  return std::ranges::any_of(weight, [](double w) { return w > 0; });
}

}  // namespace etendue
