// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/split/first_collision.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/tetrahedra/sheet_faces.h"
#include "mesh/tetrahedra/vertex_cells.h"
#include "solver/lights/vertex_light.h"
#include "solver/split/matter_table.h"

namespace etendue {
namespace {

constexpr double per_sphere = 1 / (4 * std::numbers::pi);
/// Turns a distribution p_m of integral 1 into p_m e^(b.w_m) over its integral, the nearest one in entropy
/// (Kullback 1959) that has this mean direction: small sets see a peak between their ordinates from the side,
/// and miss its mean cosine. Where the peak is narrower than the set can tell b stays at what it may be.
void keep_mean_direction(const DirectionSet& directions, const Vec3& wanted, std::vector<double>& p) {
  constexpr int most_steps = 40;
  constexpr double exact = 1e-14, longest_step = 2, steepest = 30;
  Vec3 b = Vec3::Zero();
  for (int step = 0; step < most_steps; ++step) {
    Vec3 mean = Vec3::Zero();
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    double sum = 0;
    for (std::size_t m = 0; m < p.size(); ++m) {
      const Vec3& w = directions.directions()[m];
      const double value = directions.weights()[m] * p[m] * std::exp(b.dot(w));
      sum += value;
      mean += value * w;
      spread += value * w * w.transpose();
    }
    mean /= sum;
    spread = spread / sum - mean * mean.transpose();
    const Vec3 missing = wanted - mean;
    if (missing.norm() < exact) break;
    // Newton's step for the maximum of b.wanted - ln(sum), which is concave in b.
    Vec3 change = spread.ldlt().solve(missing);
    if (!change.allFinite()) break;
    if (change.norm() > longest_step) change *= longest_step / change.norm();
    if ((b + change).norm() > steepest) break;
    b += change;
  }
  double integral = 0;
  for (std::size_t m = 0; m < p.size(); ++m) {
    p[m] *= std::exp(b.dot(directions.directions()[m]));
    integral += directions.weights()[m] * p[m];
  }
  for (double& value : p) value /= integral;
}

}  // namespace

FirstCollision::FirstCollision(const LightSetup& lights, const UncollidedField& field,
                               const DirectionSet& directions, int threads)
    : problem_(lights.problem()),
      field_(field),
      directions_(directions),
      phases_(problem_),
      matter_(lights.paths().matter()),
      behind_(faces_behind(problem_.mesh())),
      glossy_(problem_, field, directions, threads) {
  const TetrahedralMesh& mesh = problem_.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    half_range_.push_back(directions.half_range(mesh.area_normal(FaceIndex(f)).normalized()));
  tabulate(lights, threads);
}

void FirstCollision::tabulate(const LightSetup& lights, int threads) {
  const auto phases = phases_.phases().size();
  const auto size = static_cast<std::size_t>(directions_.count()) *
                    static_cast<std::size_t>(problem_.mesh().vertex_count());
  for (const auto& source : lights.sources()) {
    for (std::size_t p = 0; p < phases; ++p) {
      scattered_.emplace_back(size, per_sphere);
      tabulate_phase(*source, phases_.phases()[p], threads, scattered_.back());
    }
    for (std::size_t kind = 0; kind < matter_.kind_count(); ++kind) {
      scattered_.emplace_back(size, per_sphere);
      tabulate_matter(lights, *source, static_cast<int>(kind), directions_, threads, scattered_.back());
    }
  }
}

// At a vertex the light comes in beams k of directions w_k: the distribution is the sum over k of phi_k
// p(w_m.w_k), divided by its sum over the set, with the mean cosine that the phase function has.
void FirstCollision::tabulate_phase(const LightSource& source, const PhaseFunction& phase, int threads,
                                    std::vector<double>& table) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto vertices = static_cast<std::size_t>(mesh.vertex_count());
  const auto ordinates = static_cast<std::size_t>(directions_.count());
  const std::vector<CellIndex> cells = cells_of_vertices(mesh);
#pragma omp parallel num_threads(threads)
  {
    LightBeams beams(static_cast<std::size_t>(problem_.band_count()));
    std::vector<double> values(ordinates);
#pragma omp for schedule(dynamic, 64)
    for (std::size_t v = 0; v < vertices; ++v) {
      look_at_vertex(source, {cells[v], mesh.points()[v]}, mesh.centroid(cells[v]), beams);
      std::fill(values.begin(), values.end(), 0.0);
      double sum = 0, light = 0;
      Vec3 travel = Vec3::Zero();
      for (std::size_t k = 0; k < beams.size(); ++k) {
        double fluence = 0;
        for (const double value : beams.fluence(k)) fluence += value;
        light += fluence;
        travel += fluence * beams.direction(k);
        for (std::size_t m = 0; m < ordinates; ++m)
          values[m] +=
              fluence *
              phase_value(phase, std::clamp(directions_.directions()[m].dot(beams.direction(k)), -1.0, 1.0));
      }
      for (std::size_t m = 0; m < ordinates; ++m) sum += directions_.weights()[m] * values[m];
      // In a vertex that is itself the light all directions are alike.
      if (!(sum > 0)) continue;
      for (double& value : values) value /= sum;
      keep_mean_direction(directions_, phase_moment(phase, 1) * travel / light, values);
      for (std::size_t m = 0; m < ordinates; ++m) table[m * vertices + v] = values[m];
    }
  }
}

