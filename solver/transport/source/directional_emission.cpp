// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/source/directional_emission.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/problem/problem_checks.h"
#include "solver/transport/order/projected_area.h"

namespace etendue {
namespace {

using Formulas = std::vector<std::optional<AngularFormula>>;

bool any(const Formulas& formulas) {
  return std::ranges::any_of(formulas, [](const auto& formula) { return formula.has_value(); });
}

[[noreturn]] void refuse(const Origin& origin, double value, const Vec3& point, const Vec3& direction,
                         const std::string& band) {
  throw InputError(fault_at(
      origin, fmt::format("{:.6g}", value),
      fmt::format("{} at ({:.6g}, {:.6g}, {:.6g}) in the direction ({:.6g}, {:.6g}, {:.6g}) (band {}); must "
                  "be a finite number of at least 0 in every direction of the set",
                  std::isfinite(value) ? "negative" : "not a finite number", point.x(), point.y(), point.z(),
                  direction.x(), direction.y(), direction.z(), band)));
}

bool is_sound(double value) { return std::isfinite(value) && value >= 0; }

}  // namespace

DirectionalEmission::DirectionalEmission(const Problem& problem, const DirectionSet& directions,
                                         const AngularInput* other)
    : problem_(problem), directions_(directions), other_(other) {
  const TetrahedralMesh& mesh = problem.mesh();
  regions_.resize(problem.media().size());
  walls_.resize(problem.walls().size());
  const auto mark = [&](Emitter& emitter, std::span<const std::int32_t> vertices) {
    emitter.row.resize(static_cast<std::size_t>(mesh.vertex_count()), -1);
    for (const std::int32_t v : vertices)
      if (emitter.row[static_cast<std::size_t>(v)] < 0)
        emitter.row[static_cast<std::size_t>(v)] = static_cast<std::int32_t>(emitter.rows++);
  };
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    if (const int region = mesh.region(CellIndex(c)); emits(problem.medium(region)))
      mark(regions_[static_cast<std::size_t>(region)], mesh.vertices(CellIndex(c)));
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (const int wall = mesh.wall(FaceIndex(f)); any(problem.wall(wall).radiance_by_direction))
      mark(walls_[static_cast<std::size_t>(wall)], mesh.vertices(FaceIndex(f)));
  for (std::size_t i = 0; i < regions_.size(); ++i)
    add_tables(problem.media()[i].emission_by_direction, regions_[i]);
  for (std::size_t i = 0; i < walls_.size(); ++i)
    add_tables(problem.walls()[i].radiance_by_direction, walls_[i]);
  check_regions();
  check_walls();
}

void DirectionalEmission::add_tables(const Formulas& formulas, Emitter& emitter) {
  for (std::size_t band = 0; band < formulas.size(); ++band) {
    if (!formulas[band] || emitter.rows == 0) continue;
    emitter.tables.push_back(tables_.size());
    Table table{static_cast<int>(band),
                std::vector<double>(static_cast<std::size_t>(directions_.count()) * emitter.rows)};
#pragma omp parallel
    {
      const AngularFormula formula = *formulas[band];
#pragma omp for schedule(static)
      for (std::int32_t m = 0; m < directions_.count(); ++m)
        for (std::size_t v = 0; v < emitter.row.size(); ++v)
          if (emitter.row[v] >= 0)
            table.values[static_cast<std::size_t>(m) * emitter.rows +
                         static_cast<std::size_t>(emitter.row[v])] =
                formula.at(problem_.mesh().points()[v], directions_.direction(OrdinateIndex(m)));
    }
    tables_.push_back(std::move(table));
  }
}

void DirectionalEmission::check_regions() const {
  for (std::size_t i = 0; i < regions_.size(); ++i)
    for (const std::size_t t : regions_[i].tables)
      for (std::size_t v = 0; v < regions_[i].row.size(); ++v)
        for (std::size_t m = 0; m < directions_.directions().size() && regions_[i].row[v] >= 0; ++m) {
          const double value =
              tables_[t].values[m * regions_[i].rows + static_cast<std::size_t>(regions_[i].row[v])];
          if (!is_sound(value))
            refuse(origin_of(problem_.media()[i], "emission"), value, problem_.mesh().points()[v],
                   directions_.directions()[m],
                   problem_.bands().names[static_cast<std::size_t>(tables_[t].band)]);
        }
}

// Only directions into the domain count.
void DirectionalEmission::check_walls() const {
  const TetrahedralMesh& mesh = problem_.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const Emitter& wall = walls_[static_cast<std::size_t>(mesh.wall(face))];
    for (const std::size_t t : wall.tables)
      for (std::size_t m = 0; m < directions_.directions().size(); ++m) {
        if (projected_area(mesh.area_normal(face), directions_.directions()[m]) >= 0) continue;
        for (const std::int32_t v : mesh.vertices(face)) {
          const double value =
              tables_[t]
                  .values[m * wall.rows + static_cast<std::size_t>(wall.row[static_cast<std::size_t>(v)])];
          if (!is_sound(value))
            refuse(origin_of(problem_.wall(mesh.wall(face)), "radiance"), value, mesh.point(VertexIndex(v)),
                   directions_.directions()[m],
                   problem_.bands().names[static_cast<std::size_t>(tables_[t].band)]);
        }
      }
  }
}

