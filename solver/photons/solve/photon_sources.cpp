// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/solve/photon_sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/tetrahedra/corners.h"
#include "solver/photons/kernel/photon_turns.h"
#include "solver/problem/lights/beam_pieces.h"
#include "solver/problem/lights/lamp_shape.h"
#include "solver/problem/mirror.h"

namespace etendue {
namespace {

using std::numbers::pi;
using Triangle = EmittingTriangle;

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
  const std::array<Vec3, 4> corner = corners_of(mesh, cell);
  return (1 - s - t - u) * corner[0] + s * corner[1] + t * corner[2] + u * corner[3];
}

/// A bound of the relative irradiance on a triangle.
double largest_on(const BeamProfile& profile, const std::array<Vec3, 3>& triangle) {
  const Vec3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3;
  double reach = 0;
  for (const Vec3& corner : triangle)
    reach = std::max(reach, distance_from_axis(profile, profile.center + corner - middle));
  const double nearest = std::max(0.0, distance_from_axis(profile, middle) - reach);
  return profile.shape == BeamProfile::Shape::gaussian ? std::exp(-2 * nearest * nearest) : 1;
}

Triangle triangle_of(const SurfaceLight& light, std::int32_t part) {
  const auto first = 3 * static_cast<std::size_t>(part);
  return {{light.triangles[first], light.triangles[first + 1], light.triangles[first + 2]}};
}

/// An azimuth of a lamp at an angle from its axis, by rejection: as likely as the lamp is bright there.
template <class Draw>
double draw_azimuth(const PointLight& light, double angle, Draw&& number) {
  double brightest = 0;
  for (const double plane : light.plane) brightest = std::max(brightest, lamp_shape(light, angle, plane));
  while (true) {
    const double azimuth = light.plane.front() + number() * (light.plane.back() - light.plane.front());
    if (number() * brightest <= lamp_shape(light, angle, azimuth)) return azimuth;
  }
}

/// A point of a simplex as likely as its barycentric coordinate number `corner` is large: gamma variables
/// over their sum (Dirichlet's distribution; Devroye 1986, section XI.4).
template <std::size_t count>
std::array<double, count> point_towards(std::size_t corner, DrawnNumbers& random) {
  std::array<double, count> shares;
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    shares[i] = -std::log(random.number() * (i == corner ? random.number() : 1.0));
    sum += shares[i];
  }
  for (double& share : shares) share /= sum;
  return shares;
}

Vec3 vector_of(const double (&values)[3]) { return {values[0], values[1], values[2]}; }

}  // namespace

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
  const TetrahedralMesh& mesh = problem_.mesh();
  const double range = full_range(problem_.space());
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const CellEmission& emission = problem_.cell_emission();
    if (emission.varies_in(cell))
      for (std::int32_t i = 0; i < 4; ++i)
        add({Kind::cell_vertex, c, i},
            range * emission.at(cell, band_, static_cast<std::size_t>(i)) * mesh.volume(cell) / 4);
    else
      add({Kind::cell, c, 0}, range * emission.mean(cell, band_) * mesh.volume(cell));
    const FormulaEmitter* emitter = mesh_.emitter(mesh.region(cell));
    for (std::int32_t i = 0; i < 4 && emitter != nullptr; ++i)
      add({Kind::cell_corner, c, i},
          mesh.volume(cell) / 4 * emitter->node(cell, static_cast<std::size_t>(i)).integral);
  }
}

void PhotonSources::add_walls() {
  const TetrahedralMesh& mesh = problem_.mesh();
  const double range = half_range(problem_.space());
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const Wall& wall = problem_.wall(mesh.wall(face));
    add({Kind::face, f, 0}, range * wall.radiance[band_] * entering_part(wall) * mesh.area(face));
    const FormulaEmitter* sent = mesh_.faces()[face.at()].sent;
    for (std::int32_t i = 0; i < 3 && sent != nullptr; ++i)
      add({Kind::face_corner, f, i},
          mesh.area(face) / 3 * sent->node(face, static_cast<std::size_t>(i)).integral);
  }
}

void PhotonSources::add_lights() {
  const TetrahedralMesh& mesh = problem_.mesh();
  angles_.resize(problem_.lights().size());
  cones_.resize(problem_.lights().size());
  for (std::size_t i = 0; i < problem_.lights().size(); ++i) {
    const auto& kind = problem_.lights()[i].kind;
    const auto index = static_cast<std::int32_t>(i);
    if (const auto* point = std::get_if<PointLight>(&kind)) {
      angles_[i] = AngleTable(point->angle, lamp_shape_about_axis(*point));
      cones_[i] = TangentCone(mesh, locator_.find(point->position));
      add({Kind::point, index, 0}, point->power[band_]);
    } else if (const auto* beam = std::get_if<BeamLight>(&kind)) {
      for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
        if (std::ranges::count(beam->walls, mesh.wall(FaceIndex(f))) == 0) continue;
        if (beam->profile)
          add_beam_pieces(*beam, index, f);
        else
          add({Kind::beam, index, f},
              beam->irradiance[band_] * -beam->direction.dot(mesh.area_normal(FaceIndex(f))));
      }
    } else {
      const auto& surface = std::get<SurfaceLight>(kind);
      for (std::int32_t t = 0; 3 * static_cast<std::size_t>(t) < surface.triangles.size(); ++t) {
        const auto [a, b, c] = triangle_of(surface, t).corner;
        add({Kind::triangle, index, t}, pi * surface.radiance[band_] * (b - a).cross(c - a).norm() / 2);
      }
    }
  }
}