int FirstCollision::table_of(int region, std::size_t band) const {
  if (const int kind = matter_.kind_of(region, band); kind >= 0)
    return static_cast<int>(phases_.phases().size()) + kind;
  return phases_.of(region, band);
}

bool FirstCollision::depends_on_direction(CellIndex cell) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  const int region = problem_.mesh().region(cell);
  for (std::size_t b = 0; b < bands; ++b)
    if (table_of(region, b) >= 0 && problem_.scattering(cell, static_cast<int>(b)) > 0) return true;
  return false;
}

void FirstCollision::add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  const int region = mesh.region(cell);
  const std::size_t row = m.at() * static_cast<std::size_t>(mesh.vertex_count());
  const std::size_t sources = field_.by_source.size();
  const std::size_t tables = phases_.phases().size() + matter_.kind_count();
  for (std::size_t b = 0; b < bands; ++b) {
    const double scattering = problem_.scattering(cell, static_cast<int>(b));
    if (scattering == 0) continue;
    const int table = table_of(region, b);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t node = (cell.at() * 4 + i) * bands + b;
      for (std::size_t s = 0; s < sources; ++s) {
        const double collided = field_.collided_by_source.empty() ? scattering * field_.by_source[s][node]
                                                                  : field_.collided_by_source[s][node];
        const double share = table < 0 ? per_sphere
                                       : scattered_[s * tables + static_cast<std::size_t>(table)]
                                                   [row + static_cast<std::size_t>(mesh.vertices(cell)[i])];
        values[i * bands + b] += collided * share;
      }
    }
  }
}

void FirstCollision::add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t b = 0; b < bands; ++b)
      values[i * bands + b] +=
          wall.diffuse[b] / half_range_[face.at()] * field_.irradiance[(face.at() * 3 + i) * bands + b];
  // Both sides of a sheet have the same half range and the same nodes.
  for (std::size_t b = 0; b < wall.transmittance.size(); ++b)
    for (std::size_t i = 0; i < 3 && wall.transmittance[b] > 0; ++i)
      values[i * bands + b] +=
          wall.transmittance[b] / half_range_[face.at()] *
          field_.irradiance[(static_cast<std::size_t>(behind_[face.at()]) * 3 + i) * bands + b];
  glossy_.add(m, face, values);
}

std::size_t FirstCollision::memory(const LightSetup& lights, const DirectionSet& directions) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  const auto vertices = static_cast<std::size_t>(mesh.vertex_count());
  const std::size_t bands = lights.paths().bands(), sources = lights.sources().size();
  const RayMatter& matter = lights.paths().matter();
  const std::size_t kinds = PhaseList(lights.problem()).phases().size() + matter.kind_count();
  const std::size_t tables = sources * kinds * vertices * static_cast<std::size_t>(directions.count());
  const std::size_t fields = (matter.empty() ? 1 : 2) * sources + 8;
  return sizeof(double) * (fields * cells * 4 * bands + tables + 2 * cells * bands) +
         GlossyReflection::memory(lights.problem(), directions);
}

}  // namespace etendue
