// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/moments/glossy_beams.h"

#include <algorithm>
#include <array>

#include "base/parallel/parallel_for.h"
#include "solver/uncollided/moments/face_beams.h"

namespace etendue {

GlossyBeams::GlossyBeams(const LightPaths& paths, const LightSources& sources, int threads) {
  const Problem& problem = paths.problem();
  const TetrahedralMesh& mesh = problem.mesh();
  place_of_.assign(static_cast<std::size_t>(mesh.boundary_face_count()), -1);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    if (!problem.wall(mesh.wall(FaceIndex(f))).is_glossy()) continue;
    place_of_[static_cast<std::size_t>(f)] = static_cast<std::int32_t>(faces_.size());
    faces_.push_back(f);
  }
  corners_.assign(3 * faces_.size(), LightBeams(paths.bands()));
  parallel_for(faces_.size(), threads, 4, [&](std::size_t place) {
    std::array<LightBeams, 3> found = beams_at_corners(paths, FaceIndex(faces_[place]), sources);
    std::ranges::move(found, corners_.begin() + static_cast<std::ptrdiff_t>(3 * place));
    return true;
  });
}

GlossyBeams GlossyBeams::of_bands(std::span<const int> bands) const {
  GlossyBeams other = *this;
  for (LightBeams& corner : other.corners_) {
    LightBeams beams(bands.size());
    for (std::size_t k = 0; k < corner.size(); ++k) {
      const std::span<double> irradiance = beams.add(corner.direction(k), corner.interval(k));
      for (std::size_t b = 0; b < bands.size(); ++b)
        irradiance[b] = corner.fluence(k)[static_cast<std::size_t>(bands[b])];
    }
    corner = std::move(beams);
  }
  return other;
}

double GlossyBeams::albedo(const Problem& problem, std::size_t place, std::size_t corner,
                           std::size_t band) const {
  const FaceIndex face(faces_[place]);
  const Reflectance* lobe = problem.wall(problem.mesh().wall(face)).glossy_in(band);
  if (lobe == nullptr) return 0;
  const Vec3 normal = problem.mesh().area_normal(face).normalized();
  const LightBeams& beams = arriving(place, corner);
  double all = 0, reflected = 0;
  for (std::size_t k = 0; k < beams.size(); ++k) {
    all += beams.fluence(k)[band];
    reflected += beams.fluence(k)[band] * lobe->albedo(beams.direction(k).dot(normal));
  }
  // Where no light comes, little can be reflected.
  return all > 0 ? reflected / all : lobe->albedo().mean();
}

}  // namespace etendue
