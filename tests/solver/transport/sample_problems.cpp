// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/solver/transport/sample_problems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "solver/angular/sets/rotation.h"

namespace etendue {
namespace {

TetrahedralMesh meshed(const Geometry& geometry, double max_volume) {
  const SurfaceComplex surface = arrange(geometry);
  TetrahedraOptions options;
  options.max_volume.assign(surface.region_names.size(), max_volume);
  return TetrahedralMesh(tetrahedralize(surface, options));
}

/// Barycentric points and weights, exact to degree 4 (Keast 1986, 11 points).
struct RulePoint {
  std::array<double, 4> at;
  double weight;
};
std::vector<RulePoint> rule() {
  std::vector<RulePoint> points{{{0.25, 0.25, 0.25, 0.25}, -0.01315555555555555 * 6}};
  const double b = 1.0 / 14, a = 11.0 / 14;
  for (std::size_t i = 0; i < 4; ++i) {
    RulePoint p{{b, b, b, b}, 0.00762222222222222 * 6};
    p.at[i] = a;
    points.push_back(p);
  }
  const double c = (1 + std::sqrt(5.0 / 14)) / 4, d = (1 - std::sqrt(5.0 / 14)) / 4;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      RulePoint p{{d, d, d, d}, 0.02488888888888888 * 6};
      p.at[i] = p.at[j] = c;
      points.push_back(p);
    }
  return points;
}

}  // namespace

TetrahedralMesh cube_with_ball(double max_volume) {
  Geometry geometry;
  BoxPrimitive box;
  box.region = "domain";
  geometry.primitives.emplace_back(box);
  SpherePrimitive ball;
  ball.region = "ball";
  ball.center = Vec3(0.5, 0.5, 0.5);
  ball.radius = 0.3;
  ball.facets = 80;
  geometry.primitives.emplace_back(ball);
  return meshed(geometry, max_volume);
}

namespace {

/// Gives all cells the same orientation, as a mesher would.
TetrahedralMesh oriented(RawMesh raw) {
  for (auto& cell : raw.cells) {
    const auto at = [&](std::size_t i) { return raw.points[static_cast<std::size_t>(cell[i])]; };
    if ((at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) < 0) std::swap(cell[2], cell[3]);
  }
  raw.cell_regions.assign(raw.cells.size(), 0);
  raw.region_names = {"domain"};
  return TetrahedralMesh(raw);
}

}  // namespace

TetrahedralMesh moved_mesh(const TetrahedralMesh& mesh, const std::function<Vec3(const Vec3&)>& map) {
  RawMesh raw;
  for (const Vec3& point : mesh.points()) raw.points.push_back(map(point));
  for (const auto& cell : mesh.cell_vertices()) raw.cells.push_back({cell[0], cell[1], cell[2], cell[3]});
  return oriented(raw);
}

TetrahedralMesh random_cells(const TetrahedralMesh& mesh) {
  RawMesh raw;
  raw.points.assign(mesh.points().begin(), mesh.points().end());
  std::mt19937 random(1);
  for (const auto& cell : mesh.cell_vertices()) {
    const auto at = [&](std::size_t i) { return mesh.point(VertexIndex(cell[i])); };
    const bool turned = (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) < 0;
    raw.cells.push_back({cell[0], cell[1], cell[turned ? 3 : 2], cell[turned ? 2 : 3]});
    raw.cell_regions.push_back(static_cast<int>(random() % 2));
  }
  raw.region_names = {"domain", "ball"};
  return TetrahedralMesh(raw);
}

TetrahedralMesh mesh_with_image(const TetrahedralMesh& mesh) {
  RawMesh raw;
  raw.points.assign(mesh.points().begin(), mesh.points().end());
  std::vector<int> image;
  for (const Vec3& point : mesh.points()) {
    const bool shared = point.x() == 1;
    image.push_back(shared ? static_cast<int>(image.size()) : static_cast<int>(raw.points.size()));
    if (!shared) raw.points.emplace_back(2 - point.x(), point.y(), point.z());
  }
  for (const auto& cell : mesh.cell_vertices()) {
    raw.cells.push_back({cell[0], cell[1], cell[2], cell[3]});
    std::array<int, 4> mirrored{};
    for (std::size_t i = 0; i < 4; ++i) mirrored[i] = image[static_cast<std::size_t>(cell[i])];
    raw.cells.push_back(mirrored);
  }
  return oriented(raw);
}

