// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/projection/uncollided_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/angular/sets/rotation.h"
#include "solver/uncollided/lights/light_setup.h"
#include "solver/uncollided/sources/beam_source.h"
#include "solver/uncollided/sources/point_source.h"
#include "tests/solver/transport/sample_problems.h"
#include "tests/solver/uncollided/visible_part.h"

namespace etendue::uncollided_field_test {
namespace {

using std::numbers::pi;

LightSources shining(const PointLight& light, const LightPaths& paths) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  LightSources sources;
  sources.push_back(std::make_unique<PointSource>(
      "lamp", light, TangentCone(mesh, CellLocator(mesh).find(light.position)), paths));
  return sources;
}

LightSources point_at(const Vec3& position, const LightPaths& paths) {
  PointLight light;
  light.position = position;
  light.power = {1};
  return shining(light, paths);
}

LightSources sun(const Vec3& direction, int wall, const LightPaths& paths) {
  LightSources sources;
  sources.push_back(std::make_unique<BeamSource>("sun", BeamLight{direction, {1}, {wall}}, paths));
  return sources;
}

double integral_over_cells(const TetrahedralMesh& mesh, const std::vector<double>& fluence) {
  double sum = 0;
  for (std::size_t i = 0; i < fluence.size(); ++i) sum += fluence[i] * mesh.volumes()[i / 4] / 4;
  return sum;
}

double integral_over_walls(const TetrahedralMesh& mesh, const std::vector<double>& irradiance) {
  double sum = 0;
  for (std::size_t i = 0; i < irradiance.size(); ++i)
    sum += irradiance[i] * mesh.area(FaceIndex(static_cast<std::int64_t>(i / 3))) / 3;
  return sum;
}

int wall_of(const TetrahedralMesh& mesh, const std::string& name) {
  return static_cast<int>(std::find(mesh.wall_names().begin(), mesh.wall_names().end(), name) -
                          mesh.wall_names().begin());
}

double fluence_at(const TetrahedralMesh& mesh, const std::vector<double>& fluence, const Vec3& point) {
  const CellPoint at = CellLocator(mesh).find(point)[0];
  double value = 0;
  for (std::size_t i = 0; i < 4; ++i) value += at.barycentric[i] * fluence[at.cell.at() * 4 + i];
  return value;
}

/// Room with a box in it from which nothing comes back.
TetrahedralMesh room_with_box() {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "room";
  geometry.primitives.emplace_back(room);
  BoxPrimitive box;
  box.min = {0.4, 0.4, 0.4};
  box.max = {0.6, 0.6, 0.6};
  box.hole = true;
  box.name = "box";
  geometry.primitives.emplace_back(box);
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{4e-4}, 1.4, {}}));
}

TEST(UncollidedField, OfAPointLightBalances) {
  const TetrahedralMesh mesh = cube_mesh(1e-3);
  for (const double absorption : {0.0, 0.7, 20.0}) {
    const Problem problem =
        uniform_problem(mesh, uniform_medium(1, absorption, 0, 0), uniform_wall(1, 0, 0, 0));
    const LightPaths paths(problem);
    const UncollidedField field = uncollided_field(paths, point_at({0.31, 0.47, 0.62}, paths), 1);
    const double sum =
        absorption * integral_over_cells(mesh, field.fluence) + integral_over_walls(mesh, field.irradiance);
    EXPECT_NEAR(sum, 1, 2e-7) << absorption;
  }
}

// On a vertex of the mesh, in an edge, in a face, in a wall.
TEST(UncollidedField, OfAPointLightBalancesWhereverItStands) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.7, 0, 0), uniform_wall(1, 0, 0, 0));
  const LightPaths paths(problem);
  int inner = 0;
  while (mesh.vertices(CellIndex(inner))[0] < mesh.vertex_count() / 2) ++inner;
  std::array<Vec3, 4> v;
  for (std::size_t i = 0; i < 4; ++i) v[i] = mesh.point(VertexIndex(mesh.vertices(CellIndex(inner))[i]));
  for (const Vec3& position : {v[0], Vec3((v[0] + v[1]) / 2), Vec3((v[0] + v[1] + v[2]) / 3)}) {
    const bool in_wall = (position.array() * (1 - position.array())).abs().minCoeff() < 1e-9;
    if (in_wall) continue;
    const UncollidedField field = uncollided_field(paths, point_at(position, paths), 1);
    const double sum =
        0.7 * integral_over_cells(mesh, field.fluence) + integral_over_walls(mesh, field.irradiance);
    EXPECT_NEAR(sum, 1, 1e-6);
  }
  // In a wall, in an edge, in a corner.
  for (const Vec3& position : {Vec3(0.4, 0.6, 1), Vec3(0.4, 1, 1), Vec3(1, 1, 1)}) {
    const UncollidedField field = uncollided_field(paths, point_at(position, paths), 1);
    const double sum =
        0.7 * integral_over_cells(mesh, field.fluence) + integral_over_walls(mesh, field.irradiance);
    EXPECT_NEAR(sum, 1, 1e-6);
  }
}

