// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/first_collision.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/field_view.h"
#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/angular/media/matter_table.h"
#include "solver/uncollided/first_collision/conserve_moments.h"

namespace etendue {
namespace {

constexpr double per_sphere = 1 / (4 * std::numbers::pi);
}  // namespace

FirstCollision::FirstCollision(const Problem& problem, const RayMatter& matter, const UncollidedField& field,
                               const DirectionSet& directions, int threads)
    : problem_(problem),
      field_(field),
      directions_(directions),
      phases_(problem_),
      matter_(matter),
      behind_(faces_behind(problem_.mesh())),
      glossy_(problem_, field, directions, threads) {
  const TetrahedralMesh& mesh = problem_.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    half_range_.push_back(directions.half_range(mesh.area_normal(FaceIndex(f)).normalized()));
  const std::vector<std::vector<Vec3>> incident = number_directions();
  const auto phases = phases_.phases().size();
  for (std::size_t t = 0; t < tables_.size(); ++t) {
    tables_[t].assign(static_cast<std::size_t>(directions.count()) * incident[t].size(), 0);
    if (t < phases)
      tabulate_phase(phases_.phases()[t], incident[t], threads, tables_[t]);
    else
      tabulate_matter(matter_.scattering(static_cast<int>(t - phases)), incident[t], directions, threads,
                      tables_[t]);
  }
}

std::vector<std::vector<Vec3>> FirstCollision::number_directions() {
  const CollisionField& field = field_.collisions;
  const std::size_t tables = phases_.phases().size() + matter_.kind_count();
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  std::vector<std::vector<Vec3>> incident(tables);
  tables_.resize(tables);
  number_.assign(tables, std::vector<std::int32_t>(field.empty() ? 0 : field.directions().size(), -1));
  for (std::int32_t c = 0; !field.empty() && c < problem_.mesh().cell_count(); ++c)
    for (std::size_t b = 0; b < bands; ++b) {
      const int table = table_of(problem_.mesh().region(CellIndex(c)), b);
      if (table < 0) continue;
      const auto t = static_cast<std::size_t>(table);
      for (const std::int32_t direction : field.directions_at(CellIndex(c))) {
        std::int32_t& number = number_[t][static_cast<std::size_t>(direction)];
        if (number >= 0) continue;
        number = static_cast<std::int32_t>(incident[t].size());
        incident[t].push_back(field.directions().direction(static_cast<std::size_t>(direction)));
      }
    }
  for (const std::vector<Vec3>& directions : incident) length_.push_back(directions.size());
  return incident;
}

void FirstCollision::tabulate_phase(const PhaseFunction& phase, std::span<const Vec3> incident, int threads,
                                    std::vector<double>& table) const {
  const auto ordinates = static_cast<std::size_t>(directions_.count());
  const double asymmetry = phase_moment(phase, 1);
#pragma omp parallel num_threads(threads)
  {
    std::vector<double> values(ordinates);
#pragma omp for schedule(dynamic, 16)
    for (std::size_t k = 0; k < incident.size(); ++k) {
      for (std::size_t m = 0; m < ordinates; ++m)
        values[m] = phase_value(phase, std::clamp(directions_.directions()[m].dot(incident[k]), -1.0, 1.0));
      if (!(*std::ranges::max_element(values) > 0)) continue;
      conserve_moments(directions_, asymmetry * incident[k], values);
      for (std::size_t m = 0; m < ordinates; ++m) table[m * incident.size() + k] = values[m] - per_sphere;
    }
  }
}

int FirstCollision::table_of(int region, std::size_t band) const {
  if (const int kind = matter_.kind_of(region, band); kind >= 0)
    return static_cast<int>(phases_.phases().size()) + kind;
  return phases_.of(region, band);
}

bool FirstCollision::depends_on_direction(CellIndex cell) const {
  return scatters_by_direction(problem_, phases_, matter_, cell);
}

double FirstCollision::scattered(CellIndex cell, std::size_t node, std::size_t band) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  return scattered_density(problem_, field_, (cell.at() * 4 + node) * bands + band);
}

void FirstCollision::add_projected_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t b = 0; b < bands; ++b) values[i * bands + b] += per_sphere * scattered(cell, i, b);
  if (field_.collisions.empty()) return;
  const std::span<const std::int32_t> incident = field_.collisions.directions_at(cell);
  const int region = problem_.mesh().region(cell);
  // Neighbouring bands that scatter alike are added together.
  for (std::size_t first = 0, end = 0; first < bands && !incident.empty(); first = end) {
    const int table = table_of(region, first);
    for (end = first + 1; end < bands && table_of(region, end) == table;) ++end;
    if (table < 0) continue;
    const auto t = static_cast<std::size_t>(table);
    const double* const row = tables_[t].data() + m.at() * length_[t];
    for (std::size_t k = 0; k < incident.size(); ++k) {
      const double share = row[number_[t][static_cast<std::size_t>(incident[k])]];
      const double* const power = field_.collisions.values(cell, k).data();
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t b = first; b < end; ++b) values[i * bands + b] += share * power[i * bands + b];
    }
  }
}

void FirstCollision::add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  const ConstFaceField irradiance(field_.irradiance, bands);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t b = 0; b < bands; ++b)
      values[i * bands + b] += wall.diffuse[b] / half_range_[face.at()] * irradiance(face, i, b);
  // Both sides of a sheet have the same half range and the same nodes.
  for (std::size_t b = 0; b < wall.transmittance.size(); ++b)
    for (std::size_t i = 0; i < 3 && wall.transmittance[b] > 0; ++i)
      values[i * bands + b] +=
          wall.transmittance[b] / half_range_[face.at()] * irradiance(FaceIndex(behind_[face.at()]), i, b);
  glossy_.add(m, face, values);
}

std::size_t FirstCollision::memory(const LightSetup& lights, const DirectionSet& directions) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  const std::size_t bands = lights.paths().bands();
  const RayMatter& matter = lights.paths().matter();
  const std::size_t kinds = PhaseList(lights.problem()).phases().size() + matter.kind_count();
  const CollisionField::Size size = CollisionField::estimate(lights.paths(), lights.sources());
  const std::size_t tables = kinds * size.directions * static_cast<std::size_t>(directions.count());
  const std::size_t fields = (matter.empty() ? 0 : 1) + 8;
  return sizeof(double) * (fields * cells * 4 * bands + tables + 2 * cells * bands) + size.bytes +
         GlossyReflection::memory(lights.problem(), directions);
}

}  // namespace etendue
