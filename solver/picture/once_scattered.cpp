// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/picture/once_scattered.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "solver/parallel/parallel_for.h"

namespace etendue {
namespace {

constexpr double per_sphere = 1 / (4 * std::numbers::pi);

double sum_of(std::span<const double> values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// The light at a vertex: what arrives, else, in the dark, what would arrive without obstacles.
double look(const LightSource& source, const PointInCell& here, LightBeams& beams) {
  double sum = 0;
  for (const Sight sight : {Sight::attenuated, Sight::clear}) {
    beams.clear();
    source.add_beams(here, sight, shaft_light, beams);
    for (std::size_t i = 0; i < beams.size(); ++i) sum += sum_of(beams.fluence(i));
    if (sum > 0) break;
  }
  return sum;
}

}  // namespace

OnceScattered::Memory::Memory(const OnceScattered& scattered) : values(places * scattered.pairs()) {
  forget();
}

OnceScattered::OnceScattered(const LightSetup& lights, int threads)
    : lights_(lights), problem_(lights.problem()), phases_(problem_) {
  if (lights.empty()) return;
  fluence_ = uncollided_field(lights.paths(), lights.sources(), threads).by_source;
  look_at_vertices(threads);
}

void OnceScattered::look_at_vertices(int threads) {
  const TetrahedralMesh& mesh = problem_.mesh();
  const std::size_t sources = lights_.sources().size();
  std::vector<std::int32_t> cell_of(static_cast<std::size_t>(mesh.vertex_count()), -1);
  for (std::int32_t c = mesh.cell_count() - 1; c >= 0; --c)
    for (std::size_t b = 0; b < lights_.paths().bands(); ++b)
      if (phases_.of(mesh.region(CellIndex(c)), b) >= 0 &&
          problem_.scattering(CellIndex(c), static_cast<int>(b)) > 0)
        for (const std::int32_t v : mesh.vertices(CellIndex(c))) cell_of[static_cast<std::size_t>(v)] = c;
  vertex_beams_.resize(cell_of.size() * sources);
  const auto look_from = [&](std::size_t v, LightBeams& beams) {
    for (std::size_t s = 0; s < sources && cell_of[v] >= 0; ++s) {
      const double sum = look(*lights_.sources()[s], {CellIndex(cell_of[v]), mesh.points()[v]}, beams);
      for (std::size_t i = 0; i < beams.size() && sum > 0; ++i)
        vertex_beams_[v * sources + s].push_back({beams.direction(i), sum_of(beams.fluence(i)) / sum});
    }
    return true;
  };
  parallel_for(
      cell_of.size(), threads, 64, [&] { return LightBeams(lights_.paths().bands()); }, look_from);
}

// [source][phase]; in a vertex that is itself the light all directions are alike.
const double* OnceScattered::at_vertex(std::int32_t vertex, const Vec3& travel, Memory& memory) const {
  const std::size_t sources = lights_.sources().size(), phases = phases_.phases().size();
  const std::size_t place = static_cast<std::size_t>(vertex) % Memory::places;
  double* values = &memory.values[place * pairs()];
  if (memory.vertices[place] == vertex) return values;
  memory.vertices[place] = vertex;
  for (std::size_t s = 0; s < sources; ++s) {
    const std::vector<Beam>& beams = vertex_beams_[static_cast<std::size_t>(vertex) * sources + s];
    for (std::size_t p = 0; p < phases; ++p) {
      double sum = beams.empty() ? per_sphere : 0;
      for (const Beam& beam : beams)
        sum += beam.share * phase_value(phases_.phases()[p], std::clamp(travel.dot(beam.direction), -1., 1.));
      values[s * phases + p] = sum;
    }
  }
  return values;
}

void OnceScattered::add_at_vertices(CellIndex cell, const Vec3& travel, Memory& memory,
                                    std::span<double> values) const {
  if (fluence_.empty()) return;  // no lights, so there are no shares to look up
  const std::size_t bands = lights_.paths().bands(), phases = phases_.phases().size();
  const int region = problem_.mesh().region(cell);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t b = 0; b < bands; ++b) {
      const double scattering = problem_.scattering(cell, static_cast<int>(b));
      if (scattering == 0) continue;
      const int phase = phases_.of(region, b);
      const double* shares =
          phase < 0 ? &per_sphere : at_vertex(problem_.mesh().vertices(cell)[i], travel, memory) + phase;
      for (std::size_t s = 0; s < fluence_.size(); ++s)
        values[i * bands + b] += scattering * fluence_[s][(cell.at() * 4 + i) * bands + b] *
                                 (phase < 0 ? per_sphere : shares[s * phases]);
    }
}

void OnceScattered::add_at(const PointInCell& point, const Vec3& travel, LightBeams& beams,
                           std::span<double> values) const {
  const int region = problem_.mesh().region(point.cell);
  beams.clear();
  for (const auto& source : lights_.sources())
    source->add_beams(point, Sight::attenuated, shaft_light, beams);
  std::vector<double> turned(phases_.phases().size());
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double cosine = std::clamp(travel.dot(beams.direction(i)), -1., 1.);
    for (std::size_t p = 0; p < turned.size(); ++p) turned[p] = phase_value(phases_.phases()[p], cosine);
    for (std::size_t b = 0; b < beams.bands(); ++b) {
      const int phase = phases_.of(region, b);
      values[b] += problem_.scattering(point.cell, static_cast<int>(b)) * beams.fluence(i)[b] *
                   (phase < 0 ? per_sphere : turned[static_cast<std::size_t>(phase)]);
    }
  }
}

}  // namespace etendue
