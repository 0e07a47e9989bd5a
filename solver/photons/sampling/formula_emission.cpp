// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/sampling/formula_emission.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/field_view.h"
#include "base/quadrature/sphere_cubature.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/photons/kernel/photon_scene.h"
#include "solver/problem/any_formula.h"
#include "solver/transport/source/directional_emission.h"

namespace etendue {
namespace {

using std::numbers::pi;
using Formulas = std::vector<std::optional<AngularFormula>>;

// Of the power of a vertex: a hundredth of what histories see.
constexpr double wanted = 1e-5;
// Directions of a rule in the plane.
constexpr int circle = 1440;
// The largest value is looked for from so many directions of a set on, by steps that are halved so often.
constexpr std::size_t climbers = 6;
constexpr int halvings = 12;
constexpr double first_step = 0.1;
// What may be missed of it.
constexpr double climb_margin = 1.02;
// Normals of faces in one plane differ by rounding.
constexpr double same_normal = 1e-9;

/// The largest value of a function of the direction: the best of a set, climbed to the top.
template <class Function>
double largest_value(const Function& function) {
  static const DirectionSet set = directions_ldfe_sq(3);
  std::vector<std::pair<double, Vec3>> found;
  for (const Vec3& w : set.directions()) found.emplace_back(function(w), w);
  std::ranges::partial_sort(found, found.begin() + climbers,
                            [](const auto& a, const auto& b) { return a.first > b.first; });
  double largest = 0;
  for (std::size_t i = 0; i < climbers; ++i) {
    auto [value, at] = found[i];
    double step = first_step;
    for (int halving = 0; halving < halvings;) {
      const Vec3 side = at.unitOrthogonal(), other = at.cross(side), from = at;
      for (const Vec3& way : {side, Vec3(-side), other, Vec3(-other)})
        if (const Vec3 next = (from + step * way).normalized(); function(next) > value) {
          value = function(next);
          at = next;
        }
      if (at != from) continue;
      step /= 2;
      ++halving;
    }
    largest = std::max(largest, value);
  }
  return climb_margin * largest;
}

/// A direction that is given in a frame about `normal`; as it is without one.
Vec3 in_frame_about(const Vec3& normal, const Vec3& w) {
  if (normal.isZero()) return w;
  const Vec3 side = normal.unitOrthogonal();
  return w.x() * side + w.y() * normal.cross(side) + w.z() * normal;
}

}  // namespace

double FormulaEmitter::at(const Vec3& point, const Vec3& travel) const {
  const CopyPool<AngularFormula>::Loan formula(pool_);
  return formula->at(point, travel);
}

double FormulaEmitter::at_corner(CellIndex cell, std::size_t i, const Vec3& travel) const {
  return at(corner_of(problem_.mesh(), cell, i), travel);
}

double FormulaEmitter::at_corner(FaceIndex face, std::size_t i, const Vec3& travel) const {
  return at(corner_of(problem_.mesh(), face, i), travel);
}

FormulaEmitter::Node FormulaEmitter::in_plane(const Place& place) const {
  const CopyPool<AngularFormula>::Loan formula(pool_);
  const Vec3& point = problem_.mesh().point(VertexIndex(place.vertex));
  const bool is_wall = !place.normal.isZero();
  Node node;
  for (int i = 0; i < circle; ++i) {
    const double angle = 2 * pi * (i + 0.5) / circle;
    const Vec3 travel(std::cos(angle), std::sin(angle), 0);
    const double seen = is_wall ? std::max(0.0, travel.dot(place.normal)) : 1;
    if (seen == 0) continue;
    const double value = formula->at(point, travel);
    node.integral += 2 * pi / circle * seen * value;
    node.largest = std::max(node.largest, climb_margin * value);
  }
  return node;
}

FormulaEmitter::Node FormulaEmitter::sent_from(const Place& place) const {
  if (problem_.space() == AngularSpace::plane) return in_plane(place);
  const CopyPool<AngularFormula>::Loan formula(pool_);
  const Vec3& point = problem_.mesh().point(VertexIndex(place.vertex));
  const bool is_wall = !place.normal.isZero();
  // About the normal, so that the wall's edge is one of the rule's.
  const auto sent = [&](const Vec3& w) -> std::array<double, 2> {
    if (is_wall && w.z() <= 0) return {0, 0};
    return {formula->at(point, in_frame_about(place.normal, w)) * (is_wall ? w.z() : 1), 0};
  };
  Node node;
  node.integral = integrate_over_sphere(sent, {}, wanted).values[0];
  node.largest = largest_value(
      [&](const Vec3& w) { return is_wall && w.dot(place.normal) <= 0 ? 0.0 : formula->at(point, w); });
  return node;
}

void FormulaEmitter::fill(const std::vector<Place>& places) {
  nodes_.resize(places.size());
  const auto count = static_cast<std::int64_t>(places.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t i = 0; i < count; ++i)
    nodes_[static_cast<std::size_t>(i)] = sent_from(places[static_cast<std::size_t>(i)]);
}

void FormulaEmitter::look_at_region(int region) {
  const TetrahedralMesh& mesh = problem_.mesh();
  const bool one = !CopyPool<AngularFormula>::Loan(pool_)->depends_on_place();
  std::map<std::int32_t, std::size_t> known;
  std::vector<Place> places;
  row_.assign(4 * static_cast<std::size_t>(mesh.cell_count()), 0);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    if (mesh.region(CellIndex(c)) != region) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::int32_t vertex = mesh.vertices(CellIndex(c))[i];
      const auto [at, is_new] = known.emplace(one ? 0 : vertex, places.size());
      if (is_new) places.push_back({vertex, Vec3::Zero()});
      row_[4 * CellIndex(c).at() + i] = at->second;
    }
  }
  fill(places);
}

