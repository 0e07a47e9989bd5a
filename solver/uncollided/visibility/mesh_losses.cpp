// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/visibility/mesh_losses.h"

#include <algorithm>
#include <cmath>

#include "mesh/tetrahedra/adjacency/vertex_cells.h"
#include "mesh/tetrahedra/sheet_faces.h"

namespace etendue {
namespace {

/// How finely the light is seen.
constexpr LightDetail detail{0.35, 0.03, 0.6, 0.9, TriangleRule::three_points};
/// By how much the optical depth of the way to the middle of an edge may differ from the mean of its ends. A
/// part of it is what quadratic interpolation misses: the edge of a cloud is a kink.
constexpr double steep = 0.02;
/// Depths and directions that differ by less are the same.
constexpr double same = 1e-9;

}  // namespace

template <std::size_t corners>
WayLoss LossesBetween<corners>::at(const std::array<double, corners>& barycentric, std::size_t band) const {
  WayLoss loss{0};
  const auto add = [&](double part, const WayLoss& other) {
    loss.visible += part * other.visible;
    loss.extinction += part * other.extinction;
    loss.turn += part * other.turn;
  };
  for (std::size_t i = 0; i < corners; ++i) add(barycentric[i], corner[i][band]);
  std::size_t k = 0;
  for (std::size_t i = 0; i < corners; ++i)
    for (std::size_t j = i + 1; j < corners; ++j, ++k)
      if (!edge[k].empty()) add(4 * barycentric[i] * barycentric[j], edge[k][band]);
  return loss;
}

MeshLosses::MeshLosses(const LightPaths& paths, const ExtendedSource& source, int threads)
    : source_(source), bands_(paths.bands()) {
  look_at_vertices(paths, threads);
  if (!are_even()) look_at_edges(paths, threads);
}

void MeshLosses::look_at_vertices(const LightPaths& paths, int threads) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const std::vector<CellIndex> cells = cells_of_vertices(mesh);
  at_vertices_.resize(cells.size() * bands_);
  vertex_sees_.resize(cells.size());
#pragma omp parallel num_threads(threads)
  {
    LightBeams beams(bands_);
#pragma omp for schedule(dynamic, 64)
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      const auto i = static_cast<std::size_t>(v);
      vertex_sees_[i] = look(source_, {cells[i], mesh.point(VertexIndex(v))}, detail, beams,
                             std::span(at_vertices_).subspan(i * bands_, bands_));
    }
  }
  // What a vertex of a sheet sees depends on the side, so the cells around it do not share it.
  for (const std::int32_t v : vertices_of_sheets(mesh))
    vertex_sees_[static_cast<std::size_t>(v)] = Seen::by_side;
}

bool MeshLosses::are_even() const {
  const WayLoss* first = nullptr;
  for (std::size_t v = 0; v < vertex_sees_.size(); ++v) {
    if (vertex_sees_[v] != Seen::all) continue;
    if (first == nullptr) first = &at_vertices_[v * bands_];
    for (std::size_t b = 0; b < bands_; ++b) {
      const WayLoss& here = at_vertices_[v * bands_ + b];
      if (std::abs(here.extinction - first[b].extinction) * here.way > same || here.turn.norm() > same)
        return false;
    }
  }
  return true;
}

void MeshLosses::look_at_edges(const LightPaths& paths, int threads) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  edges_ =
      MeshEdges(mesh, [&](std::int32_t v) { return vertex_sees_[static_cast<std::size_t>(v)] == Seen::all; });
  at_edges_.resize(edges_.size() * bands_);
  edge_sees_.resize(edges_.size());
  steep_.resize(edges_.size());
#pragma omp parallel num_threads(threads)
  {
    LightBeams beams(bands_);
#pragma omp for schedule(dynamic, 64)
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const MeshEdges::Edge& edge = edges_[e];
      const Vec3 middle = (mesh.point(VertexIndex(edge.first)) + mesh.point(VertexIndex(edge.second))) / 2;
      const std::span<WayLoss> losses = std::span(at_edges_).subspan(e * bands_, bands_);
      edge_sees_[e] = look(source_, {edge.cell, middle}, detail, beams, losses);
      for (std::size_t b = 0; b < bands_; ++b) {
        const WayLoss& p = at_vertices_[static_cast<std::size_t>(edge.first) * bands_ + b];
        const WayLoss& q = at_vertices_[static_cast<std::size_t>(edge.second) * bands_ + b];
        WayLoss& here = losses[b];
        here.visible -= (p.visible + q.visible) / 2;
        here.extinction -= (p.extinction + q.extinction) / 2;
        here.turn -= (p.turn + q.turn) / 2;
        if (std::abs(here.extinction) * here.way > steep) steep_[e] = 1;
      }
    }
  }
}

template <std::size_t corners>
Interpolation MeshLosses::take(const std::array<std::int32_t, corners>& vertices,
                               LossesBetween<corners>& losses) const {
  const auto row = [this](const std::vector<WayLoss>& all, std::size_t i) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(i * bands_);
    return std::vector<WayLoss>(first, first + static_cast<std::ptrdiff_t>(bands_));
  };
  for (std::size_t i = 0; i < corners; ++i) {
    const auto v = static_cast<std::size_t>(vertices[i]);
    if (vertex_sees_[v] != Seen::all) return Interpolation::unseen;
    losses.corner[i] = row(at_vertices_, v);
  }
  if (edges_.size() == 0) return Interpolation::possible;
  bool steep = false;
  std::size_t k = 0;
  for (std::size_t i = 0; i < corners; ++i)
    for (std::size_t j = i + 1; j < corners; ++j, ++k) {
      const std::size_t e = edges_.between(vertices[i], vertices[j]);
      if (edge_sees_[e] != Seen::all) return Interpolation::unseen;
      steep = steep || steep_[e] != 0;
      losses.edge[k] = row(at_edges_, e);
    }
  return steep ? Interpolation::steep : Interpolation::possible;
}

template struct LossesBetween<3>;
template struct LossesBetween<4>;
template Interpolation MeshLosses::take(const std::array<std::int32_t, 3>&, LossesBetween<3>&) const;
template Interpolation MeshLosses::take(const std::array<std::int32_t, 4>&, LossesBetween<4>&) const;

}  // namespace etendue
