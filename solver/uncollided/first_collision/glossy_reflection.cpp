// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/glossy_reflection.h"

#include <algorithm>
#include <cmath>

namespace etendue {

GlossyReflection::GlossyReflection(const Problem& problem, const UncollidedField& field,
                                   const DirectionSet& directions, int threads)
    : problem_(problem),
      field_(field),
      directions_(directions),
      bands_(static_cast<std::size_t>(problem.band_count())),
      pairs_(static_cast<std::size_t>(directions.count() / 2)),
      table_(field.glossy.faces().size() * 3 * bands_ * pairs_, 0) {
  const auto count = static_cast<std::int64_t>(field.glossy.faces().size());
#pragma omp parallel for schedule(dynamic, 4) num_threads(threads)
  for (std::int64_t place = 0; place < count; ++place)
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (std::size_t b = 0; b < bands_; ++b) tabulate(static_cast<std::size_t>(place), corner, b);
}

void GlossyReflection::tabulate(std::size_t place, std::size_t corner, std::size_t band) {
  const FaceIndex face(field_.glossy.faces()[place]);
  const Reflectance* lobe = problem_.wall(problem_.mesh().wall(face)).glossy_in(band);
  if (lobe == nullptr) return;
  const Vec3 normal = -problem_.mesh().area_normal(face).normalized();
  const LightBeams& beams = field_.glossy.arriving(place, corner);
  double* row = table_.data() + ((place * 3 + corner) * bands_ + band) * pairs_;
  Vec3 mirrored = Vec3::Zero();
  for (std::size_t k = 0; k < beams.size(); ++k) {
    const Vec3& in = beams.direction(k);
    mirrored += beams.fluence(k)[band] * (in - 2 * in.dot(normal) * normal);
  }
  double sum = 0, best = -2, best_across = 0;
  std::size_t nearest = 0;
  for (std::size_t p = 0; p < pairs_; ++p) {
    const OrdinateIndex first(static_cast<std::int32_t>(2 * p));
    const double cosine = directions_.direction(first).dot(normal);
    const Vec3 out = cosine < 0 ? Vec3(-directions_.direction(first)) : directions_.direction(first);
    const double across = directions_.weight(first) * std::abs(cosine);
    for (std::size_t k = 0; k < beams.size(); ++k)
      row[p] += beams.fluence(k)[band] * lobe->between(beams.direction(k), out, normal);
    sum += across * row[p];
    if (across <= 0 || out.dot(mirrored) <= best) continue;
    best = out.dot(mirrored);
    best_across = across;
    nearest = p;
  }
  const double part = field_.glossy.albedo(problem_, place, corner, band);
  if (!(sum > 0)) {
    row[nearest] = part / best_across;
    return;
  }
  for (std::size_t p = 0; p < pairs_; ++p) row[p] *= part / sum;
}

void GlossyReflection::add(OrdinateIndex m, FaceIndex face, std::span<double> values) const {
  const std::int32_t place = field_.glossy.place_of(face);
  if (place < 0) return;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t b = 0; b < bands_; ++b)
      values[i * bands_ + b] +=
          field_.irradiance[(face.at() * 3 + i) * bands_ + b] *
          table_[((static_cast<std::size_t>(place) * 3 + i) * bands_ + b) * pairs_ + m.at() / 2];
}

std::size_t GlossyReflection::memory(const Problem& problem, const DirectionSet& directions) {
  std::size_t faces = 0;
  for (std::int32_t f = 0; f < problem.mesh().boundary_face_count(); ++f)
    faces += problem.wall(problem.mesh().wall(FaceIndex(f))).is_glossy() ? 1 : 0;
  return faces * 3 * static_cast<std::size_t>(problem.band_count() * directions.count()) / 2 * sizeof(double);
}

}  // namespace etendue