// A lamp whose shape is cut by the wall, beside mirrors and on one.
TEST(UncollidedField, OfALampOnAWallSendsItsWholePower) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, name == "zmax" || name == "xmax" ? 0.6 : 0));
    walls.back().name = name;
  }
  const Problem problem(mesh, {}, {uniform_medium(1, 0.7, 0, 0)}, walls);
  const LightPaths paths(problem);
  PointLight light;
  light.power = {1};
  light.axis = Vec3(0.3, 0.4, 0.2).normalized();
  light.angle = {0, 0.5, pi};
  light.intensity = {3, 2, 1};
  for (const Vec3& position : {Vec3(0.4, 0.6, 0), Vec3(0.4, 0.6, 1), Vec3(1, 0.3, 1), Vec3(0, 0, 0)}) {
    light.position = position;
    const UncollidedField field = uncollided_field(paths, shining(light, paths), 1);
    double kept = 0.7 * integral_over_cells(mesh, field.fluence);
    for (std::size_t i = 0; i < field.irradiance.size(); ++i) {
      const FaceIndex face(static_cast<std::int64_t>(i / 3));
      kept += (1 - problem.wall(mesh.wall(face)).specular[0]) * field.irradiance[i] * mesh.area(face) / 3;
    }
    EXPECT_NEAR(kept, 1, 2e-5) << position.transpose();
  }
}

TEST(UncollidedField, OfAPointLightConverges) {
  double last = 0;
  for (const double max_volume : {8e-3, 1e-3, 1.25e-4}) {
    const TetrahedralMesh mesh = cube_mesh(max_volume);
    const Problem problem = uniform_problem(mesh, uniform_medium(1, 1.1, 0, 0), uniform_wall(1, 0, 0, 0));
    const LightPaths paths(problem);
    const Vec3 lamp(0.46, 0.48, 0.5);
    const UncollidedField field = uncollided_field(paths, point_at(lamp, paths), 1);
    double squares = 0;
    int count = 0;
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
      const double r = (mesh.centroid(CellIndex(c)) - lamp).norm();
      if (r < 0.3) continue;
      double value = 0;
      for (std::size_t i = 0; i < 4; ++i) value += field.fluence[static_cast<std::size_t>(c) * 4 + i] / 4;
      const double exact = std::exp(-1.1 * r) / (4 * pi * r * r);
      squares += (value / exact - 1) * (value / exact - 1);
      ++count;
    }
    const double error = std::sqrt(squares / count);
    if (last > 0) {
      EXPECT_GT(std::log2(last / error), 1.7);
    }
    last = error;
  }
}

/// What a point of power 1 sends out of a cell through a face, past a triangle that does not hold it: its
/// fluence there turned round, the light of a triangle at a point, over 4 pi.
double flux_through(const std::array<Vec3, 3>& face, const Vec3& inside, const Vec3& lamp,
                    double extinction) {
  Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
  const double height = normal.dot(face[0] - lamp);
  if (std::abs(height) < 1e-12 * (face[1] - face[0]).norm()) return 0;
  if (height < 0) normal = -normal;
  const Rotation upwards = rotation_about(normal + Vec3::UnitZ(), 180);
  std::vector<Vec3> turned;
  for (const Vec3& corner : face) turned.emplace_back(upwards * (corner - lamp));
  if ((turned[1] - turned[0]).cross(turned[2] - turned[0]).z() < 0) std::swap(turned[1], turned[2]);
  const double passes = light_of_polygon(turned, Vec3::Zero(), extinction).fluence / (4 * pi);
  return normal.dot(face[0] - inside) > 0 ? passes : -passes;
}

/// What is lost in the cell: the balance of what comes in, goes out and begins in it.
double exact_mean(const TetrahedralMesh& mesh, CellIndex cell, const Vec3& lamp, double extinction) {
  std::array<Vec3, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.point(VertexIndex(mesh.vertices(cell)[i]));
  const Vec3 inside = mesh.centroid(cell);
  double lost = 0;
  bool holds_lamp = true;
  for (std::size_t skip = 0; skip < 4; ++skip) {
    std::array<Vec3, 3> face;
    for (std::size_t i = 0, k = 0; i < 4; ++i)
      if (i != skip) face[k++] = corners[i];
    const double out = flux_through(face, inside, lamp, extinction);
    lost -= out;
    holds_lamp = holds_lamp && out > 0;
  }
  if (holds_lamp) lost += 1;
  return lost / (extinction * mesh.volume(cell));
}

