// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/study/study_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/case/build/build.h"
#include "app/write/json/summary.h"
#include "app/write/result/output_folder.h"

namespace etendue {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* file_name = "level.json";
// The exact integrals of a study of directions: exact to degree 35, and a set that doubling seldom meets.
constexpr int reference_order = 18, reference_order_in_plane = 76;

DirectionSet reference_directions(AngularSpace space) {
  return space == AngularSpace::sphere ? directions_product(reference_order)
                                       : directions_flatland(reference_order_in_plane);
}

/// A bound as TOML, multiplied.
std::string scaled(const SizeBound& bound, double factor) {
  std::string entries;
  for (const auto& [region, size] : bound.by_region)
    entries += fmt::format("{}{} = {}", entries.empty() ? "" : ", ", Json(region).dump(), size * factor);
  return "{ " + entries + " }";
}

/// Makes the values of one run.
class Values {
 public:
  Values(const RunResult& run, Refinement refinement) : run_(run), refinement_(refinement) {
    if (!run.exact) return;
    radiance_.emplace(run.input.exact->radiance);
    set_.emplace(refinement == Refinement::mesh ? build_directions(run.input, run.problem)
                                                : reference_directions(run.input.angular_space));
    exact_ = refinement == Refinement::mesh
                 ? *run.exact
                 : compare_with_exact(run.problem, run.solution, *radiance_, *set_);
  }

  std::vector<StudyValue> all() {
    for (std::size_t band = 0; band < run_.balances.size(); ++band) add_band(band);
    return std::move(values_);
  }

 private:
  void add_band(std::size_t band) {
    const std::string& name = run_.problem.bands().names[band];
    const auto add = [&](const std::string& quantity, double value, std::optional<double> exact) {
      values_.push_back({name, quantity, value, exact});
    };
    if (exact_) {
      add("fluence_L2", exact_->fluence[band].l2, 0.0);
      add("fluence_Linf", exact_->fluence[band].linf, 0.0);
      add("fluence_mean_L2", exact_->fluence[band].l2_of_means, 0.0);
    }
    for (const ProbeRow& row : run_.probes)
      add(fmt::format("probe:{}:{}", row.name, row.index), row.values[band].fluence,
          exact_ ? std::optional(exact_fluence(*radiance_, *set_, row.point)) : std::nullopt);
    for (std::size_t w = 0; w < run_.walls.size(); ++w)
      add("wall:" + run_.problem.walls()[w].name + ":incoming", run_.walls[w][band].incoming,
          exact_ && refinement_ == Refinement::mesh ? std::optional(exact_->incoming[w]) : std::nullopt);
    for (std::size_t r = 0; r < run_.regions.size(); ++r)
      add("region:" + run_.problem.media()[r].name + ":absorbed", run_.regions[r][band].absorbed,
          exact_ ? std::optional(exact_->absorbed[r][band]) : std::nullopt);
    add("balance", run_.balances[band].residual, 0.0);
  }

  const RunResult& run_;
  Refinement refinement_;
  std::optional<ExactRadiance> radiance_;
  std::optional<DirectionSet> set_;
  std::optional<ExactComparison> exact_;
  std::vector<StudyValue> values_;
};

Json value_json(const StudyValue& value) {
  return {{"band", value.band},
          {"quantity", value.quantity},
          {"value", value.value},
          {"exact", value.exact ? Json(*value.exact) : Json()}};
}

Json parsed(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return Json::parse(stream, nullptr, false);
}

/// Whether the results in this folder are all there and this case made them.
bool is_whole(const Case& input) {
  const std::filesystem::path& folder = input.output.directory;
  const Json summary = parsed(folder / "summary.json");
  if (!summary.is_object() || summary.value("case", Json()) != input.resolved_toml) return false;
  if (summary.value("interrupted", Json()) != false) return false;
  const Json files = summary.value("files", Json::array());
  return std::all_of(files.begin(), files.end(), [&](const Json& name) {
    return name.is_string() && std::filesystem::exists(folder / name.get<std::string>());
  });
}

}  // namespace

std::string refined_directions(const Case& input, int times) {
  return fmt::format("directions.order={}", std::ldexp(input.direction_order, times));
}

std::string refined_mesh(const Case& input, int times) {
  return resized_mesh(input, std::ldexp(1.0, -times));
}

