// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/kernels/kernel_profile.h"

#include <cmath>
#include <numbers>

#include "solver/materials/kernels/kernel_formula.h"
#include "solver/materials/kernels/micro_flakes.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Of the mean over the azimuth: kernels of leaves are smooth but for kinks.
constexpr int profile_azimuths = 48;

double scattered_from(const LeafCanopy& leaves, const Vec3& before) {
  return (leaves.reflectance + leaves.transmittance) * leaf_projection(leaves.angles, before);
}
double scattered_from(const MicroFlakes& flakes, const Vec3& before) {
  return flakes.albedo * flake_projection(flakes, before);
}
double scattered_from(const KernelFormula& kernel, const Vec3& before) {
  return outgoing_moments(kernel, before).scattered;
}
double scattered_from(const KernelMatrix&, const Vec3&) { return 0; }
double scattered_from(const std::monostate&, const Vec3&) { return 0; }

}  // namespace

KernelProfile::KernelProfile(const DirectionalScattering& scattering, const Vec3& before)
    : scattering_(scattering),
      before_(before),
      scattered_(std::visit([&](const auto& matter) { return scattered_from(matter, before); }, scattering)) {
  if (const auto* leaves = std::get_if<LeafCanopy>(&scattering)) normals_ = leaf_normals(leaves->angles);
}

double KernelProfile::operator()(double cosine) const {
  const Vec3 side = before_.unitOrthogonal(), other = before_.cross(side);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const auto value = [&](const Vec3& after) {
    if (const auto* leaves = std::get_if<LeafCanopy>(&scattering_))
      return leaf_value(*leaves, normals_, before_, after);
    if (const auto* flakes = std::get_if<MicroFlakes>(&scattering_))
      return flake_value(*flakes, before_, after);
    return std::get<KernelFormula>(scattering_).at(before_, after);
  };
  double sum = 0;
  for (int j = 0; j < profile_azimuths; ++j) {
    const double azimuth = 2 * pi * (j + 0.5) / profile_azimuths;
    const Vec3 after = cosine * before_ + sine * (std::cos(azimuth) * side + std::sin(azimuth) * other);
    sum += value(after);
  }
  return sum / profile_azimuths / scattered_;
}

}  // namespace etendue