// A cube of 0.032 with extinction 35: the cell that holds the lamp, those around it and all others.
TEST(UncollidedField, HasTheMeansOfCellsInAnAbsorbingCube) {
  constexpr double extinction = 35;
  const TetrahedralMesh unit = cube_mesh(4e-4);
  const TetrahedralMesh mesh = moved_mesh(unit, [](const Vec3& point) { return Vec3(0.032 * point); });
  const Problem problem =
      uniform_problem(mesh, uniform_medium(1, extinction, 0, 0), uniform_wall(1, 0, 0, 0));
  const LightPaths paths(problem);
  const Vec3 lamp(0.0147, 0.0153, 0.0161);
  const UncollidedField field = uncollided_field(paths, point_at(lamp, paths), 1);
  int near = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    double value = 0;
    for (std::size_t i = 0; i < 4; ++i) value += field.fluence[4 * cell.at() + i] / 4;
    EXPECT_NEAR(value / exact_mean(mesh, cell, lamp, extinction), 1, 2e-4);
    near += (mesh.centroid(cell) - lamp).norm() < 3 * std::cbrt(mesh.volume(cell)) ? 1 : 0;
  }
  EXPECT_GT(near, 100);
}

// A lamp whose brightness changes by angle and azimuth, in front of a mirror.
TEST(UncollidedField, OfALampWithPlanesBalances) {
  const TetrahedralMesh mesh = cube_mesh(1e-3);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  walls[static_cast<std::size_t>(wall_of(mesh, "xmax"))].specular = {0.5};
  const Problem problem(mesh, {}, {uniform_medium(1, 0.7, 0, 0)}, walls);
  const LightPaths paths(problem);
  PointLight light;
  light.position = {0.41, 0.47, 0.62};
  light.power = {1};
  light.axis = -Vec3::UnitZ();
  light.angle = {0, 0.5 * pi, pi};
  light.plane = {0, pi / 2, pi, 1.5 * pi, 2 * pi};
  light.intensity = {3, 5, 1, 3, 2, 1, 3, 1, 1, 3, 2, 1, 3, 5, 1};
  const LightSources sources = shining(light, paths);
  const UncollidedField field = uncollided_field(paths, sources, 1);
  double kept = 0;
  std::vector<double> arrived(walls.size(), 0);
  for (std::size_t i = 0; i < field.irradiance.size(); ++i) {
    const FaceIndex face(static_cast<std::int64_t>(i / 3));
    const double power = field.irradiance[i] * mesh.area(face) / 3;
    kept += (1 - problem.wall(mesh.wall(face)).specular[0]) * power;
    arrived[static_cast<std::size_t>(mesh.wall(face))] += power;
  }
  // Its table bends at each of its angles.
  EXPECT_NEAR(0.7 * integral_over_cells(mesh, field.fluence) + kept, 1, 2e-5);
  EXPECT_NEAR(arrived[static_cast<std::size_t>(wall_of(mesh, "ymin"))] /
                  arrived[static_cast<std::size_t>(wall_of(mesh, "ymax"))],
              1, 0.2);
  EXPECT_GT(arrived[static_cast<std::size_t>(wall_of(mesh, "xmax"))],
            1.2 * arrived[static_cast<std::size_t>(wall_of(mesh, "ymax"))]);
}

/// The part of the light of a volume of this extinction in a cube that is found again, with two sides of this
/// reflectance.
double part_found(const TetrahedralMesh& mesh, double specular, double extinction) {
  std::vector<Medium> media(2, uniform_medium(1, 0.8, 0, 0));
  for (std::size_t i = 0; i < media.size(); ++i)
    if (mesh.region_names()[i] == "inner") {
      media[i] = uniform_medium(1, extinction, 0, 0);
      media[i].emission = {Coefficient(1.0)};
    }
  for (Medium& medium : media) medium.uncollided = Uncollided::yes;
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const Vec3 normal = mesh.area_normal(FaceIndex(f)).normalized();
    if (normal.x() > 0.9 || normal.y() > 0.9)
      walls[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))].specular = {specular};
  }
  const Problem problem(mesh, {}, media, walls);
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  double kept = 0, sent = 0;
  for (std::size_t i = 0; i < field.irradiance.size(); ++i) {
    const FaceIndex face(static_cast<std::int64_t>(i / 3));
    kept += (1 - problem.wall(mesh.wall(face)).specular[0]) * field.irradiance[i] * mesh.area(face) / 3;
  }
  for (const auto& source : lights.sources()) sent += source->power()[0];
  double absorbed = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const bool inner = mesh.region_names()[static_cast<std::size_t>(mesh.region(cell))] == "inner";
    for (std::size_t i = 0; i < 4; ++i)
      absorbed += (inner ? extinction : 0.8) * field.fluence[4 * static_cast<std::size_t>(c) + i] *
                  mesh.volume(cell) / 4;
  }
  return (absorbed + kept) / sent;
}