std::string resized_mesh(const Case& input, double factor) {
  const MeshCase& mesh = input.mesh;
  if (mesh.file)
    throw InputError(
        fault_at(mesh.file->origin, "",
                 "a mesh that is read has no size that could be changed; give a geometry or a surface"));
  if (mesh.max_volume) return "mesh.max_volume=" + scaled(*mesh.max_volume, std::pow(factor, 3));
  if (mesh.edge_length) return "mesh.edge_length=" + scaled(*mesh.edge_length, factor);
  throw InputError(fault_at(mesh.origin, "", "has no cell size to refine; give max_volume or edge_length"));
}

std::string split_mesh(const Case& input, int times) {
  return fmt::format("mesh.refine={}", input.mesh.refine + times);
}

Refinements refinements(const StudyRequest& study, int level) {
  switch (study.refinement) {
    case Refinement::mesh:
      return {level - 1, 0};
    case Refinement::directions:
      return {0, level - 1};
    case Refinement::both:
      break;
  }
  return {(level - 1) / study.levels, (level - 1) % study.levels};
}

int level_count(const StudyRequest& study) {
  return study.refinement == Refinement::both ? study.levels * study.levels : study.levels;
}

RunRequest level_request(const StudyRequest& study, const Case& input, int level) {
  RunRequest request = study.run;
  const Refinements times = refinements(study, level);
  if (study.refinement != Refinement::directions)
    request.overrides.push_back(study.nested || input.mesh.file ? split_mesh(input, times.mesh)
                                                                : refined_mesh(input, times.mesh));
  if (study.refinement != Refinement::mesh)
    request.overrides.push_back(refined_directions(input, times.directions));
  const std::filesystem::path folder =
      std::filesystem::absolute(input.output.directory) / fmt::format("level-{}", level);
  request.overrides.push_back("output.directory=" + Json(folder.string()).dump());
  return request;
}

LevelResult level_result(const RunResult& run, int level, Refinement refinement) {
  LevelResult result;
  result.level = level;
  result.converged = run.solution.converged();
  result.cells = run.problem.mesh().cell_count();
  double volume = 0;
  for (const double cell : run.problem.mesh().volumes()) volume += cell;
  result.size = std::cbrt(volume / result.cells);
  result.directions = run.solution.directions;
  result.space = run.input.angular_space;
  for (const BandConvergence& band : run.solution.convergence) {
    result.sweeps = std::max(result.sweeps, band.sweeps);
    result.residual = std::max(result.residual, band.residual);
  }
  result.seconds = run.seconds.total;
  result.memory = static_cast<double>(peak_memory());
  result.values = Values(run, refinement).all();
  return result;
}

void save_level(const LevelResult& result, const Case& input, Refinement refinement) {
  Json json = {{"case", input.resolved_toml},
               {"refined", name_of(refinement)},
               {"converged", result.converged},
               {"cells", result.cells},
               {"h", result.size},
               {"directions", result.directions},
               {"sweeps", result.sweeps},
               {"residual", result.residual},
               {"seconds", result.seconds},
               {"memory", result.memory},
               {"values", Json::array()}};
  for (const StudyValue& value : result.values) json["values"].push_back(value_json(value));
  OutputFolder folder(input.output.directory);
  folder.add_text(file_name, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  folder.publish({});
}

std::optional<LevelResult> saved_level(const Case& input, int level, Refinement refinement) {
  const Json json = parsed(input.output.directory / file_name);
  if (!json.is_object() || json.value("case", Json()) != input.resolved_toml || !is_whole(input)) return {};
  try {
    if (json.at("refined") != name_of(refinement)) return {};
    LevelResult result{.level = level,
                       .converged = json.at("converged"),
                       .cells = json.at("cells"),
                       .size = json.at("h"),
                       .directions = json.at("directions"),
                       .space = input.angular_space,
                       .sweeps = json.at("sweeps"),
                       .residual = json.at("residual"),
                       .seconds = json.at("seconds"),
                       .memory = json.at("memory"),
                       .values = {}};
    for (const Json& value : json.at("values"))
      result.values.push_back(
          {value.at("band"), value.at("quantity"), value.at("value"),
           value.at("exact").is_null() ? std::nullopt : std::optional<double>(value.at("exact"))});
    return result;
  } catch (const Json::exception&) {
    return {};  // not a file of ours
  }
}

}  // namespace etendue
