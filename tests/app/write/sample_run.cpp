// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/app/write/sample_run.h"

#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace etendue::test {
namespace {

int corner(const std::array<int, 3>& c) { return c[0] + 2 * c[1] + 4 * c[2]; }

Medium medium(const std::string& name, int bands, double absorption, double emission) {
  const auto all = [&](double value) {
    return std::vector<Coefficient>(static_cast<std::size_t>(bands), Coefficient(value));
  };
  return {name,
          all(absorption),
          all(0.5),
          all(emission),
          std::vector<PhaseFunction>(static_cast<std::size_t>(bands)),
          {}};
}

Wall wall(const std::string& name, int bands, double radiance) {
  const auto all = [&](double value) { return std::vector<double>(static_cast<std::size_t>(bands), value); };
  return {name, all(radiance), all(0.25), all(0), {}};
}

Problem sample_problem(const TetrahedralMesh& mesh, const Bands& bands) {
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names())
    media.push_back(medium(name, bands.count(), name == "low" ? 0.125 : 2, name == "low" ? 0 : 3));
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names())
    walls.push_back(wall(name, bands.count(), name == "floor" ? 1.5 : 0));
  return Problem(mesh, bands, std::move(media), std::move(walls));
}

/// Different numbers that are not round in binary.
std::vector<double> numbers(std::size_t count, double start) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = start + 0.1 * static_cast<double>(i);
  return values;
}

Solution sample_solution(const TetrahedralMesh& mesh, std::size_t bands) {
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  const auto faces = static_cast<std::size_t>(mesh.boundary_face_count());
  Solution solution;
  solution.method = "source-iteration";
  solution.directions = 24;
  solution.fluence = numbers(cells * 4 * bands, 1);
  solution.net_flux = numbers(cells * 12 * bands, -3);
  solution.irradiance = numbers(faces * 3 * bands, 2);
  solution.exitance = numbers(faces * 3 * bands, 0.5);
  solution.half_range.assign(faces, 3.0);
  solution.convergence.assign(bands, {7, 1e-9, true});
  solution.negative.resize(bands);
  solution.kernels = {{"low", "red", 0.6, 1e-15, "moments, degree 3", "isotropic"}};
  solution.notes = {"a choice (its reason)"};
  for (int sweep = 1; sweep <= 2; ++sweep)
    for (std::size_t b = 0; b < bands; ++b)
      solution.history.push_back({sweep, static_cast<int>(b), 0.1 / sweep});
  return solution;
}

Case sample_case(std::vector<std::string> bands, std::vector<double> edges) {
  Case input;
  input.file = "sample.toml";
  input.title = "Sample";
  input.bands.names = std::move(bands);
  input.bands.edges = std::move(edges);
  input.resolved_toml = "title = \"Sample\"\n";
  return input;
}

}  // namespace

RawMesh cube_of_six() {
  RawMesh raw;
  for (int i = 0; i < 8; ++i) raw.points.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  raw.region_names = {"low", "high"};
  raw.wall_names = {"floor", "sides"};
  std::array<int, 3> axes = {0, 1, 2};
  do {
    // From (0,0,0) to (1,1,1) along the axes in this order (Kuhn's subdivision).
    std::array<int, 3> at = {0, 0, 0};
    std::array<int, 4> cell = {corner(at), 0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      at[static_cast<std::size_t>(axes[i])] = 1;
      cell[i + 1] = corner(at);
    }
    const bool odd = (axes[0] > axes[1]) != ((axes[1] > axes[2]) != (axes[0] > axes[2]));
    std::array<int, 4> positive = cell;
    if (odd) std::swap(positive[2], positive[3]);
    raw.cells.push_back(positive);
    raw.cell_regions.push_back(axes[2] == 2 ? 1 : 0);
    raw.triangles.push_back({cell[1], cell[2], cell[3]});  // where the first axis is 1
    raw.triangle_walls.push_back(1);
    raw.triangles.push_back({cell[0], cell[1], cell[2]});  // where the last axis is 0
    raw.triangle_walls.push_back(axes[2] == 2 ? 0 : 1);
  } while (std::next_permutation(axes.begin(), axes.end()));
  return raw;
}

SampleRun::SampleRun(std::vector<std::string> bands, std::vector<double> edges)
    : input(sample_case(std::move(bands), std::move(edges))),
      mesh(cube_of_six()),
      problem(sample_problem(mesh, input.bands)),
      solution(sample_solution(mesh, input.bands.names.size())) {
  const std::size_t count = input.bands.names.size();
  probes = {{"axis", 0, Vec3(0.5, 0.25, 0.1), std::vector<ProbeValue>(count, {1.0 / 3, {1, 2, 3}}), {}},
            {"a \"b\", c", 3, Vec3::Zero(), std::vector<ProbeValue>(count), std::vector<double>(count, 0.1)}};
}

RunResult SampleRun::result() const {
  const std::size_t bands = input.bands.names.size();
  return {.input = input,
          .problem = problem,
          .solution = solution,
          .probes = probes,
          .balances = std::vector<Balance>(bands, {1, 2, 1.5, 1.5, 0}),
          .walls = {mesh.wall_names().size(), std::vector<WallPower>(bands, {1, 0.1, 0.7, 0.4, 0.2, 0.2})},
          .regions = {mesh.region_names().size(), std::vector<RegionPower>(bands, {0.5, 1.1, 0.3, 0.2})},
          .seconds = {.read = 0.5, .mesh = 1.5, .setup = 0.375, .probes = 0.25, .total = 6},
          .threads = 2};
}

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "etendue-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> ScratchFolder::names_in(const std::filesystem::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

void make_of_another_process(const std::filesystem::path& directory) {
  const std::string own = "\"process\": " + std::to_string(getpid()) + ",";
  std::string summary = text_of(directory / "summary.json");
  const auto at = summary.find(own);
  if (at == std::string::npos) throw std::runtime_error("summary.json does not name this process");
  write_text(directory / "summary.json", summary.replace(at, own.size(), "\"process\": 1,"));
}

}  // namespace etendue::test