// In a homogeneous medium nothing is interpolated; what is missed lies in the few cells at its edges. Mirrors
// keep 0.4 of what arrives.
TEST(UncollidedField, OfAVolumeBalancesBesideMirrorsToo) {
  const TetrahedralMesh mesh = two_region_mesh(0.02);
  EXPECT_NEAR(part_found(mesh, 0, 0.8), 1, 1.5e-5);
  EXPECT_NEAR(part_found(mesh, 0.6, 0.8), 1, 1.5e-5);
}

// A gas that emits everywhere between mirrors, of which it sees itself from their very surface.
TEST(UncollidedField, OfAVolumeThatTouchesMirrorsBalances) {
  const TetrahedralMesh mesh = cube_mesh(0.03);
  Medium gas = uniform_medium(1, 0.8, 0, 0);
  gas.emission = {Coefficient(1.0)};
  gas.uncollided = Uncollided::yes;
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (const char* side : {"xmax", "ymin"})
    walls[static_cast<std::size_t>(wall_of(mesh, side))].specular = {0.6};
  const Problem problem(mesh, {}, {gas}, walls);
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  double found = 0.8 * integral_over_cells(mesh, field.fluence);
  for (std::size_t i = 0; i < field.irradiance.size(); ++i) {
    const FaceIndex face(static_cast<std::int64_t>(i / 3));
    found += (1 - problem.wall(mesh.wall(face)).specular[0]) * field.irradiance[i] * mesh.area(face) / 3;
  }
  EXPECT_NEAR(found / lights.sources().front()->power()[0], 1, 1e-5);
}

// Where it is another extinction that the volume has, the attenuation is sampled from vertices and edges.
TEST(UncollidedField, OfAThickVolumeBalances) {
  EXPECT_NEAR(part_found(two_region_mesh(0.01), 0, 3), 1, 2e-4);
}

TEST(UncollidedField, OfTheSunFallsExponentially) {
  const TetrahedralMesh mesh = cube_mesh(1e-3);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 2, 0, 0), uniform_wall(1, 0, 0, 0));
  const LightPaths paths(problem);
  const UncollidedField field = uncollided_field(paths, sun(-Vec3::UnitZ(), wall_of(mesh, "zmax"), paths), 1);
  for (const double z : {0.1, 0.5, 0.93})
    EXPECT_NEAR(fluence_at(mesh, field.fluence, {0.4, 0.55, z}), std::exp(-2 * (1 - z)), 5e-3);
  EXPECT_NEAR(2 * integral_over_cells(mesh, field.fluence) + integral_over_walls(mesh, field.irradiance), 1,
              1e-6);
}

// Two suns from opposite sides into a column between mirrors have no edges.
TEST(UncollidedField, OfSlantingSunsBalancesInThickCells) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (const char* side : {"xmin", "xmax", "ymin", "ymax"})
    walls[static_cast<std::size_t>(wall_of(mesh, side))].specular = {1};
  for (const double extinction : {2.0, 10.0}) {
    const Problem problem(mesh, {}, {uniform_medium(1, extinction, 0, 0)}, walls);
    const LightPaths paths(problem);
    LightSources sources;
    for (const double x : {-0.5, 0.5})
      sources.push_back(std::make_unique<BeamSource>(
          "sun", BeamLight{Vec3(x, 0, -0.8).normalized(), {1}, {wall_of(mesh, "zmax")}}, paths));
    const UncollidedField field = uncollided_field(paths, sources, 1);
    double found = extinction * integral_over_cells(mesh, field.fluence);
    for (std::size_t i = 0; i < field.irradiance.size(); ++i)
      if (const FaceIndex face(static_cast<std::int64_t>(i / 3)); mesh.wall(face) == wall_of(mesh, "zmin"))
        found += field.irradiance[i] * mesh.area(face) / 3;
    EXPECT_NEAR(found / (sources[0]->power()[0] + sources[1]->power()[0]), 1, 1e-6) << extinction;
  }
}

