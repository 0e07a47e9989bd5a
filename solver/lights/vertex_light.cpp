// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/vertex_light.h"

#include <algorithm>
#include <cmath>

#include "solver/lights/simplex_rules.h"

namespace etendue {
namespace {

/// Cells that are nearer to the light than this many of their sizes are looked at point by point.
constexpr double near_in_sizes = 1.5;
/// A volume's light is looked at so only in cells that are thicker than this.
constexpr double thin = 1;

std::vector<CellIndex> cells_of_vertices(const TetrahedralMesh& mesh) {
  std::vector<CellIndex> cells(static_cast<std::size_t>(mesh.vertex_count()), CellIndex(0));
  for (std::int32_t c = mesh.cell_count() - 1; c >= 0; --c)
    for (const std::int32_t v : mesh.vertices(CellIndex(c)))
      cells[static_cast<std::size_t>(v)] = CellIndex(c);
  return cells;
}

/// 1 in the middle of a cell and 0 at its vertices.
double bulge_at(const std::array<double, 4>& barycentric) {
  double squares = 0;
  for (const double value : barycentric) squares += value * value;
  return 4. / 3 * (1 - squares);
}

/// A mirror that a vertex lies on.
struct MirrorHere {
  Vec3 normal;
  std::vector<double>* cosine;  ///< [band] where the mean cosine to it is kept
};

void add_up(const LightBeams& beams, std::span<double> fluence) {
  std::fill(fluence.begin(), fluence.end(), 0.0);
  for (std::size_t i = 0; i < beams.size(); ++i)
    for (std::size_t b = 0; b < fluence.size(); ++b) fluence[b] += beams.fluence(i)[b];
}

}  // namespace

VertexLight::VertexLight(const LightPaths& paths, const LightSource& source, int threads)
    : paths_(paths), source_(source), bands_(paths.bands()) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const std::vector<CellIndex> cells = cells_of_vertices(mesh);
  log_transmittance_.resize(cells.size() * bands_);
  mean_direction_.assign(cells.size() * bands_, Vec3::Zero());
  std::vector<std::vector<MirrorHere>> mirrors(cells.size());
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (const int plane = paths.mirrors().of(FaceIndex(f)); plane >= 0)
      for (const std::int32_t v : mesh.vertices(FaceIndex(f))) {
        const auto [place, is_new] = mean_cosine_.try_emplace({v, plane}, bands_, 0.0);
        if (is_new)
          mirrors[static_cast<std::size_t>(v)].push_back(
              {mesh.area_normal(FaceIndex(f)).normalized(), &place->second});
      }
#pragma omp parallel num_threads(threads)
  {
    LightBeams beams(bands_);
    std::vector<double> clear(bands_), seen(bands_);
#pragma omp for schedule(dynamic, 64)
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      const PointInCell here{cells[static_cast<std::size_t>(v)], mesh.point(VertexIndex(v))};
      beams.clear();
      source.add_beams(here, Sight::clear, coarse_light, beams);
      add_up(beams, clear);
      beams.clear();
      source.add_beams(here, Sight::attenuated, coarse_light, beams);
      add_up(beams, seen);
      for (std::size_t b = 0; b < bands_; ++b) {
        log_transmittance_[at(v, b)] = clear[b] > 0 ? std::log(seen[b] / clear[b]) : 0;
        for (std::size_t i = 0; i < beams.size() && seen[b] > 0; ++i)
          mean_direction_[at(v, b)] += beams.fluence(i)[b] / seen[b] * beams.direction(i);
        for (const MirrorHere& mirror : mirrors[static_cast<std::size_t>(v)])
          for (std::size_t i = 0; i < beams.size() && seen[b] > 0; ++i)
            (*mirror.cosine)[b] +=
                beams.fluence(i)[b] / seen[b] * std::abs(beams.direction(i).dot(mirror.normal));
      }
    }
  }
}

bool VertexLight::is_lit(std::span<const std::int32_t> vertices) const {
  for (const std::int32_t v : vertices)
    for (std::size_t b = 0; b < bands_; ++b)
      if (!std::isfinite(log_transmittance_[at(v, b)])) return false;
  return true;
}

std::vector<VertexLight::LightHere> VertexLight::look(const PointInCell& here,
                                                      std::span<const double> barycentric,
                                                      std::span<const std::int32_t> vertices,
                                                      LightBeams& beams) const {
  beams.clear();
  source_.add_beams(here, Sight::clear, coarse_light, beams);
  std::vector<double> clear(bands_);
  add_up(beams, clear);
  std::vector<LightHere> light(bands_);
  for (std::size_t b = 0; b < bands_; ++b) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      light[b].direction += barycentric[i] * mean_direction_[at(vertices[i], b)];
    light[b].fluence = clear[b] * std::exp(log_transmittance(barycentric, vertices, b));
  }
  return light;
}

double VertexLight::log_transmittance(std::span<const double> barycentric,
                                      std::span<const std::int32_t> vertices, std::size_t band) const {
  double sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    sum += barycentric[i] * log_transmittance_[at(vertices[i], band)];
  return sum;
}

bool VertexLight::is_too_near(const Vec3& place, double size, double thickness) const {
  return (!source_.is_smooth_over(size) || thickness > thin) && source_.is_near(place, near_in_sizes * size);
}

