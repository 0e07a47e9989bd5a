// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_solve.h"

#include <stdexcept>

#include "app/case/build/build.h"
#include "app/case/keys/case_tables.h"
#include "app/case/keys/resolve_path.h"
#include "solver/angular/sets/direction_set.h"

namespace etendue {
namespace {

std::optional<Rotation> read_rotation(Section& directions, AngularSpace space) {
  const TomlNode* rotation = directions.find("rotation");
  if ((rotation == nullptr || !rotation->is_text()) && directions.integer("rotations") == 1)
    directions.unused("seed", "only random rotations are drawn");
  if (rotation == nullptr) return std::nullopt;
  if (rotation->is_table()) {
    const Vec3 axis = to_vec3(*rotation->find("axis"));
    if (space == AngularSpace::plane && axis.head<2>().norm() > 0)
      directions.fault("rotation", "turns directions out of the plane z = const; use axis = [0, 0, 1]");
    return rotation_about(axis, rotation->find("angle")->number());
  }
  return random_rotation(static_cast<std::uint64_t>(directions.integer("seed")), space);
}

std::optional<ConeRefinement> read_refinement(Section& directions) {
  if (!directions.has("refine")) return std::nullopt;
  Section cone = directions.section("refine");
  const auto direction = cone.point_if("direction");
  const auto angle = cone.number_if("angle"), levels = cone.number_if("levels");
  if (!direction || !angle || !levels) return std::nullopt;
  if (direction->norm() == 0) {
    cone.fault("direction", "has no direction; use a vector that is not zero");
    return std::nullopt;
  }
  return ConeRefinement{*direction, *angle, static_cast<int>(*levels)};
}

std::optional<DirectionChoice> read_first_collided(Section& directions, AngularSpace space) {
  if (!directions.has("first_collided")) return std::nullopt;
  Section table = directions.section("first_collided");
  const std::string set = table.text("set");
  if (set == "none") {
    table.unused("order", "there is no set of directions of its own");
    return std::nullopt;
  }
  const auto order = table.number_if("order");
  if (space == AngularSpace::plane || angular_space(set) == AngularSpace::plane) {
    directions.fault("first_collided", "no light is followed along rays in flatland; use sets on the sphere");
    return std::nullopt;
  }
  if (table.node().find("set")->faulty) return std::nullopt;
  if (!table.has("order")) table.fault("order", "missing; an integer from 1 to 10000");
  if (!order) return std::nullopt;
  DirectionChoice choice{set, static_cast<int>(*order), table.origin("order")};
  const std::string problem = check_direction_order(choice.set, choice.order);
  if (!problem.empty()) table.fault("order", problem);
  return choice;
}

/// A refined set is made once to see how large it is.
void check_refinement(Section& directions, const Case& result) {
  if (!result.direction_refinement) return;
  if (result.direction_set != "ldfe-sq")
    return directions.fault("refine",
                            "only ldfe-sq can be refined (its quadrilaterals are split); use set = "
                            "\"ldfe-sq\", or a higher order");
  try {
    build_directions(result);
  } catch (const std::length_error& error) {
    directions.fault("refine",
                     std::string(error.what()) + "; use fewer levels, a smaller angle or a lower order");
  }
}

}  // namespace

void read_directions(Section directions, Case& result) {
  direction_table().read(directions, result);
  result.directions_origin = directions.origin("order");
  result.angular_space = angular_space(result.direction_set);
  result.direction_rotation = read_rotation(directions, result.angular_space);
  if (result.rotations > 1) result.direction_seed = static_cast<std::uint64_t>(directions.integer("seed"));
  result.direction_refinement = read_refinement(directions);
  result.first_collided = read_first_collided(directions, result.angular_space);
  for (const char* name : {"set", "order"})
    if (directions.node().find(name)->faulty) return;  // nothing to say about their combination
  const std::string problem = check_direction_order(result.direction_set, result.direction_order);
  if (!problem.empty()) return directions.fault("order", problem);
  check_refinement(directions, result);
}

void read_space(Section space, SolveOptions& options) {
  options.order = space.integer("order") == 0 ? SpaceOrder::constant : SpaceOrder::linear;
  space_table().read(space, options);
  if (options.order == SpaceOrder::constant && options.positivity != Positivity::none)
    space.fault("positivity", "constant elements are never negative; use \"none\", or order = 1");
}

void read_radiosity(Section radiosity, bool chosen, Case& result) {
  RadiosityCase read;
  radiosity_table().read(radiosity, read);
  if (!radiosity.find("smallest_patch")) read.smallest_patch = read.patch_size / 8;
  if (read.refine_change > 0 && read.smallest_patch <= 0)
    radiosity.fault("refine_change",
                    "needs a size at which cutting ends; give smallest_patch, or patch_size, of which it is "
                    "an eighth then");
  if (chosen) result.radiosity = read;
}

void read_photon_map(Section map, Case& result) {
  // Read with every method: one case serves several, and `compare` asks for them side by side.
  PhotonCase photons = result.photons.value_or(PhotonCase{});
  photon_map_table().read(map, photons);
  if (result.photons) result.photons = photons;
}

void read_solve(Section solve, const std::filesystem::path& case_folder, Case& result) {
  solve_table().read(solve, "method", result);
  PhotonCase photons;
  photon_table().read(solve, photons);
  if (solve.text("method") == "photons") result.photons = photons;
  solve_table().read(solve, result);
  if (result.solve.precision == Precision::mixed && result.solve.method == Method::source_iteration)
    solve.fault("precision", "source iteration has no cycles that double precision corrects; use gmres");
  if (const TomlNode* initial = solve.find("initial"))
    result.initial = InputFile{resolve_path(*initial, case_folder), initial->origin};
}

}  // namespace etendue
