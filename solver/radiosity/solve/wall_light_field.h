// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solver/radiosity/exchange/exchange.h"
#include "solver/radiosity/extended/extended_paths.h"

namespace etendue {

/// The field at a point of the domain, per band.
struct WallLightValue {
  std::vector<double> fluence;     ///< [power/length^2]
  std::vector<Vec3> net_flux;      ///< [power/length^2]
  std::vector<double> irradiance;  ///< of the side that a normal points to; empty without one
};

/// Light of diffuse walls in a domain with a non-participating medium: at a point the sum over patches of
/// B/pi times their solid angle, its Lambert vector and its form factor, each times the part that is seen;
/// and the light by way of mirrors and glossy walls, along rays in all directions.
class WallLightField {
 public:
  /// `exitance` is what is diffuse, [patch][band]; the matrix must outlive it. `rays` look at a patch from a
  /// point.
  WallLightField(const Exchange& exchange, std::vector<double> exitance, std::size_t bands, int rays);

  /// So many rays from a point look at what mirrors and glossy walls show; the paths must outlive it.
  void look_along(const ExtendedPaths& paths, int rays) {
    paths_ = &paths;
    path_rays_ = rays;
  }

  WallLightValue at(const Vec3& point, const std::optional<Vec3>& normal = {}) const;
  /// [band] fluence and [3 (x, y, z)][band] net flux alone.
  void add_at(const Vec3& point, std::span<double> fluence, std::span<double> net_flux) const;

 private:
  const Exchange& exchange_;
  std::vector<double> exitance_;
  std::size_t bands_;
  template <class Add>
  void look(const Vec3& point, Add add) const;

  int rays_;
  const ExtendedPaths* paths_ = nullptr;  ///< none: nothing is redirected
  int path_rays_ = 0;
};

}  // namespace etendue
