// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/moments/glossy_beams.h"

#include <algorithm>
#include <array>

#include "base/clipped_polygon.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/uncollided/sources/beam_source.h"

namespace etendue {
namespace {

/// Part of the distance to the centroid from which a corner is sampled: obstacles on its edges do not
/// occlude it.
constexpr double step_inside = 1e-3;

/// Adds the mean irradiance of a face by a beam with a cross-section, which may lie between its corners.
void add_mean_irradiance(const BeamSource& beam, const TetrahedralMesh& mesh, FaceIndex face,
                         LightBeams& arriving) {
  const std::array<Vec3, 3> corners = corners_of(mesh, face);
  std::vector<double> fluence(arriving.bands());
  for (std::size_t image = 0; image < beam.directions().size(); ++image) {
    const Vec3& direction = beam.directions()[image];
    const double cosine = direction.dot(mesh.area_normal(face)) / mesh.area(face);
    if (cosine <= 0) continue;
    std::vector<double> sum(arriving.bands(), 0);
    for (const std::array<Vec3, 3>& lit : beam.lit_parts(image, corners)) {
      if (!beam.arrives({mesh.owner(face), (lit[0] + lit[1] + lit[2]) / 3}, direction, fluence)) continue;
      const double part = cosine * triangle_area(lit) / mesh.area(face);
      for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += part * fluence[b];
    }
    if (std::ranges::any_of(sum, [](double value) { return value > 0; }))
      std::ranges::copy(sum, arriving.add(direction).begin());
  }
}

/// The beams of all sources that arrive on the outer side of a face, as irradiance.
LightBeams irradiance_at(const LightPaths& paths, const std::vector<std::unique_ptr<LightSource>>& sources,
                         const PointInCell& at, FaceIndex face, Sight sight) {
  const Vec3 normal = paths.problem().mesh().area_normal(face).normalized();
  LightBeams beams(paths.bands()), arriving(paths.bands());
  for (const auto& source : sources) {
    if (source->as_beam() != nullptr && source->as_beam()->has_profile()) {
      add_mean_irradiance(*source->as_beam(), paths.problem().mesh(), face, arriving);
      continue;
    }
    beams.clear();
    source->add_beams(at, sight, coarse_light, beams);
    for (std::size_t k = 0; k < beams.size(); ++k) {
      const double cosine = beams.direction(k).dot(normal);
      const auto fluence = beams.fluence(k);
      if (cosine <= 0 || std::ranges::none_of(fluence, [](double value) { return value > 0; })) continue;
      const std::span<double> irradiance = arriving.add(beams.direction(k));
      for (std::size_t b = 0; b < irradiance.size(); ++b) irradiance[b] = cosine * fluence[b];
    }
  }
  return arriving;
}

}  // namespace

GlossyBeams::GlossyBeams(const LightPaths& paths, const std::vector<std::unique_ptr<LightSource>>& sources,
                         int threads) {
  const Problem& problem = paths.problem();
  const TetrahedralMesh& mesh = problem.mesh();
  place_of_.assign(static_cast<std::size_t>(mesh.boundary_face_count()), -1);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    if (!problem.wall(mesh.wall(FaceIndex(f))).is_glossy()) continue;
    place_of_[static_cast<std::size_t>(f)] = static_cast<std::int32_t>(faces_.size());
    faces_.push_back(f);
  }
  corners_.assign(3 * faces_.size(), LightBeams(paths.bands()));
  const auto count = static_cast<std::int64_t>(corners_.size());
#pragma omp parallel for schedule(dynamic, 16) num_threads(threads)
  for (std::int64_t i = 0; i < count; ++i) {
    const FaceIndex face(faces_[static_cast<std::size_t>(i / 3)]);
    const Vec3 corner = corner_of(mesh, face, static_cast<std::size_t>(i % 3));
    const PointInCell at{mesh.owner(face), corner + step_inside * (mesh.centroid(face) - corner)};
    LightBeams& beams = corners_[static_cast<std::size_t>(i)];
    beams = irradiance_at(paths, sources, at, face, Sight::attenuated);
    if (beams.size() == 0) beams = irradiance_at(paths, sources, at, face, Sight::clear);
  }
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