bool DirectionalEmission::emits(const Medium& medium) { return any(medium.emission_by_direction); }

double DirectionalEmission::table_size(const Problem& problem, const DirectionSet& directions) {
  double tables = 0;
  const auto count = [&tables](const Formulas& formulas) {
    for (const auto& formula : formulas) tables += formula ? 1 : 0;
  };
  for (const Medium& medium : problem.media()) count(medium.emission_by_direction);
  for (const Wall& wall : problem.walls()) count(wall.radiance_by_direction);
  return tables * problem.mesh().vertex_count() * directions.count();
}

bool DirectionalEmission::depends_on_direction(CellIndex cell) const {
  return !regions_[static_cast<std::size_t>(problem_.mesh().region(cell))].tables.empty() ||
         (other_ != nullptr && other_->depends_on_direction(cell));
}

void DirectionalEmission::add(const Emitter& emitter, OrdinateIndex m, std::span<const std::int32_t> vertices,
                              std::span<double> values) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  for (const std::size_t t : emitter.tables)
    for (std::size_t i = 0; i < vertices.size(); ++i)
      values[i * bands + static_cast<std::size_t>(tables_[t].band)] +=
          tables_[t].values[m.at() * emitter.rows +
                            static_cast<std::size_t>(emitter.row[static_cast<std::size_t>(vertices[i])])];
}

void DirectionalEmission::add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  add(regions_[static_cast<std::size_t>(mesh.region(cell))], m, mesh.vertices(cell), values);
  if (other_ != nullptr) other_->add_source(m, cell, values);
}

void DirectionalEmission::add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  add(walls_[static_cast<std::size_t>(mesh.wall(face))], m, mesh.vertices(face), values);
  if (other_ != nullptr) other_->add_inflow(m, face, values);
}

DirectionalPowers DirectionalEmission::powers() const {
  if (empty()) return {};
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  DirectionalPowers powers;
  powers.regions.assign(regions_.size(), std::vector<double>(bands, 0));
  powers.walls.assign(walls_.size(), std::vector<double>(bands, 0));
  const auto integrate = [&](const Emitter& emitter, OrdinateIndex m, std::span<const std::int32_t> vertices,
                             double factor, std::vector<double>& power) {
    for (const std::size_t t : emitter.tables)
      for (const std::int32_t v : vertices)
        power[static_cast<std::size_t>(tables_[t].band)] +=
            factor * tables_[t].values[m.at() * emitter.rows +
                                       static_cast<std::size_t>(emitter.row[static_cast<std::size_t>(v)])];
  };
  for (std::int32_t m = 0; m < directions_.count(); ++m) {
    const OrdinateIndex ordinate(m);
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
      const auto region = static_cast<std::size_t>(mesh.region(CellIndex(c)));
      integrate(regions_[region], ordinate, mesh.vertices(CellIndex(c)),
                directions_.weight(ordinate) * mesh.volume(CellIndex(c)) / 4, powers.regions[region]);
    }
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
      const auto wall = static_cast<std::size_t>(mesh.wall(FaceIndex(f)));
      const double projected =
          projected_area(mesh.area_normal(FaceIndex(f)), directions_.direction(ordinate));
      if (projected < 0)
        integrate(walls_[wall], ordinate, mesh.vertices(FaceIndex(f)),
                  -projected * directions_.weight(ordinate) / 3, powers.walls[wall]);
    }
  }
  return powers;
}

}  // namespace etendue