// A plate 100 times as wide as it is thick: what lies side by side in a cell is reached by paths that come in
// far from each other, through the same medium; but along one edge light comes in by the side.
TEST(UncollidedField, OfASlantingSunBalancesInWideFlatCells) {
  const TetrahedralMesh mesh =
      moved_mesh(cube_mesh(0.2), [](const Vec3& p) { return Vec3(10 * p.x(), 10 * p.y(), 0.1 * p.z()); });
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 20, 0, 0), uniform_wall(1, 0, 0, 0));
  const LightPaths paths(problem);
  const LightSources sources = sun(Vec3(0.96, 0, -0.28), 0, paths);
  const UncollidedField field = uncollided_field(paths, sources, 1);
  const double absorbed = 20 * integral_over_cells(mesh, field.fluence);
  EXPECT_NEAR((absorbed + integral_over_walls(mesh, field.irradiance)) / sources[0]->power()[0], 1, 1e-6);
}

TEST(UncollidedField, BeforeAMirrorIsThatOfTheRoomWithItsImage) {
  const TetrahedralMesh half = cube_mesh(2e-3);
  const TetrahedralMesh whole = mesh_with_image(half);
  std::vector<Wall> walls(half.wall_names().size(), uniform_wall(1, 0, 0, 0));
  walls[static_cast<std::size_t>(wall_of(half, "xmax"))].specular = {0.8};
  const Problem mirrored(half, {}, {uniform_medium(1, 0.9, 0, 0)}, walls);
  const Problem with_image = uniform_problem(whole, uniform_medium(1, 0.9, 0, 0), uniform_wall(1, 0, 0, 0));
  const LightPaths before(mirrored), open(with_image);
  const Vec3 lamp(0.7, 0.4, 0.3), image(1.3, 0.4, 0.3), there(0.2, 0.8, 0.7);
  const UncollidedField field = uncollided_field(before, point_at(lamp, before), 1);
  const double direct = fluence_at(whole, uncollided_field(open, point_at(lamp, open), 1).fluence, there);
  const double behind = fluence_at(whole, uncollided_field(open, point_at(image, open), 1).fluence, there);
  EXPECT_NEAR(fluence_at(half, field.fluence, there), direct + 0.8 * behind, 1e-4 * direct);
}

TEST(UncollidedField, IsDarkBehindABox) {
  const TetrahedralMesh mesh = room_with_box();
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.1, 0, 0), uniform_wall(1, 0, 0, 0));
  const LightPaths paths(problem);
  const Vec3 lamp(0.5, 0.5, 0.9);
  const UncollidedField of_lamp = uncollided_field(paths, point_at(lamp, paths), 1);
  const UncollidedField of_sun =
      uncollided_field(paths, sun(-Vec3::UnitZ(), wall_of(mesh, "zmax"), paths), 1);
  int dark = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    bool in_both = true;
    for (const std::int32_t v : mesh.vertices(CellIndex(c))) {
      const Vec3& p = mesh.point(VertexIndex(v));
      in_both = in_both && p.z() < 0.41 && std::abs(p.x() - 0.5) < 0.1 && std::abs(p.y() - 0.5) < 0.1;
    }
    if (!in_both) continue;
    ++dark;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(of_lamp.fluence[static_cast<std::size_t>(c) * 4 + i], 0);
      EXPECT_EQ(of_sun.fluence[static_cast<std::size_t>(c) * 4 + i], 0);
    }
  }
  EXPECT_GT(dark, 20);
  const auto kept = [&](const UncollidedField& field) {
    return 0.1 * integral_over_cells(mesh, field.fluence) + integral_over_walls(mesh, field.irradiance);
  };
  EXPECT_NEAR(kept(of_lamp), 1, 1e-7);
  EXPECT_NEAR(kept(of_sun), 1, 1e-12);
}

TEST(UncollidedField, IsTheSameForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const Problem problem = uniform_problem(mesh, uniform_medium(2, 0.5, 0, 0), uniform_wall(2, 0, 0, 0));
  const LightPaths paths(problem);
  PointLight light;
  light.position = {0.3, 0.4, 0.5};
  light.power = {1, 2};
  const LightSources sources = shining(light, paths);
  const UncollidedField one = uncollided_field(paths, sources, 1),
                        three = uncollided_field(paths, sources, 3);
  EXPECT_EQ(one.fluence, three.fluence);
  EXPECT_EQ(one.net_flux, three.net_flux);
  EXPECT_EQ(one.irradiance, three.irradiance);
}

}  // namespace
}  // namespace etendue::uncollided_field_test