void PhotonSources::add_beam_pieces(const BeamLight& beam, std::int32_t light, std::int32_t face) {
  const TetrahedralMesh& mesh = problem_.mesh();
  const double cosine = -beam.direction.dot(mesh.area_normal(FaceIndex(face))) / mesh.area(FaceIndex(face));
  for (const std::array<Vec3, 3>& piece : beam_pieces(*beam.profile, corners_of(mesh, FaceIndex(face)))) {
    const auto& [a, b, c] = piece;
    const double area = (b - a).cross(c - a).norm() / 2;
    add({Kind::beam_piece, light, static_cast<std::int32_t>(beam_pieces_.size())},
        beam.irradiance[band_] * cosine * area * mean_profile(*beam.profile, piece));
    beam_pieces_.push_back({face, {piece}, largest_on(*beam.profile, piece)});
  }
}

Vec3 PhotonSources::isotropic(DrawnNumbers& random) const {
  double c, s;
  unit_circle(random.word(), c, s);
  if (in_plane_) return {c, s, 0};
  const double mu = 2 * random.number() - 1, sine = std::sqrt(1 - mu * mu);
  return {sine * c, sine * s, mu};
}

Vec3 PhotonSources::lambert(const Vec3& normal, const Vec3& tangent, DrawnNumbers& random) const {
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
    const double path_length = mesh_.distance_through(place.cell, point, direction);
    if (path_length <= longest) continue;
    longest = path_length;
    start.cell = place.cell.value();
  }
}

PhotonStart PhotonSources::started(const Vec3& point, const Vec3& direction) const {
  PhotonStart start{{}, {}, 1, 0, -1};
  std::copy(point.begin(), point.end(), start.position);
  std::copy(direction.begin(), direction.end(), start.direction);
  return start;
}

PhotonStart PhotonSources::from_cell(std::int32_t cell, DrawnNumbers& random) const {
  const double s = random.number(), t = random.number(), u = random.number();
  const Vec3 point = point_in(problem_.mesh(), CellIndex(cell), s, t, u);
  PhotonStart start = started(point, isotropic(random));
  start.cell = cell;
  return start;
}

// Linear emission is the sum of that of the vertices, which falls linearly to the face across.
PhotonStart PhotonSources::from_cell_vertex(std::int32_t number, std::size_t vertex,
                                            DrawnNumbers& random) const {
  PhotonStart start = started(point_towards_vertex(number, vertex, random), isotropic(random));
  start.cell = number;
  return start;
}

Vec3 PhotonSources::point_towards_vertex(std::int32_t cell, std::size_t vertex, DrawnNumbers& random) const {
  const auto shares = point_towards<4>(vertex, random);
  Vec3 point = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) point += shares[i] * corner_of(problem_.mesh(), CellIndex(cell), i);
  return point;
}

PhotonStart PhotonSources::from_beam_piece(const BeamLight& beam, const BeamPiece& piece,
                                           DrawnNumbers& random) const {
  const PhotonFace& face = mesh_.faces()[static_cast<std::size_t>(piece.face)];
  Vec3 point;
  do {
    const double u = random.number(), v = random.number();
    point = point_in(piece.triangle, u, v);
  } while (random.number() * piece.largest > relative_irradiance(*beam.profile, point));
  PhotonStart start = started(point, beam.direction);
  start.cell = face.cell;
  start.entered = face.local;
  return start;
}

PhotonStart PhotonSources::from_face(std::int32_t f, const Vec3* beam, DrawnNumbers& random) const {
  const PhotonFace& face = mesh_.faces()[static_cast<std::size_t>(f)];
  const double u = random.number(), v = random.number();
  const Vec3 point = point_in({corners_of(problem_.mesh(), FaceIndex(f))}, u, v);
  const auto direction = [&] {
    return face.refractive_index != 1 ? refracted_in(face, random)
                                      : lambert(vector_of(face.normal), vector_of(face.tangent), random);
  };
  PhotonStart start = started(point, beam != nullptr ? *beam : direction());
  start.cell = face.cell;
  start.entered = face.local;
  return start;
}

/// Behind the wall light falls on it from all sides alike; what the surface turns back there is drawn anew.
Vec3 PhotonSources::refracted_in(const PhotonFace& face, DrawnNumbers& random) const {
  const double index = face.refractive_index;
  const Vec3 normal = vector_of(face.normal);
  while (true) {
    const Vec3 behind = lambert(normal, vector_of(face.tangent), random);
    const double cosine = behind.dot(normal);
    if (random.number() < fresnel_reflectance(cosine, 1 / index)) continue;
    const double inside = std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (index * index)));
    return (behind / index + (inside - cosine / index) * normal).normalized();
  }
}

