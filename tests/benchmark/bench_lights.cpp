// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What uncollided light costs: processor time of one thread for the light of a lamp, the sun and an area lamp
// in every cell and on every wall, beside that of a sweep of 96 directions. Thin medium in a unit cube; the
// argument is the largest volume of a cell. For steps of rays see bench_rays.
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <functional>

#include "solver/lights/light_setup.h"
#include "solver/ordinates/source_iteration.h"
#include "solver/ordinates/transport_sweep.h"
#include "tests/benchmark/unit_cube.h"

namespace etendue {
namespace {

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const std::function<void()>& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

Problem lit(const TetrahedralMesh& mesh, const Light& light) {
  const Medium medium{"domain",         {Coefficient(0.5)}, {Coefficient(0.5)},
                      {Coefficient(0)}, {PhaseIsotropic{}}, {}};
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) walls.push_back({name, {0}, {0}, {0}, {}});
  return Problem(mesh, {}, {medium}, walls, AngularSpace::sphere, {light});
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

void measure(const TetrahedralMesh& mesh, const Light& light, double sweep) {
  const Problem problem = lit(mesh, light);
  const LightSetup lights(problem);
  UncollidedField field;
  const double seconds = seconds_of([&] { field = uncollided_field(lights.paths(), lights.sources(), 1); });
  double sum = 0;
  for (const double value : field.fluence) sum += value;
  fmt::print("{:>9}: {:6.2f} s, {:5.1f} sweeps (sum of the nodal values {:.6g})\n", light.name, seconds,
             seconds / sweep, sum);
}

Light lamp() {
  PointLight point;
  point.position = {0.31, 0.47, 0.62};
  point.power = {1};
  return {"lamp", point, {}};
}

Light sun(const TetrahedralMesh& mesh) {
  BeamLight beam;
  beam.direction = Vec3(0.3, -0.2, -1).normalized();
  beam.irradiance = {1};
  for (int w = 0; w < static_cast<int>(mesh.wall_names().size()); ++w) beam.walls.push_back(w);
  return {"sun", beam, {}};
}

Light panel() {
  SurfaceLight surface;
  const Vec3 a(0.4, 0.4, 0.95), b(0.4, 0.6, 0.95), c(0.6, 0.6, 0.95), d(0.6, 0.4, 0.95);
  surface.triangles = {a, b, c, a, c, d};
  surface.radiance = {1};
  return {"area lamp", surface, {}};
}

}  // namespace
}  // namespace etendue

int main(int count, char** arguments) {
  using namespace etendue;
  const TetrahedralMesh mesh = unit_cube(count > 1 ? std::atof(arguments[1]) : 1.9e-5);
  const double sweep = seconds_of_sweep(lit(mesh, lamp()));
  fmt::print("{} cells; a sweep of 96 directions takes {:.0f} ms\n", mesh.cell_count(), 1e3 * sweep);
  for (const Light& light : {lamp(), sun(mesh), panel()}) measure(mesh, light, sweep);
}
