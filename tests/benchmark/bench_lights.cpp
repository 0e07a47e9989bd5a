// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What uncollided light costs: processor time of one thread for the light of a lamp, the sun, an area lamp
// and an emitting box in every cell and on every wall, in 1, 3 and 8 bands, in units of a sweep of 96
// directions in one band: as it is now, and as it is at 9 ns for each cell and direction. Thin medium in a
// unit cube, alike in all bands or not; the argument is the largest volume of a cell. For steps of rays see
// bench_rays.
#include <fmt/format.h>

#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "base/parallel/processor_timer.h"
#include "solver/transport/iteration/source_iteration.h"
#include "solver/transport/sweep/transport_sweep.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/benchmark/unit_cube.h"

namespace etendue {
namespace {

double seconds_of(const std::function<void()>& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

/// The extinction is 1, or rises from band to band.
enum class Matter { alike, varied };

/// The regions called "body" emit; without one the lights are all.
Problem lit(const TetrahedralMesh& mesh, int bands, Matter matter, std::vector<Light> lights) {
  const auto count = static_cast<std::size_t>(bands);
  Bands spectrum;
  spectrum.names.clear();
  std::vector<Coefficient> half;
  for (int b = 0; b < bands; ++b) {
    spectrum.names.push_back("band" + std::to_string(b));
    half.emplace_back(matter == Matter::alike ? 0.5 : 0.5 * (1 + 0.1 * b));
  }
  std::vector<Medium> media;
  for (const std::string& region : mesh.region_names()) {
    const bool emits = region == "body";
    media.push_back({region,
                     half,
                     half,
                     std::vector<Coefficient>(count, Coefficient(emits ? 1. : 0.)),
                     std::vector<PhaseFunction>(count, PhaseIsotropic{}),
                     {}});
    if (emits) media.back().uncollided = Uncollided::yes;
  }
  const std::vector<double> none(count, 0);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) walls.push_back({name, none, none, none, {}});
  return Problem(mesh, spectrum, media, walls, AngularSpace::sphere, std::move(lights));
}

double seconds_of_sweep(const Problem& problem) {
  const DirectionSet directions = directions_ldfe_sq(1);
  std::vector<double> extinction(problem.absorption().begin(), problem.absorption().end());
  for (std::size_t i = 0; i < extinction.size(); ++i) extinction[i] += problem.scattering()[i];
  SolveOptions options;
  options.threads = 1;
  TransportSweep sweep(problem, directions, extinction, options);
  TransportState last(sweep.layout()), next(sweep.layout());
  sweep.apply(last, next);
  return seconds_of([&] { sweep.apply(last, next); });
}

struct Sweeps {
  double now, nominal;  ///< [s]
};

void measure(const std::string& name, const Problem& problem, Sweeps sweep) {
  const LightSetup lights(problem);
  UncollidedField field;
  const double seconds = seconds_of([&] { field = uncollided_field(lights.paths(), lights.sources(), 1); });
  double sum = 0;
  for (const double value : field.fluence) sum += value;
  fmt::print(
      "{:>10}, bands {}: {:6.2f} s, {:6.1f} sweeps, {:6.1f} of {:.0f} ms (sum of the nodal values {:.6g})\n",
      name, problem.band_count(), seconds, seconds / sweep.now, seconds / sweep.nominal, 1e3 * sweep.nominal,
      sum);
}

Light lamp(int bands) {
  PointLight point;
  point.position = {0.31, 0.47, 0.62};
  point.power.assign(static_cast<std::size_t>(bands), 1);
  return {"lamp", point, {}};
}

Light sun(int bands, const TetrahedralMesh& mesh) {
  BeamLight beam;
  beam.direction = Vec3(0.3, -0.2, -1).normalized();
  beam.irradiance.assign(static_cast<std::size_t>(bands), 1);
  for (int w = 0; w < static_cast<int>(mesh.wall_names().size()); ++w) beam.walls.push_back(w);
  return {"sun", beam, {}};
}

Light panel(int bands) {
  SurfaceLight surface;
  const Vec3 a(0.4, 0.4, 0.95), b(0.4, 0.6, 0.95), c(0.6, 0.6, 0.95), d(0.6, 0.4, 0.95);
  surface.triangles = {a, b, c, a, c, d};
  surface.radiance.assign(static_cast<std::size_t>(bands), 1);
  return {"area lamp", surface, {}};
}

/// The cube with a box of a fifth of its side in it.
TetrahedralMesh cube_with_body(double max_volume) {
  Geometry geometry;
  BoxPrimitive cube, body;
  cube.region = "cube";
  body.region = "body";
  body.min = Vec3::Constant(0.4);
  body.max = Vec3::Constant(0.6);
  geometry.primitives = {cube, body};
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{max_volume, max_volume}, 1.4, {}}));
}

}  // namespace
}  // namespace etendue

int main(int count, char** arguments) {
  using namespace etendue;
  const double max_volume = count > 1 ? std::atof(arguments[1]) : 1.9e-5;
  const TetrahedralMesh mesh = unit_cube(max_volume), with_body = cube_with_body(max_volume);
  const auto sweeps_on = [](const TetrahedralMesh& on) {
    return Sweeps{seconds_of_sweep(lit(on, 1, Matter::alike, {})), 9e-9 * 96 * on.cell_count()};
  };
  const Sweeps sweep = sweeps_on(mesh), with_body_sweep = sweeps_on(with_body);
  fmt::print("{} cells, {} with the box; a sweep of 96 directions takes {:.0f} and {:.0f} ms\n",
             mesh.cell_count(), with_body.cell_count(), 1e3 * sweep.now, 1e3 * with_body_sweep.now);
  const auto measure_all = [&](Matter matter, int bands) {
    for (const Light& light : {lamp(bands), sun(bands, mesh), panel(bands)})
      measure(light.name, lit(mesh, bands, matter, {light}), sweep);
    measure("body", lit(with_body, bands, matter, {}), with_body_sweep);
  };
  fmt::print("one extinction:\n");
  for (const int bands : {1, 3, 8}) measure_all(Matter::alike, bands);
  fmt::print("an extinction for each band:\n");
  for (const int bands : {3, 8}) measure_all(Matter::varied, bands);
}
