// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "solver/uncollided/closed_form/emitter_tree.h"

namespace etendue {

/// Triangles in one plane with the same radiance from the same side: a surface of uniform emission.
struct UniformEmitter {
  Vec3 normal;                   ///< unit, to the side that shines
  double offset;                 ///< normal . x in the plane
  std::vector<double> radiance;  ///< [band] [power/(length^2 sr)]
  std::vector<std::array<Vec3, 3>> triangles;
};

/// Returns the uniform emitters that a light's triangles form; nothing where they are more than `most`.
std::optional<std::vector<UniformEmitter>> uniform_emitters(std::span<const EmitterPart> triangles,
                                                            std::size_t most);

/// Returns whether a triangle shines towards an eye; not where that lies in its plane but for rounding.
bool shines_to(const EmitterPart& triangle, const Vec3& eye);

/// The same light in as few triangles as the outlines of its emitters need, where these are convex and flat
/// but for rounding: faces of a mesh are far more.
std::vector<EmitterPart> few_triangles(std::span<const EmitterPart> triangles);

}  // namespace etendue
