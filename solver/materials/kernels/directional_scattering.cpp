// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/kernels/directional_scattering.h"

#include <fmt/format.h>

#include <array>

namespace etendue {
const std::vector<std::string>& leaf_angle_names() {
  static const std::vector<std::string> names = {"horizontal",   "planophile", "plagiophile", "erectophile",
                                                 "extremophile", "spherical",  "uniform",     "vertical"};
  return names;
}

const std::vector<std::string>& kernel_variables() {
  static const std::vector<std::string> names = {"x", "y", "z", "wx", "wy", "wz", "vx", "vy", "vz"};
  return names;
}

double KernelFormula::at(const Vec3& before, const Vec3& after) const {
  const std::array<double, 9> values = {place.x(),  place.y(), place.z(), before.x(), before.y(),
                                        before.z(), after.x(), after.y(), after.z()};
  return (*formula)(values);
}

std::string directional_name(const DirectionalScattering& scattering) {
  if (const auto* leaves = std::get_if<LeafCanopy>(&scattering))
    return fmt::format("{} leaves, reflectance {}, transmittance {}",
                       leaf_angle_names()[static_cast<std::size_t>(leaves->angles)], leaves->reflectance,
                       leaves->transmittance);
  if (const auto* flakes = std::get_if<MicroFlakes>(&scattering))
    return fmt::format("micro-flakes, projected areas {} along and {} across, albedo {}", flakes->along,
                       flakes->across, flakes->albedo);
  if (const auto* kernel = std::get_if<KernelFormula>(&scattering))
    return "kernel " + kernel->formula->text();
  if (const auto* matrix = std::get_if<KernelMatrix>(&scattering))
    return fmt::format("kernel matrix for {} directions", matrix->count);
  return "";
}

}  // namespace etendue