void FormulaEmitter::look_at_wall(int wall) {
  const TetrahedralMesh& mesh = problem_.mesh();
  const bool one = !CopyPool<AngularFormula>::Loan(pool_)->depends_on_place();
  std::map<std::array<std::int64_t, 4>, std::size_t> known;
  std::vector<Place> places;
  row_.assign(3 * static_cast<std::size_t>(mesh.boundary_face_count()), 0);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    if (mesh.wall(FaceIndex(f)) != wall) continue;
    const Vec3 normal = -mesh.area_normal(FaceIndex(f)).normalized();
    const auto rounded = [&](int axis) { return std::llround(normal[axis] / same_normal); };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t vertex = mesh.vertices(FaceIndex(f))[i];
      const auto [at, is_new] = known.emplace(
          std::array<std::int64_t, 4>{one ? 0 : vertex, rounded(0), rounded(1), rounded(2)}, places.size());
      if (is_new) places.push_back({vertex, normal});
      row_[3 * FaceIndex(f).at() + i] = at->second;
    }
  }
  fill(places);
}

FormulaEmission::FormulaEmission(const Problem& problem) : problem_(problem), bands_(problem.band_count()) {
  const bool in_media = std::ranges::any_of(
      problem.media(), [](const Medium& m) { return any_formula(m.emission_by_direction); });
  const bool in_walls = std::ranges::any_of(
      problem.walls(), [](const Wall& w) { return any_formula(w.radiance_by_direction); });
  if (!in_media && !in_walls) return;
  const DirectionSet looked_at =
      problem.space() == AngularSpace::plane ? directions_flatland(96) : directions_ldfe_sq(1);
  // It looks at all values.
  DirectionalEmission(problem, looked_at, nullptr);
  const auto emitter = [&](const Formulas& formulas, int band) -> std::unique_ptr<FormulaEmitter> {
    const auto b = static_cast<std::size_t>(band);
    if (b >= formulas.size() || !formulas[b]) return nullptr;
    return std::make_unique<FormulaEmitter>(problem, *formulas[b]);
  };
  for (int region = 0; in_media && region < static_cast<int>(problem.media().size()); ++region)
    for (int band = 0; band < bands_; ++band) {
      auto made = emitter(problem.medium(region).emission_by_direction, band);
      if (made) made->look_at_region(region);
      regions_.push_back(std::move(made));
    }
  for (int wall = 0; in_walls && wall < static_cast<int>(problem.walls().size()); ++wall)
    for (int band = 0; band < bands_; ++band) {
      auto made = emitter(problem.wall(wall).radiance_by_direction, band);
      if (made) made->look_at_wall(wall);
      walls_.push_back(std::move(made));
    }
}

void FormulaEmission::add_to(Solution& fields) const {
  if (empty()) return;
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto bands = static_cast<std::size_t>(bands_);
  fields.by_direction.regions.assign(problem_.media().size(), std::vector<double>(bands, 0));
  fields.by_direction.walls.assign(problem_.walls().size(), std::vector<double>(bands, 0));
  const FaceField exitance(fields.exitance, bands);
  for (int band = 0; band < bands_; ++band) {
    const auto b = static_cast<std::size_t>(band);
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
      const CellIndex cell(c);
      const FormulaEmitter* emitter = of_region(mesh.region(cell), band);
      for (std::size_t i = 0; i < 4 && emitter != nullptr; ++i)
        fields.by_direction.regions[static_cast<std::size_t>(mesh.region(cell))][b] +=
            mesh.volume(cell) / 4 * emitter->node(cell, i).integral;
    }
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
      const FaceIndex face(f);
      const FormulaEmitter* emitter = of_wall(mesh.wall(face), band);
      for (std::size_t i = 0; i < 3 && emitter != nullptr; ++i) {
        const double sent = emitter->node(face, i).integral;
        fields.by_direction.walls[static_cast<std::size_t>(mesh.wall(face))][b] += mesh.area(face) / 3 * sent;
        exitance(face, i, b) += sent;
      }
    }
  }
}

double emission_along(const FormulaEmitter& emitter, std::int32_t cell, const double (&w)[3],
                      const double (&moments)[4]) {
  const Vec3 travel(-w[0], -w[1], -w[2]);
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += moments[i] * emitter.at_corner(CellIndex(cell), i, travel);
  return sum;
}

double radiance_along(const FormulaEmitter& emitter, std::int32_t face, const double (&w)[3],
                      const double (&shares)[3]) {
  const Vec3 travel(-w[0], -w[1], -w[2]);
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += shares[i] * emitter.at_corner(FaceIndex(face), i, travel);
  return sum;
}

}  // namespace etendue
