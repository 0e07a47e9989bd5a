// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace etendue {

class DirectionalMedium;
class FormulaEmitter;
class PhaseSampler;
class RandomStream;
class Reflectance;

/// Draws a cosine of deflection (PhaseSampler::cosine), for code that must not include it.
double sampled_cosine(const PhaseSampler& sampler, double u);
/// What a glossy wall reflects in all directions of light at this cosine of incidence.
double glossy_albedo(const Reflectance& glossy, double cos_in);
/// The part of light that a smooth surface mirrors which it meets at this cosine (fresnel_reflectance).
double part_mirrored(double cos_in, double refractive_index);
/// Turns the direction of travel w at a wall with the unit normal n, which points into the domain. Gives f_r
/// cos / density; 0 where the light does not leave the wall.
double reflect_glossily(const Reflectance& glossy, const double (&n)[3], double u, double v, double (&w)[3]);

/// What a medium that depends on the direction does to light that travels along `sense` × w, a unit vector
/// [1/length].
struct DirectedCoefficients {
  double absorption, scattering;
};
DirectedCoefficients coefficients_along(const DirectionalMedium& medium, std::int32_t cell,
                                        const double (&w)[3], double sense);
/// Turns w to where such a medium scatters it in a cell, which has a sampler.
void scatter_by_direction(const DirectionalMedium& medium, std::int32_t cell, RandomStream& stream,
                          double (&w)[3]);

/// The emission of a cell by a formula in the direction -w, times the moments of its barycentric coordinates
/// on the path of a history that goes back along the light; and the radiance of a wall's face, where the
/// shares of its corners are those of a point.
double emission_along(const FormulaEmitter& emitter, std::int32_t cell, const double (&w)[3],
                      const double (&moments)[4]);
double radiance_along(const FormulaEmitter& emitter, std::int32_t face, const double (&w)[3],
                      const double (&shares)[3]);

/// A cell as photons see it, in one band. The barycentric coordinate of vertex i at x is
/// gx[i] x + gy[i] y + gz[i] z + offset[i]; it vanishes on face i and is positive inside.
struct alignas(64) PhotonCell {
  double gx[4], gy[4], gz[4];  ///< gradient [1/length]
  double offset[4];
  std::int32_t across[4];  ///< behind face i: 4 × cell + its face, or -1 - boundary face
  double scattering;       ///< [1/length]
  double free_path;        ///< its inverse [length]; huge where nothing scatters
  double absorption;       ///< [1/length]
  double emission;         ///< mean [power/(length^3 sr)]
  std::int32_t deflection;
  float slope[3];  ///< emission at vertices 1 to 3 less its mean; all four sum to 0
};
static_assert(sizeof(PhotonCell) == 192);

/// A boundary face, in one band.
struct alignas(64) PhotonFace {
  double normal[3];   ///< unit, into the domain
  double tangent[3];  ///< unit; in the plane it lies in the plane too
  double diffuse, specular;
  double transmittance;        ///< to the other side of a sheet
  const Reflectance* glossy;   ///< null: none
  const FormulaEmitter* sent;  ///< beside the radiance; null: nothing
  double radiance;             ///< [power/(length^2 sr)]
  double refractive_index;     ///< of the domain over that behind; 1: the wall does not refract
  std::int32_t corner[3];      ///< places of its vertices among those of its cell
  std::int32_t cell, local;    ///< the face is face `local` of this cell
  std::int32_t behind;         ///< boundary face on the other side of a sheet, -1: none
};

/// How light turns in a medium. Where that depends on its direction the medium draws it, and coefficients
/// are the medium's in place of the cell's.
struct Deflection {
  enum class Kind : std::int32_t { isotropic, henyey_greenstein, sampled };
  Kind kind = Kind::isotropic;
  double asymmetry = 0;     ///< g
  double half_inverse = 0;  ///< 1/(2 g); 0 for g = 0
  const PhaseSampler* sampler = nullptr;
  const DirectionalMedium* medium = nullptr;  ///< null where nothing depends on the direction
  bool turns_by_direction = false;
  const FormulaEmitter* emitter = nullptr;  ///< beside the cells' emission; null: none
};

/// All that a history of one band meets. Arrays belong to a PhotonScene.
struct PhotonSceneView {
  const PhotonCell* cells;
  const PhotonFace* faces;
  const Deflection* deflections;
  bool in_plane;
  bool by_direction = false;  ///< whether any deflection has a medium or an emitter
  double sense = 1;           ///< light travels so many times along histories: -1 where they go back
};

/// Where a history stands.
struct PhotonStart {
  double position[3];
  double direction[3];  ///< unit
  double weight;
  std::int32_t cell;
  std::int32_t entered;  ///< the face of the cell that the photon lies on, -1: none
};

/// What a history leaves, as sums over histories. Cells: the moments of the barycentric coordinates,
/// [cell][4 (1, wx, wy, wz)][4], each the sum of weight × integral of the coordinate along the track
/// [power length]; faces: [face][4] the sum of weight × coordinate, and of what is reflected by
/// the angle: glossily, or as a surface that refracts does [power].
struct PhotonTally {
  double* cells;
  double* faces;
  double* absorbed;  ///< [cell] [power], where a medium depends on the direction
};

/// When a history is, on its way.
struct PhotonClock {
  double time = 0;
  std::int32_t bin = -1;  ///< in which it last was; -1: before the first
};

/// What histories leave by when light passes, as sums over histories: bin k is between edges k and k + 1.
struct TimedTally {
  const double* edges;                ///< rising, not below 0 [time]
  std::int32_t bins;                  ///< one less
  const double* slowness;             ///< [region] [time/length]
  const std::int32_t* place_of_cell;  ///< [cell] number among those that are looked at, -1: none
  const std::int32_t* wall_of_face;   ///< [boundary face]
  PhotonClock* clocks;                ///< [history of a range]
  double* places;   ///< [place][bin][4] weight × integral of the barycentric coordinate along the track
  double* regions;  ///< [region][bin][2] the same without a coordinate [power length], and absorbed [power]
  double* walls;    ///< [wall][bin] arriving [power]
};

/// A photon where it met a wall, or where it scattered, as it came there.
struct PhotonHit {
  double position[3];
  float direction[3];  ///< unit, of travel
  float weight;        ///< 1 at the start
  std::int32_t place;  ///< boundary face or cell
};

/// Buffer for the hits of a walk. `count` includes the hits beyond the capacity.
struct HitBuffer {
  PhotonHit* hits = nullptr;
  std::size_t capacity = 0;
  std::size_t count = 0;
};
struct HitBuffers {
  HitBuffer walls;   ///< those walls that reflect otherwise than as mirrors, or transmit
  HitBuffer matter;  ///< where light is scattered
};

struct PhotonCounts {
  std::int64_t segments = 0;
  std::int64_t collisions = 0;
  std::int64_t lost = 0;  ///< given up, mostly caught between mirrors in a void
};

}  // namespace etendue
