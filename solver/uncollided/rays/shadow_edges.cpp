// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/rays/shadow_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace etendue {
namespace {

/// Sine of an angle below which surfaces continue straight, and up to which they bend but a little.
constexpr double straight_surface = 1e-6, hardly = 0.1;

/// A face that light notices, at one of its edges.
struct FaceAtEdge {
  std::array<std::int32_t, 2> ends;
  ShadowEdge::Surface surface;
};

bool is_between_media(const LightPaths& paths, CellIndex a, CellIndex b) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  if (mesh.region(a) == mesh.region(b)) return false;
  if (!paths.matter().empty()) return true;
  for (std::size_t band = 0; band < paths.bands(); ++band)
    if (paths.extinction(a, band) != paths.extinction(b, band)) return true;
  return false;
}

std::vector<FaceAtEdge> noticed_faces(const LightPaths& paths) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  std::vector<FaceAtEdge> faces;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const FaceIndex face(f);
    const bool on_wall = f < mesh.boundary_face_count();
    if (!on_wall && !is_between_media(paths, mesh.owner(face), mesh.neighbour(face))) continue;
    const bool mirrors = on_wall && paths.mirrors().of(face) >= 0;
    std::pair<int, int> regions(-1, -1);
    Vec3 normal = mesh.area_normal(face).normalized();
    if (!on_wall) {
      regions = std::minmax({mesh.region(mesh.owner(face)), mesh.region(mesh.neighbour(face))});
      if (mesh.region(mesh.owner(face)) == regions.second) normal = -normal;
    }
    const auto& v = mesh.vertices(face);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t first = v[i == 0 ? 1 : 0], last = v[i == 2 ? 1 : 2];
      const Vec3 from = mesh.point(VertexIndex(first));
      const Vec3 along = (mesh.point(VertexIndex(last)) - from).normalized();
      const Vec3 offset = mesh.point(VertexIndex(v[i])) - from;
      const Vec3 away = (offset - offset.dot(along) * along).normalized();
      faces.push_back({{first, last}, {normal, away, on_wall ? mesh.wall(face) : -1, regions, mirrors}});
    }
  }
  std::ranges::stable_sort(faces, {}, &FaceAtEdge::ends);
  return faces;
}

bool part_alike(const ShadowEdge::Surface& a, const ShadowEdge::Surface& b) {
  return a.wall == b.wall && a.regions == b.regions;
}

/// Returns whether each of the faces at an edge has one that continues it.
bool go_on(std::span<const FaceAtEdge> around, double bend) {
  return std::ranges::all_of(around, [&](const FaceAtEdge& face) {
    const ShadowEdge::Surface& here = face.surface;
    return std::ranges::any_of(around, [&](const FaceAtEdge& other) {
      const ShadowEdge::Surface& there = other.surface;
      return part_alike(here, there) && (there.away + here.away).norm() < bend &&
             (there.normal - here.normal).norm() < bend;
    });
  });
}

bool is_same(const ShadowEdge::Surface& a, const ShadowEdge::Surface& b) {
  return part_alike(a, b) && (a.normal - b.normal).norm() < straight_surface &&
         (a.away - b.away).norm() < straight_surface;
}

/// Shadow edge along one edge of the mesh, with its ends.
struct MeshShadowEdge {
  std::array<std::int32_t, 2> ends;
  ShadowEdge line;
};

std::vector<MeshShadowEdge> mesh_shadow_edges(const LightPaths& paths) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const std::vector<FaceAtEdge> faces = noticed_faces(paths);
  std::vector<MeshShadowEdge> edges;
  for (std::size_t first = 0, last = 0; first < faces.size(); first = last) {
    while (last < faces.size() && faces[last].ends == faces[first].ends) ++last;
    const std::span<const FaceAtEdge> around(&faces[first], last - first);
    if (go_on(around, straight_surface)) continue;
    const auto& ends = faces[first].ends;
    MeshShadowEdge edge{
        ends,
        {mesh.point(VertexIndex(ends[0])), mesh.point(VertexIndex(ends[1])), {}, go_on(around, hardly)}};
    for (const FaceAtEdge& face : around) edge.line.surfaces.push_back(face.surface);
    edges.push_back(std::move(edge));
  }
  return edges;
}

bool is_alike(const ShadowEdge& a, const ShadowEdge& b) {
  return a.blunt == b.blunt && a.surfaces.size() == b.surfaces.size() &&
         std::ranges::all_of(a.surfaces, [&](const ShadowEdge::Surface& surface) {
           return std::ranges::any_of(b.surfaces, [&](const auto& other) { return is_same(surface, other); });
         });
}

/// Joins edges that continue in one line.
class Lines {
 public:
  explicit Lines(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

 private:
  std::vector<std::size_t> parent_;
};

Vec3 direction_of(const ShadowEdge& edge) { return (edge.end - edge.begin).normalized(); }

void join_at_vertices(const std::vector<MeshShadowEdge>& edges, Lines& lines) {
  std::vector<std::pair<std::int32_t, std::size_t>> at_vertex;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const std::int32_t end : edges[i].ends) at_vertex.emplace_back(end, i);
  std::ranges::sort(at_vertex);
  for (std::size_t i = 0; i < at_vertex.size(); ++i)
    for (std::size_t j = i + 1; j < at_vertex.size() && at_vertex[j].first == at_vertex[i].first; ++j) {
      const ShadowEdge &a = edges[at_vertex[i].second].line, &b = edges[at_vertex[j].second].line;
      if (direction_of(a).cross(direction_of(b)).norm() < straight_surface && is_alike(a, b))
        lines.join(at_vertex[i].second, at_vertex[j].second);
    }
}

}  // namespace

std::vector<ShadowEdge> shadow_edges_of(const LightPaths& paths) {
  const std::vector<MeshShadowEdge> edges = mesh_shadow_edges(paths);
  Lines lines(edges.size());
  join_at_vertices(edges, lines);
  std::vector<ShadowEdge> shadow_edges;
  std::vector<std::size_t> number(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const ShadowEdge& edge = edges[i].line;
    if (lines.of(i) == i) {
      number[i] = shadow_edges.size();
      shadow_edges.push_back(edge);
      continue;
    }
    ShadowEdge& line = shadow_edges[number[lines.of(i)]];
    const Vec3 along = direction_of(line);
    for (const Vec3& end : {edge.begin, edge.end}) {
      if (along.dot(end - line.begin) < 0) line.begin = end;
      if (along.dot(end - line.end) > 0) line.end = end;
    }
  }
  return shadow_edges;
}

}  // namespace etendue
