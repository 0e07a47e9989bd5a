// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/visibility/vertex_attenuation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/tetrahedra/adjacency/vertex_cells.h"
#include "mesh/tetrahedra/sheet_faces.h"

namespace etendue {
namespace {

/// Sampling of the light.
constexpr LightDetail sampling{0.35, 0.03, 0.6, 0.9, TriangleRule::three_points};
/// By how much the optical depth of the path to the middle of an edge may differ from the mean of its ends. A
/// part of it is what quadratic interpolation misses: the edge of a cloud is a kink.
constexpr double steep = 0.02;
/// Depths and directions that differ by less are the same.
constexpr double same = 1e-9;

/// Brings what each rank has sampled, [place][band] and the visibility of each place, to all.
void share(std::vector<PathAttenuation>& attenuation, std::vector<Visibility>& visibility, std::size_t bands,
           RankGroup* ranks) {
  if (ranks == nullptr) return;
  constexpr std::size_t length = 6;  // numbers of an attenuation
  const RankShare own(ranks);
  std::vector<double> numbers(length * attenuation.size() + visibility.size(), 0);
  const std::span<double> seen = std::span(numbers).last(visibility.size());
  for (std::size_t place = 0; place < visibility.size(); ++place) {
    if (!own.has(place)) continue;
    seen[place] = static_cast<double>(visibility[place]);
    for (std::size_t i = place * bands; i < (place + 1) * bands; ++i) {
      const PathAttenuation& of = attenuation[i];
      const std::array<double, length> packed = {of.visible,        of.extinction,     of.deflection.x(),
                                                 of.deflection.y(), of.deflection.z(), of.length};
      std::ranges::copy(packed, numbers.begin() + static_cast<std::ptrdiff_t>(length * i));
    }
  }
  ranks->merge(numbers);
  for (std::size_t i = 0; i < attenuation.size(); ++i) {
    const double* const of = numbers.data() + length * i;
    attenuation[i] = {of[0], of[1], Vec3(of[2], of[3], of[4]), of[5]};
  }
  for (std::size_t place = 0; place < visibility.size(); ++place)
    visibility[place] = static_cast<Visibility>(static_cast<int>(seen[place]));
}

}  // namespace

template <std::size_t corners>
PathAttenuation InterpolatedAttenuation<corners>::at(const std::array<double, corners>& barycentric,
                                                     std::size_t band) const {
  PathAttenuation attenuation{0};
  const auto add = [&](double part, const PathAttenuation& other) {
    attenuation.visible += part * other.visible;
    attenuation.extinction += part * other.extinction;
    attenuation.deflection += part * other.deflection;
  };
  for (std::size_t i = 0; i < corners; ++i) add(barycentric[i], corner[i][band]);
  std::size_t k = 0;
  for (std::size_t i = 0; i < corners; ++i)
    for (std::size_t j = i + 1; j < corners; ++j, ++k)
      if (!edge[k].empty()) add(4 * barycentric[i] * barycentric[j], edge[k][band]);
  return attenuation;
}

VertexAttenuation::VertexAttenuation(const LightPaths& paths, const ExtendedSource& source, int threads,
                                     RankGroup* ranks)
    : source_(source), bands_(paths.bands()) {
  sample_vertices(paths, threads, ranks);
  if (!are_even()) sample_edges(paths, threads, ranks);
}

void VertexAttenuation::sample_vertices(const LightPaths& paths, int threads, RankGroup* ranks) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const std::vector<CellIndex> cells = cells_of_vertices(mesh);
  at_vertices_.resize(cells.size() * bands_);
  vertex_visibility_.resize(cells.size());
  const RankShare own(ranks);
#pragma omp parallel num_threads(threads)
  {
    LightBeams beams(bands_);
#pragma omp for schedule(dynamic, 64)
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      const auto i = static_cast<std::size_t>(v);
      if (!own.has(i)) continue;
      vertex_visibility_[i] = sample(source_, {cells[i], mesh.point(VertexIndex(v))}, sampling, beams,
                                     std::span(at_vertices_).subspan(i * bands_, bands_));
    }
  }
  share(at_vertices_, vertex_visibility_, bands_, ranks);
  // The visibility from a vertex of a sheet depends on the side, so the cells around it do not share it.
  for (const std::int32_t v : vertices_of_sheets(mesh))
    vertex_visibility_[static_cast<std::size_t>(v)] = Visibility::depends_on_side;
}