PhotonStart PhotonSources::from_cell_corner(std::int32_t number, std::size_t corner,
                                            DrawnNumbers& random) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const CellIndex cell(number);
  const FormulaEmitter& emitter = *mesh_.emitter(mesh.region(cell));
  const Vec3 point = point_towards_vertex(number, corner, random);
  Vec3 direction;
  do direction = isotropic(random);
  while (random.number() * emitter.node(cell, corner).largest >= emitter.at_corner(cell, corner, direction));
  PhotonStart start = started(point, direction);
  start.cell = number;
  return start;
}

PhotonStart PhotonSources::from_face_corner(std::int32_t number, std::size_t corner,
                                            DrawnNumbers& random) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const FaceIndex index(number);
  const PhotonFace& face = mesh_.faces()[index.at()];
  const auto shares = point_towards<3>(corner, random);
  Vec3 point = Vec3::Zero(), direction;
  for (std::size_t i = 0; i < 3; ++i) point += shares[i] * corner_of(mesh, index, i);
  do direction = lambert(vector_of(face.normal), vector_of(face.tangent), random);
  while (random.number() * face.sent->node(index, corner).largest >=
         face.sent->at_corner(index, corner, direction));
  PhotonStart start = started(point, direction);
  start.cell = face.cell;
  start.entered = face.local;
  return start;
}

Vec3 PhotonSources::direction_of(const PointLight& light, const AngleTable& angles,
                                 DrawnNumbers& random) const {
  if (angles.empty()) return isotropic(random);
  const double angle = angles.draw(random.number());
  if (light.plane.empty()) {
    double c, s, turned[3] = {light.axis.x(), light.axis.y(), light.axis.z()};
    unit_circle(random.word(), c, s);
    turn(turned, std::cos(angle), c, s);
    return vector_of(turned);
  }
  const double azimuth = draw_azimuth(light, angle, [&] { return random.number(); });
  return std::cos(angle) * light.axis +
         std::sin(angle) * (std::cos(azimuth) * light.zero_plane + std::sin(azimuth) * light.quarter_plane);
}

// A lamp on a wall sends all of its power into the domain.
PhotonStart PhotonSources::from_point(std::int32_t index, DrawnNumbers& random) const {
  const auto number = static_cast<std::size_t>(index);
  const auto& light = std::get<PointLight>(problem_.lights()[number].kind);
  Vec3 direction;
  do direction = direction_of(light, angles_[number], random);
  while (!cones_[number].contains(direction));
  PhotonStart start = started(light.position, direction);
  start_inside(light.position, direction, start);
  return start;
}

PhotonStart PhotonSources::from_surface(const Triangle& triangle, DrawnNumbers& random) const {
  const double u = random.number(), v = random.number();
  const Vec3 point = point_in(triangle, u, v);
  const auto& [a, b, c] = triangle.corner;
  const Vec3 normal = (b - a).cross(c - a).normalized();
  const Vec3 direction = lambert(normal, normal.unitOrthogonal(), random);
  PhotonStart start = started(point, direction);
  start_inside(point, direction, start);
  return start;
}

PhotonStart PhotonSources::start_of(const Source& source, DrawnNumbers& random) const {
  const auto light = [&]() -> const Light& {
    return problem_.lights()[static_cast<std::size_t>(source.index)];
  };
  switch (source.kind) {
    case Kind::cell:
      return from_cell(source.index, random);
    case Kind::face:
      return from_face(source.index, nullptr, random);
    case Kind::beam:
      return from_face(source.part, &std::get<BeamLight>(light().kind).direction, random);
    case Kind::beam_piece:
      return from_beam_piece(std::get<BeamLight>(light().kind),
                             beam_pieces_[static_cast<std::size_t>(source.part)], random);
    case Kind::point:
      return from_point(source.index, random);
    case Kind::cell_vertex:
      return from_cell_vertex(source.index, static_cast<std::size_t>(source.part), random);
    case Kind::cell_corner:
      return from_cell_corner(source.index, static_cast<std::size_t>(source.part), random);
    case Kind::face_corner:
      return from_face_corner(source.index, static_cast<std::size_t>(source.part), random);
    case Kind::triangle:
      break;
  }
  return from_surface(triangle_of(std::get<SurfaceLight>(light().kind), source.part), random);
}

std::vector<PhotonStart> PhotonSources::starts(std::uint64_t seed, const Batch& batch, std::size_t from,
                                               std::size_t count) const {
  std::vector<PhotonStart> starts;
  starts.reserve(count);
  for (std::size_t i = from; i < from + count; ++i) {
    RandomStream stream(seed, batch.first + i, RandomUse::emission);
    DrawnNumbers random(stream);
    const double share = (static_cast<double>(i) + random.number()) / static_cast<double>(batch.count);
    const auto above = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, share * power());
    starts.push_back(start_of(sources_[static_cast<std::size_t>(above - cumulative_.begin())], random));
  }
  return starts;
}

}  // namespace etendue