void VertexLight::look_at_middle(const LitCell& cell, LightBeams& beams, Bulge& bulge) const {
  constexpr std::array<double, 4> middle = {0.25, 0.25, 0.25, 0.25};
  const auto& vertices = paths_.problem().mesh().vertices(cell.index);
  std::vector<double> clear(bands_), seen(bands_);
  beams.clear();
  source_.add_beams({cell.index, cell.centroid}, Sight::clear, coarse_light, beams);
  add_up(beams, clear);
  beams.clear();
  source_.add_beams({cell.index, cell.centroid}, Sight::attenuated, coarse_light, beams);
  add_up(beams, seen);
  bulge = {std::vector<double>(bands_, 0), std::vector<Vec3>(bands_, Vec3::Zero())};
  for (std::size_t b = 0; b < bands_; ++b) {
    if (!(seen[b] > 0)) continue;
    bulge.log_transmittance[b] = std::log(seen[b] / clear[b]) - log_transmittance(middle, vertices, b);
    for (std::size_t i = 0; i < beams.size(); ++i)
      bulge.direction[b] += beams.fluence(i)[b] / seen[b] * beams.direction(i);
    for (const std::int32_t v : vertices) bulge.direction[b] -= mean_direction_[at(v, b)] / 4;
  }
}

bool VertexLight::add(const LitCell& cell, LightBeams& beams, NodalMoments& moments) const {
  if (is_too_near(cell.centroid, cell.size, cell.thickness)) return false;
  const auto& vertices = paths_.problem().mesh().vertices(cell.index);
  if (!is_lit(vertices)) return false;
  const bool near = source_.is_near(cell.centroid, near_in_sizes * cell.size);
  Bulge bulge;
  if (near) look_at_middle(cell, beams, bulge);
  for (const CellPointWeight& point : four_point_rule()) {
    const PointInCell here{cell.index, cell.position(point.barycentric)};
    std::vector<LightHere> light = look(here, point.barycentric, vertices, beams);
    for (std::size_t b = 0; near && b < bands_; ++b) {
      const double part = bulge_at(point.barycentric);
      light[b].fluence *= std::exp(part * bulge.log_transmittance[b]);
      light[b].direction += part * bulge.direction[b];
    }
    for (std::size_t b = 0; b < bands_; ++b)
      for (std::size_t i = 0; i < 4; ++i) {
        const double value = point.barycentric[i] * point.weight * cell.volume * light[b].fluence;
        moments.at(i, 0, b) += value;
        for (std::size_t axis = 0; axis < 3; ++axis)
          moments.at(i, 1 + axis, b) += value * light[b].direction[static_cast<Eigen::Index>(axis)];
      }
  }
  return true;
}

// Where no mirror sends light back, all of it travels out of the domain: E = F.n.
bool VertexLight::add(FaceIndex face, LightBeams& beams, NodalMoments& moments) const {
  const TetrahedralMesh& mesh = paths_.problem().mesh();
  const double area = mesh.area(face), size = std::sqrt(2 * area);
  const double thickness = size * paths_.largest_extinction(mesh.owner(face));
  if (is_too_near(mesh.centroid(face), size, thickness) || !is_lit(mesh.vertices(face))) return false;
  if (paths_.mirrors().of(face) >= 0) {
    add_to_mirror(face, beams, moments);
    return true;
  }
  const Vec3 normal = mesh.area_normal(face) / area;
  const auto& vertices = mesh.vertices(face);
  for (const FacePointWeight& point : three_point_rule()) {
    Vec3 position = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      position += point.barycentric[i] * mesh.point(VertexIndex(vertices[i]));
    const std::vector<LightHere> light =
        look({mesh.owner(face), position}, point.barycentric, vertices, beams);
    for (std::size_t b = 0; b < bands_; ++b)
      for (std::size_t i = 0; i < 3; ++i)
        moments.at(i, 0, b) += point.barycentric[i] * point.weight * area * light[b].fluence *
                               std::max(0.0, light[b].direction.dot(normal));
  }
  return true;
}

// On a mirror each beam that arrives goes on with the part r of its fluence: E = sum of phi |w.n| / (1 + r).
void VertexLight::add_to_mirror(FaceIndex face, LightBeams& beams, NodalMoments& moments) const {
  const TetrahedralMesh& mesh = paths_.problem().mesh();
  const double area = mesh.area(face);
  const int plane = paths_.mirrors().of(face);
  const std::vector<double>& reflected = paths_.problem().wall(mesh.wall(face)).specular;
  const auto& vertices = mesh.vertices(face);
  for (const FacePointWeight& point : three_point_rule()) {
    Vec3 position = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      position += point.barycentric[i] * mesh.point(VertexIndex(vertices[i]));
    const std::vector<LightHere> light =
        look({mesh.owner(face), position}, point.barycentric, vertices, beams);
    for (std::size_t b = 0; b < bands_; ++b) {
      double cosine = 0;
      for (std::size_t i = 0; i < 3; ++i)
        cosine += point.barycentric[i] * mean_cosine_.at({vertices[i], plane})[b];
      const double irradiance = light[b].fluence * cosine / (1 + reflected[b]);
      for (std::size_t i = 0; i < 3; ++i)
        moments.at(i, 0, b) += point.barycentric[i] * point.weight * area * irradiance;
    }
  }
}

}  // namespace etendue