bool VertexAttenuation::are_even() const {
  const PathAttenuation* first = nullptr;
  for (std::size_t v = 0; v < vertex_visibility_.size(); ++v) {
    if (vertex_visibility_[v] != Visibility::all) continue;
    if (first == nullptr) first = &at_vertices_[v * bands_];
    for (std::size_t b = 0; b < bands_; ++b) {
      const PathAttenuation& here = at_vertices_[v * bands_ + b];
      if (std::abs(here.extinction - first[b].extinction) * here.length > same ||
          here.deflection.norm() > same)
        return false;
    }
  }
  return true;
}

void VertexAttenuation::sample_edges(const LightPaths& paths, int threads, RankGroup* ranks) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  edges_ = MeshEdges(mesh, [&](std::int32_t v) {
    return vertex_visibility_[static_cast<std::size_t>(v)] == Visibility::all;
  });
  at_edges_.resize(edges_.size() * bands_);
  edge_visibility_.resize(edges_.size());
  const RankShare own(ranks);
#pragma omp parallel num_threads(threads)
  {
    LightBeams beams(bands_);
#pragma omp for schedule(dynamic, 64)
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (!own.has(e)) continue;
      const MeshEdges::Edge& edge = edges_[e];
      const Vec3 middle = (mesh.point(VertexIndex(edge.first)) + mesh.point(VertexIndex(edge.second))) / 2;
      const std::span<PathAttenuation> attenuation = std::span(at_edges_).subspan(e * bands_, bands_);
      edge_visibility_[e] = sample(source_, {edge.cell, middle}, sampling, beams, attenuation);
      for (std::size_t b = 0; b < bands_; ++b) {
        const PathAttenuation& p = at_vertices_[static_cast<std::size_t>(edge.first) * bands_ + b];
        const PathAttenuation& q = at_vertices_[static_cast<std::size_t>(edge.second) * bands_ + b];
        PathAttenuation& here = attenuation[b];
        here.visible -= (p.visible + q.visible) / 2;
        here.extinction -= (p.extinction + q.extinction) / 2;
        here.deflection -= (p.deflection + q.deflection) / 2;
      }
    }
  }
  share(at_edges_, edge_visibility_, bands_, ranks);
  steep_.resize(edges_.size());
  for (std::size_t i = 0; i < at_edges_.size(); ++i)
    if (std::abs(at_edges_[i].extinction) * at_edges_[i].length > steep) steep_[i / bands_] = 1;
}

template <std::size_t corners>
Interpolation VertexAttenuation::take(const std::array<std::int32_t, corners>& vertices,
                                      InterpolatedAttenuation<corners>& interpolated) const {
  const auto row = [this](const std::vector<PathAttenuation>& all, std::size_t i) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(i * bands_);
    return std::vector<PathAttenuation>(first, first + static_cast<std::ptrdiff_t>(bands_));
  };
  for (std::size_t i = 0; i < corners; ++i) {
    const auto v = static_cast<std::size_t>(vertices[i]);
    if (vertex_visibility_[v] != Visibility::all) return Interpolation::unseen;
    interpolated.corner[i] = row(at_vertices_, v);
  }
  if (edges_.size() == 0) return Interpolation::possible;
  bool steep = false;
  std::size_t k = 0;
  for (std::size_t i = 0; i < corners; ++i)
    for (std::size_t j = i + 1; j < corners; ++j, ++k) {
      const std::size_t e = edges_.between(vertices[i], vertices[j]);
      if (edge_visibility_[e] != Visibility::all) return Interpolation::unseen;
      steep = steep || steep_[e] != 0;
      interpolated.edge[k] = row(at_edges_, e);
    }
  return steep ? Interpolation::steep : Interpolation::possible;
}

template struct InterpolatedAttenuation<3>;
template struct InterpolatedAttenuation<4>;
template Interpolation VertexAttenuation::take(const std::array<std::int32_t, 3>&,
                                               InterpolatedAttenuation<3>&) const;
template Interpolation VertexAttenuation::take(const std::array<std::int32_t, 4>&,
                                               InterpolatedAttenuation<4>&) const;

}  // namespace etendue