Medium uniform_medium(int bands, double absorption, double scattering, double emission, PhaseFunction phase) {
  const auto count = static_cast<std::size_t>(bands);
  return {"domain",
          std::vector<Coefficient>(count, Coefficient(absorption)),
          std::vector<Coefficient>(count, Coefficient(scattering)),
          std::vector<Coefficient>(count, Coefficient(emission)),
          std::vector<PhaseFunction>(count, phase),
          {}};
}

Wall uniform_wall(int bands, double radiance, double diffuse, double specular) {
  const auto count = static_cast<std::size_t>(bands);
  return {"wall",
          std::vector<double>(count, radiance),
          std::vector<double>(count, diffuse),
          std::vector<double>(count, specular),
          {}};
}

Problem uniform_problem(const TetrahedralMesh& mesh, const Medium& medium, const Wall& wall) {
  const auto count = static_cast<int>(medium.absorption.size());
  Bands bands;
  bands.names.clear();
  for (int b = 0; b < count; ++b) bands.names.push_back("band" + std::to_string(b));
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    media.push_back(medium);
    media.back().name = name;
  }
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(wall);
    walls.back().name = name;
  }
  return Problem(mesh, bands, media, walls);
}

SolveOptions tight_options(Lumping lumping) {
  SolveOptions options;
  options.lumping = lumping;
  options.tolerance = 1e-12;
  options.max_sweeps = 2000;
  options.threads = 1;
  return options;
}

void ManufacturedInput::add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const {
  const auto& vertices = mesh_.vertices(cell);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t b = 0; b < static_cast<std::size_t>(bands_); ++b)
      values[i * static_cast<std::size_t>(bands_) + b] +=
          source_(mesh_.point(VertexIndex(vertices[i])), directions_.direction(m));
}

void ManufacturedInput::add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const {
  const auto& vertices = mesh_.vertices(face);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t b = 0; b < static_cast<std::size_t>(bands_); ++b)
      values[i * static_cast<std::size_t>(bands_) + b] +=
          radiance_(mesh_.point(VertexIndex(vertices[i])), directions_.direction(m));
}

double fluence_error(const TetrahedralMesh& mesh, const Solution& solution, int bands,
                     const std::function<double(const Vec3&)>& exact) {
  const std::vector<RulePoint> points = rule();
  double error = 0, norm = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    for (const RulePoint& p : points) {
      Vec3 at = Vec3::Zero();
      double value = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        at += p.at[i] * mesh.point(VertexIndex(mesh.vertices(cell)[i]));
        value += p.at[i] * solution.fluence[(cell.at() * 4 + i) * static_cast<std::size_t>(bands)];
      }
      const double expected = exact(at);
      error += p.weight * mesh.volume(cell) * (value - expected) * (value - expected);
      norm += p.weight * mesh.volume(cell) * expected * expected;
    }
  }
  return std::sqrt(error / norm);
}

std::function<double(const Vec3&)> exact_fluence(const DirectionSet& directions,
                                                 const ManufacturedInput::Field& radiance) {
  return [&directions, radiance](const Vec3& point) {
    double sum = 0;
    for (std::int32_t m = 0; m < directions.count(); ++m)
      sum += directions.weight(OrdinateIndex(m)) * radiance(point, directions.direction(OrdinateIndex(m)));
    return sum;
  };
}

std::vector<double> extinction_of(const Problem& problem) {
  std::vector<double> extinction(problem.absorption().begin(), problem.absorption().end());
  for (std::size_t i = 0; i < extinction.size(); ++i) extinction[i] += problem.scattering()[i];
  return extinction;
}

TetrahedralMesh cyclic_ring_about(const Vec3& direction) {
  return moved_mesh(cyclic_ring(), [&](const Vec3& p) -> Vec3 {
    return rotation_about(Vec3::UnitZ() + direction, 180) * p;
  });
}

double relative_difference(std::span<const double> a, std::span<const double> b) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    difference += std::pow(a[i] - b[i], 2);
    size += std::pow(b[i], 2);
  }
  return std::sqrt(difference / size);
}

double largest_deviation(const std::vector<double>& values, double expected) {
  double deviation = 0;
  for (const double value : values) deviation = std::max(deviation, std::abs(value / expected - 1));
  return deviation;
}

double difference(const Solution& a, const Solution& b, std::size_t bands, std::size_t band) {
  double error = 0, norm = 0;
  for (std::size_t i = band; i < a.fluence.size(); i += bands) {
    error += std::pow(a.fluence[i] - b.fluence[i], 2);
    norm += std::pow(b.fluence[i], 2);
  }
  return std::sqrt(error / norm);
}

}  // namespace etendue
