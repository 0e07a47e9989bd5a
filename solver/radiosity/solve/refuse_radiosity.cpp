// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <string>

#include "base/errors.h"
#include "solver/problem/any_formula.h"
#include "solver/problem/problem_checks.h"
#include "solver/radiosity/solve/solve_radiosity.h"

namespace etendue {
namespace {

constexpr const char* instead = "; use solve.method = \"auto\" or \"photons\"";

/// Names the region once, whatever cells and bands it is in.
class MatterFaults {
 public:
  explicit MatterFaults(const Problem& problem) : problem_(problem) {}

  void find(const char* key, std::span<const double> values, const char* what) {
    const auto bands = static_cast<std::size_t>(problem_.band_count());
    std::vector<char> named(problem_.media().size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const CellIndex cell(static_cast<std::int64_t>(i / bands));
      const auto region = static_cast<std::size_t>(problem_.mesh().region(cell));
      if (values[i] == 0 || named[region] != 0) continue;
      named[region] = 1;
      add(origin_of(problem_.media()[region], key), what);
    }
  }
  void add(const Origin& origin, const std::string& what) {
    faults_.push_back(fault_at(origin, "", what + instead));
  }
  std::vector<Fault> all() { return std::move(faults_); }

 private:
  const Problem& problem_;
  std::vector<Fault> faults_;
};

}  // namespace

void refuse_for_radiosity(const Problem& problem) {
  MatterFaults faults(problem);
  faults.find(
      "scattering", problem.scattering(),
      "is not 0 (radiosity carries light from wall to wall alone: a medium that scatters has no part in it)");
  faults.find("absorption", problem.absorption(),
              "is not 0 (radiosity carries light from wall to wall alone: nothing may be lost between them)");
  faults.find("emission", problem.emission(), "is not 0 (in radiosity only walls emit)");
  for (const Medium& medium : problem.media())
    if (any_formula(medium.emission_by_direction))
      faults.add(origin_of(medium, "emission"), "depends on the direction");
  for (const Wall& wall : problem.walls()) {
    if (wall.refractive_index != 1 && std::ranges::any_of(wall.radiance, [](double r) { return r > 0; }))
      faults.add(origin_of(wall, "radiance"),
                 "is refracted as it comes in (radiosity sends light evenly into all directions)");
    if (any_formula(wall.radiance_by_direction))
      faults.add(origin_of(wall, "radiance"),
                 "depends on the place or the direction (not in this version for radiosity)");
  }
  // The parts of a sky in a row are one light of the case.
  Origin before;
  for (const Light& light : problem.lights()) {
    if (light.origin.line == before.line && light.origin.key == before.key) continue;
    before = light.origin;
    faults.add(light.origin,
               "is a light that is no wall (not in this version for radiosity: walls with a radiance shine)");
  }
  std::vector<Fault> found = faults.all();
  if (problem.space() == AngularSpace::plane)
    found.push_back(fault_at({}, "",
                             "directions.set = \"flatland\": radiosity exchanges light in all directions of "
                             "space; use another set"));
  if (!found.empty()) throw InputError(std::move(found));
}

}  // namespace etendue
