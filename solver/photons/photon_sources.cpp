// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/photon_sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/photons/photon_turns.h"

namespace etendue {
namespace {

using std::numbers::pi;

struct Triangle {
  std::array<Vec3, 3> corner;
};

Triangle triangle_of(const TetrahedralMesh& mesh, FaceIndex face) {
  const auto& v = mesh.vertices(face);
  return {{mesh.point(VertexIndex(v[0])), mesh.point(VertexIndex(v[1])), mesh.point(VertexIndex(v[2]))}};
}

/// Uniform over a triangle (Turk 1990).
Vec3 point_in(const Triangle& triangle, double u, double v) {
  const double root = std::sqrt(u);
  return (1 - root) * triangle.corner[0] + root * (1 - v) * triangle.corner[1] +
         root * v * triangle.corner[2];
}

/// Uniform over a tetrahedron: the cube is folded into it (Rocchini and Cignoni 2000).
Vec3 point_in(const TetrahedralMesh& mesh, CellIndex cell, double s, double t, double u) {
  if (s + t > 1) {
    s = 1 - s;
    t = 1 - t;
  }
  if (t + u > 1) {
    const double old = u;
    u = 1 - s - t;
    t = 1 - old;
  } else if (s + t + u > 1) {
    const double old = u;
    u = s + t + u - 1;
    s = 1 - t - old;
  }
  const auto& v = mesh.vertices(cell);
  const auto point = [&](std::size_t i) -> const Vec3& { return mesh.point(VertexIndex(v[i])); };
  return (1 - s - t - u) * point(0) + s * point(1) + t * point(2) + u * point(3);
}

Triangle triangle_of(const SurfaceLight& light, std::int32_t part) {
  const auto first = 3 * static_cast<std::size_t>(part);
  return {{light.triangles[first], light.triangles[first + 1], light.triangles[first + 2]}};
}

Vec3 vector_of(const double (&values)[3]) { return {values[0], values[1], values[2]}; }

}  // namespace

/// The random numbers of one start, one after the other.
class PhotonSources::Numbers {
 public:
  Numbers(std::uint64_t seed, std::uint64_t history) : stream_(seed, history, RandomUse::emission) {}
  std::uint32_t word() {
    if (used_ == 4) {
      stream_.next(words_);
      used_ = 0;
    }
    return words_[used_++];
  }
  double number() { return uniform(word()); }

