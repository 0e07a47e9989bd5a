// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/observe/camera/picture.h"
#include "solver/observe/radiance/wall_light.h"

namespace etendue {

/// The walls as a surface with vertices of its own for each plane, so that what is baked into them is
/// continuous in a plane and jumps at edges.
struct WallSurface {
  struct Vertex {
    Vec3 position;
    Vec3 normal;        ///< unit, into the domain
    WallCorner corner;  ///< one of the corners at this vertex
  };
  std::vector<Vertex> vertices;
  /// [boundary face], counterclockwise seen from inside of the domain
  std::vector<std::array<std::int32_t, 3>> triangles;
};

WallSurface wall_surface(const TetrahedralMesh& mesh);

/// A place on a wall where a number is baked.
struct BakePlace {
  FaceIndex face;
  std::array<double, 3> weights;  ///< of the face's vertices; their sum is 1
  Vec3 position;                  ///< where lights are sampled
};

/// The vertices of a surface. Lights are sampled 2 % of the way to the middle of a face: at an edge of the
/// room it would not be known on which side.
std::vector<BakePlace> vertex_places(const WallSurface& surface, const TetrahedralMesh& mesh);

/// Irradiance [place][band]: of the lights exact there (LightIrradiance), else as `brought` has it. Empty
/// where the observer stopped it.
std::vector<double> bake_irradiance(const std::vector<BakePlace>& places, const LightSetup& lights,
                                    const WallIrradiance& brought, int threads,
                                    const StageObserver& observer = {});

/// What the wall sends back and emits, per area, [place][band] [power/length^2]: (diffuse) E + pi L.
std::vector<double> bake_radiosity(const std::vector<BakePlace>& places, const Problem& problem,
                                   const std::vector<double>& irradiance);

/// Visibility of a uniform sky [place], weighted by the cosine: 1 less the ambient occlusion. The walls in
/// `sky` shine, all others are black, and nothing is between them. Empty where the observer stopped it.
std::vector<double> bake_sky_visibility(const std::vector<BakePlace>& places, const TetrahedralMesh& mesh,
                                        const std::vector<int>& sky, int threads,
                                        const StageObserver& observer = {});

}  // namespace etendue
