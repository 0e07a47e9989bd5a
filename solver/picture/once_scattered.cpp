// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/picture/once_scattered.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "solver/angle/scattered_light.h"
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

OnceScattered::Memory::Memory(const OnceScattered& scattered)
    : values(places * scattered.pairs()), matter(scattered.matter_.kind_count()) {
  forget();
}

OnceScattered::OnceScattered(const LightSetup& lights, int threads)
    : lights_(lights), problem_(lights.problem()), phases_(problem_), matter_(lights.paths().matter()) {
  if (lights.empty()) return;
  UncollidedField field = uncollided_field(lights.paths(), lights.sources(), threads);
  fluence_ = matter_.empty() ? std::move(field.by_source) : std::move(field.collided_by_source);
  for (std::size_t kind = 0; kind < matter_.kind_count(); ++kind) {
    const auto* leaves = std::get_if<LeafCanopy>(&matter_.scattering(static_cast<int>(kind)));
    normals_.push_back(leaves != nullptr ? leaf_normals(leaves->angles) : LeafNormals{});
  }
  look_at_vertices(threads);
}

void OnceScattered::look_at_vertices(int threads) {
  const TetrahedralMesh& mesh = problem_.mesh();
  const std::size_t sources = lights_.sources().size();
  std::vector<std::int32_t> cell_of(static_cast<std::size_t>(mesh.vertex_count()), -1);
  for (std::int32_t c = mesh.cell_count() - 1; c >= 0; --c)
    for (std::size_t b = 0; b < lights_.paths().bands(); ++b)
      if (way_of(mesh.region(CellIndex(c)), b) >= 0 &&
          problem_.scattering(CellIndex(c), static_cast<int>(b)) > 0)
        for (const std::int32_t v : mesh.vertices(CellIndex(c))) cell_of[static_cast<std::size_t>(v)] = c;
  vertex_beams_.resize(cell_of.size() * sources);
  const auto look_from = [&](std::size_t v, LightBeams& beams) {
    for (std::size_t s = 0; s < sources && cell_of[v] >= 0; ++s) {
      const double sum = look(*lights_.sources()[s], {CellIndex(cell_of[v]), mesh.points()[v]}, beams);
      for (std::size_t i = 0; i < beams.size() && sum > 0; ++i) {
        Beam beam{beams.direction(i), sum_of(beams.fluence(i)) / sum, {}};
        for (const PathCoefficients& kind : matter_.view(beam.direction).kinds)
          beam.scattered.push_back(kind.scattering);
        vertex_beams_[v * sources + s].push_back(std::move(beam));
      }
    }
    return true;
  };
  parallel_for(
      cell_of.size(), threads, 64, [&] { return LightBeams(lights_.paths().bands()); }, look_from);
}

int OnceScattered::way_of(int region, std::size_t band) const {
  if (const int kind = matter_.kind_of(region, band); kind >= 0)
    return static_cast<int>(phases_.phases().size()) + kind;
  return phases_.of(region, band);
}

void OnceScattered::ask_matter(const Vec3& beam, const Vec3& travel, Memory& memory) const {
  if (memory.beam == beam) return;
  memory.beam = beam;
  for (std::size_t kind = 0; kind < normals_.size(); ++kind)
    memory.matter[kind] =
        scattering_value(matter_.scattering(static_cast<int>(kind)), normals_[kind], beam, travel);
}

// [source][way]; in a vertex that is itself the light all directions are alike.
const double* OnceScattered::at_vertex(std::int32_t vertex, const Vec3& travel, Memory& memory) const {
  const std::size_t sources = lights_.sources().size(), phases = phases_.phases().size();
  const std::size_t place = static_cast<std::size_t>(vertex) % Memory::places;
  double* const all = &memory.values[place * pairs()];
  if (memory.vertices[place] == vertex) return all;
  memory.vertices[place] = vertex;
  for (std::size_t s = 0; s < sources; ++s) {
    double* values = all + s * ways();
    const std::vector<Beam>& beams = vertex_beams_[static_cast<std::size_t>(vertex) * sources + s];
    std::fill(values, values + ways(), beams.empty() ? per_sphere : 0);
    std::vector<double> scattered(ways() - phases, 0);
    for (const Beam& beam : beams) {
      for (std::size_t p = 0; p < phases; ++p)
        values[p] +=
            beam.share * phase_value(phases_.phases()[p], std::clamp(travel.dot(beam.direction), -1., 1.));
      if (scattered.empty()) continue;
      ask_matter(beam.direction, travel, memory);
      for (std::size_t kind = 0; kind < scattered.size(); ++kind) {
        values[phases + kind] += beam.share * memory.matter[kind];
        scattered[kind] += beam.share * beam.scattered[kind];
      }
    }
    for (std::size_t kind = 0; kind < scattered.size(); ++kind)
      if (scattered[kind] > 0) values[phases + kind] /= scattered[kind];
  }
  return all;
}

void OnceScattered::add_at_vertices(CellIndex cell, const Vec3& travel, Memory& memory,
                                    std::span<double> values) const {
  if (fluence_.empty()) return;  // no lights, so there are no shares to look up
  const std::size_t bands = lights_.paths().bands();
  const int region = problem_.mesh().region(cell);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t b = 0; b < bands; ++b) {
      const double scattering = problem_.scattering(cell, static_cast<int>(b));
      if (scattering == 0) continue;
      const int way = way_of(region, b);
      const double* shares =
          way < 0 ? &per_sphere : at_vertex(problem_.mesh().vertices(cell)[i], travel, memory) + way;
      for (std::size_t s = 0; s < fluence_.size(); ++s)
        values[i * bands + b] += (matter_.empty() ? scattering : 1) *
                                 fluence_[s][(cell.at() * 4 + i) * bands + b] *
                                 (way < 0 ? per_sphere : shares[s * ways()]);
    }
}

void OnceScattered::add_at(const PointInCell& point, const Vec3& travel, LightBeams& beams,
                           std::span<double> values) const {
  const int region = problem_.mesh().region(point.cell);
  beams.clear();
  for (const auto& source : lights_.sources())
    source->add_beams(point, Sight::attenuated, shaft_light, beams);
  const std::size_t phases = phases_.phases().size();
  std::vector<double> turned(ways());
  std::optional<Memory> memory;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const Vec3& beam = beams.direction(i);
    const double cosine = std::clamp(travel.dot(beam), -1., 1.);
    for (std::size_t p = 0; p < phases; ++p) turned[p] = phase_value(phases_.phases()[p], cosine);
    RayMatter::View view;
    if (matter_.depends_on_direction(region)) {
      if (!memory) memory.emplace(*this);
      view = matter_.view(beam);
      ask_matter(beam, travel, *memory);
      for (std::size_t kind = 0; kind < view.kinds.size(); ++kind)
        turned[phases + kind] =
            view.kinds[kind].scattering > 0 ? memory->matter[kind] / view.kinds[kind].scattering : 0;
    }
    for (std::size_t b = 0; b < beams.bands(); ++b) {
      const int way = way_of(region, b);
      values[b] += matter_.at(point.cell, b, view, point.position).scattering * beams.fluence(i)[b] *
                   (way < 0 ? per_sphere : turned[static_cast<std::size_t>(way)]);
    }
  }
}

}  // namespace etendue
