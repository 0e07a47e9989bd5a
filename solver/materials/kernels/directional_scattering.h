// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/expression/expression.h"
#include "base/vec3.h"

namespace etendue {

// Media whose extinction or scattering depends on the directions themselves, not only on the angle between
// them. Each is for a density of 1; the medium's coefficients carry the density (docs/theory/scattering.md).

/// Distribution of the inclination of leaf normals (de Wit 1965): level, mostly level, at mid angles, mostly
/// upright, at both extremes, as the surface of a ball, at all inclinations alike, upright. Azimuths are all
/// alike.
enum class LeafAngles {
  horizontal,
  planophile,
  plagiophile,
  erectophile,
  extremophile,
  spherical,
  uniform,
  vertical
};
/// In the order of LeafAngles.
const std::vector<std::string>& leaf_angle_names();

/// A canopy of flat leaves (Ross 1981). The density is the leaf area in a volume [1/length], one side
/// counted. A leaf reflects and transmits like a Lambertian surface. z points up.
struct LeafCanopy {
  LeafAngles angles = LeafAngles::spherical;
  double reflectance = 0;
  double transmittance = 0;
  bool operator==(const LeafCanopy&) const = default;
};

/// Mirrors much smaller than a cell, distributed as the normals of an ellipsoid of revolution (SGGX, Heitz et
/// al. 2015). The density is that of their area times number [1/length].
struct MicroFlakes {
  Vec3 axis = Vec3::UnitZ();  ///< unit
  double along = 1;   ///< projected area seen along the axis: 1, and `across` < 1, for flakes that lie flat
  double across = 1;  ///< projected area seen across it: 1, and `along` < 1, for fibres
  double albedo = 0;  ///< part of the light that a flake reflects
  bool operator==(const MicroFlakes&) const = default;
};

/// A formula k(x, y, z, wx, wy, wz, vx, vy, vz) of the place and the directions before (w) and after (v)
/// [1/(length sr)]: a factor that depends on the place times one that depends on the directions.
struct KernelFormula {
  std::shared_ptr<const Expression> formula;
  Vec3 place = Vec3::Zero();  ///< where its direction-dependent factor is taken
  bool reciprocal = false;    ///< claimed: k(w -> v) = k(-v -> -w)
  /// [1/length] at that place: what is not scattered is absorbed. Without it the medium's absorption holds.
  std::optional<double> extinction = {};

  double at(const Vec3& before, const Vec3& after) const;
  bool operator==(const KernelFormula& other) const {
    return formula->text() == other.formula->text() && reciprocal == other.reciprocal &&
           place == other.place && extinction == other.extinction;
  }
};
/// The names of its variables, in order.
const std::vector<std::string>& kernel_variables();

/// A matrix for the ordinates of the case's own direction set, as it lists them [1/(length sr)].
struct KernelMatrix {
  int count = 0;
  std::vector<double> values;  ///< [from][into]
  bool reciprocal = false;
  std::optional<double> extinction = {};  ///< [1/length] as of a formula
  bool operator==(const KernelMatrix&) const = default;
};

/// What a medium has instead of a phase function.
using DirectionalScattering =
    std::variant<std::monostate, LeafCanopy, MicroFlakes, KernelFormula, KernelMatrix>;

std::string directional_name(const DirectionalScattering& scattering);

}  // namespace etendue