 private:
  RandomStream stream_;
  std::uint32_t words_[4];
  int used_ = 4;
};

PhotonSources::PhotonSources(const Problem& problem, const PhotonMesh& mesh, const CellLocator& locator,
                             int band)
    : problem_(problem),
      mesh_(mesh),
      locator_(locator),
      band_(static_cast<std::size_t>(band)),
      in_plane_(problem.space() == AngularSpace::plane) {
  add_media();
  add_walls();
  add_lights();
}

void PhotonSources::add(Source source, double power) {
  if (!(power > 0)) return;
  sources_.push_back(source);
  cumulative_.push_back(this->power() + power);
}

void PhotonSources::add_media() {
  const double range = full_range(problem_.space());
  for (std::int32_t c = 0; c < problem_.mesh().cell_count(); ++c)
    add({Kind::cell, c, 0},
        range * mesh_.cells()[static_cast<std::size_t>(c)].emission * problem_.mesh().volume(CellIndex(c)));
}

void PhotonSources::add_walls() {
  const double range = half_range(problem_.space());
  for (std::int32_t f = 0; f < problem_.mesh().boundary_face_count(); ++f)
    add({Kind::face, f, 0},
        range * mesh_.faces()[static_cast<std::size_t>(f)].radiance * problem_.mesh().area(FaceIndex(f)));
}

void PhotonSources::add_lights() {
  const TetrahedralMesh& mesh = problem_.mesh();
  angles_.resize(problem_.lights().size());
  for (std::size_t i = 0; i < problem_.lights().size(); ++i) {
    const auto& kind = problem_.lights()[i].kind;
    const auto index = static_cast<std::int32_t>(i);
    if (const auto* point = std::get_if<PointLight>(&kind)) {
      angles_[i] = AngleTable(point->angle, point->intensity);
      add({Kind::point, index, 0}, point->power[band_]);
    } else if (const auto* beam = std::get_if<BeamLight>(&kind)) {
      for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
        if (std::ranges::count(beam->walls, mesh.wall(FaceIndex(f))) > 0)
          add({Kind::beam, index, f},
              beam->irradiance[band_] * -beam->direction.dot(mesh.area_normal(FaceIndex(f))));
    } else {
      const auto& surface = std::get<SurfaceLight>(kind);
      for (std::int32_t t = 0; 3 * static_cast<std::size_t>(t) < surface.triangles.size(); ++t) {
        const auto [a, b, c] = triangle_of(surface, t).corner;
        add({Kind::triangle, index, t}, pi * surface.radiance[band_] * (b - a).cross(c - a).norm() / 2);
      }
    }
  }
}

Vec3 PhotonSources::isotropic(Numbers& random) const {
  double c, s;
  unit_circle(random.word(), c, s);
  if (in_plane_) return {c, s, 0};
  const double mu = 2 * random.number() - 1, sine = std::sqrt(1 - mu * mu);
  return {sine * c, sine * s, mu};
}

Vec3 PhotonSources::lambert(const Vec3& normal, const Vec3& tangent, Numbers& random) const {
  if (in_plane_) {
    const double along = 2 * random.number() - 1;
    return std::sqrt(1 - along * along) * normal + along * tangent;
  }
  double c, s;
  unit_circle(random.word(), c, s);
  double w[3] = {normal.x(), normal.y(), normal.z()};
  turn(w, std::sqrt(random.number()), c, s);
  return vector_of(w);
}

void PhotonSources::start_inside(const Vec3& point, const Vec3& direction, PhotonStart& start) const {
  double longest = -HUGE_VAL;
  for (const CellPoint& place : locator_.find(point)) {
    const double way = mesh_.way_through(place.cell, point, direction);
    if (way <= longest) continue;
    longest = way;
    start.cell = place.cell.value();
  }
}

PhotonStart PhotonSources::start_of(const Source& source, Numbers& random) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  PhotonStart start{{}, {}, 1, 0, -1};
  Vec3 x, w;
  const auto from_face = [&](std::int32_t f) -> const PhotonFace& {
    const PhotonFace& face = mesh_.faces()[static_cast<std::size_t>(f)];
    const double u = random.number(), v = random.number();
    x = point_in(triangle_of(mesh, FaceIndex(f)), u, v);
    start.cell = face.cell;
    start.entered = face.local;
    return face;
  };
  switch (source.kind) {
    case Kind::cell: {
      const double s = random.number(), t = random.number(), u = random.number();
      x = point_in(mesh, CellIndex(source.index), s, t, u);
      w = isotropic(random);
      start.cell = source.index;
      break;
    }
    case Kind::face: {
      const PhotonFace& face = from_face(source.index);
      w = lambert(vector_of(face.normal), vector_of(face.tangent), random);
      break;
    }
    case Kind::beam:
      from_face(source.part);
      w = std::get<BeamLight>(problem_.lights()[static_cast<std::size_t>(source.index)].kind).direction;
      break;
    case Kind::point: {
      const auto i = static_cast<std::size_t>(source.index);
      const auto& light = std::get<PointLight>(problem_.lights()[i].kind);
      x = light.position;
      w = light.axis;
      if (angles_[i].empty()) {
        w = isotropic(random);
      } else {
        double c, s, turned[3] = {w.x(), w.y(), w.z()};
        unit_circle(random.word(), c, s);
        turn(turned, std::cos(angles_[i].draw(random.number())), c, s);
        w = vector_of(turned);
      }
      start_inside(x, w, start);
      break;
    }
    case Kind::triangle: {
      const auto& light =
          std::get<SurfaceLight>(problem_.lights()[static_cast<std::size_t>(source.index)].kind);
      const Triangle triangle = triangle_of(light, source.part);
      const double u = random.number(), v = random.number();
      x = point_in(triangle, u, v);
      const auto& [a, b, c] = triangle.corner;
      const Vec3 normal = (b - a).cross(c - a).normalized();
      w = lambert(normal, normal.unitOrthogonal(), random);
      start_inside(x, w, start);
      break;
    }
  }
  std::copy(x.begin(), x.end(), start.position);
  std::copy(w.begin(), w.end(), start.direction);
  return start;
}

std::vector<PhotonStart> PhotonSources::starts(std::uint64_t seed, const Batch& batch, std::size_t from,
                                               std::size_t count) const {
  std::vector<PhotonStart> starts;
  starts.reserve(count);
  for (std::size_t i = from; i < from + count; ++i) {
    Numbers random(seed, batch.first + i);
    const double share = (static_cast<double>(i) + random.number()) / static_cast<double>(batch.count);
    const auto above = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, share * power());
    starts.push_back(start_of(sources_[static_cast<std::size_t>(above - cumulative_.begin())], random));
  }
  return starts;
}

}  // namespace etendue
