// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/results.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "app/case/temperatures.h"
#include "app/write/csv/sensor_files.h"
#include "app/write/csv/tables.h"
#include "app/write/csv/time_tables.h"
#include "app/write/json/summary.h"
#include "app/write/parents/foam_fields.h"
#include "app/write/result/output_folder.h"
#include "app/write/vtk/solution_file.h"
#include "app/write/vtk/vtk_files.h"

namespace etendue {

namespace {

/// The walls after each of the first passes, and a file that plays them one after the other.
void add_passes(const RunResult& result, OutputFolder& folder) {
  std::string series;
  for (std::size_t i = 0; i < result.passes.size(); ++i) {
    const std::string name = fmt::format("walls_pass{}.vtp", i + 1);
    const RunResult pass{.input = result.input,
                         .problem = result.problem,
                         .solution = result.passes[i],
                         .probes = {},
                         .balances = {},
                         .walls = {},
                         .regions = {},
                         .patches = result.patches ? std::optional(result.pass_patches[i]) : std::nullopt,
                         .seconds = {}};
    write_walls(pass, folder.add(name), result.input.output.directory / name);
    series += fmt::format("{}\n    {{\"name\": \"{}\", \"time\": {}}}", i > 0 ? "," : "", name, i + 1);
  }
  folder.add_text("walls.vtp.series",
                  "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [" + series + "\n  ]\n}\n");
}

void add_steps(const RunResult& result, OutputFolder& folder) {
  const StepsInTime& steps = *result.time->steps;
  folder.add_text("steps.csv", steps_csv(result));
  if (steps.frames.empty()) return;
  for (std::size_t i = 0; i < steps.frames.size(); ++i)
    write_frame(result, steps.frames[i], folder.add(frame_name(steps, i)),
                result.input.output.directory / frame_name(steps, i));
  folder.add_text(steps.of + ".pvd", frames_pvd(steps));
}

/// The folder `openfoam` of a run on the mesh of an OpenFOAM case, which is published before the others.
class FoamFolder {
 public:
  FoamFolder(const RunResult& result, const std::filesystem::path& directory) : directory_(directory) {
    for (const FoamFieldFile& file : foam_fields(result)) {
      if (!folder_) folder_.emplace(directory / name_);
      folder_->add_text(file.name, file.text);
      files_.push_back(name_ + ("/" + file.name));
    }
  }

  const std::vector<std::string>& files() const { return files_; }

  /// Removes those of an earlier run where this one has none.
  void publish() {
    const std::vector<std::string> earlier = files_of_earlier_run(directory_, name_);
    if (folder_) return folder_->publish(earlier);
    std::error_code ignored;
    for (const std::string& name : earlier) std::filesystem::remove(directory_ / name_ / name, ignored);
    if (!earlier.empty()) std::filesystem::remove(directory_ / name_, ignored);  // where it is empty
  }

 private:
  static constexpr const char* name_ = "openfoam";
  const std::filesystem::path& directory_;
  std::optional<OutputFolder> folder_;
  std::vector<std::string> files_;
};

}  // namespace

WrittenResults write_results(const RunResult& result) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const std::filesystem::path& directory = result.input.output.directory;

  OutputFolder folder(directory);
  write_fields(result, folder.add("fields.vtu"), directory / "fields.vtu");
  write_walls(result, folder.add("walls.vtp"), directory / "walls.vtp");
  if (result.problem.mesh().parents().mesh)
    write_parents(result, folder.add("cells.vtu"), directory / "cells.vtu");
  FoamFolder foam(result, directory);
  if (!result.solution.state.fluence.empty())
    write_solution(result.input, result.problem, result.solution.state, result.solution.direction_error,
                   folder.add("solution.vtu"), directory / "solution.vtu");
  if (!result.probes.empty()) folder.add_text("probes.csv", probes_csv(result));
  add_sensor_files(result, folder);
  folder.add_text("walls.csv", walls_csv(result));
  folder.add_text("regions.csv", regions_csv(result));
  if (result.time && !result.time->modulated.empty()) {
    folder.add_text("frequency.csv", frequency_csv(result));
    write_modulation(result, folder.add("modulation.vtu"), directory / "modulation.vtu");
  }
  if (result.time && !result.time->histories.empty()) folder.add_text("times.csv", times_csv(result));
  if (result.time && !result.time->flight_times.empty())
    folder.add_text("flight_times.csv", flight_times_csv(result));
  if (result.time && result.time->steps) add_steps(result, folder);
  if (has_temperatures(result.input)) folder.add_text("heat.csv", heat_csv(result));
  if (result.radiosity) folder.add_text("form_factors.csv", form_factors_csv(result));
  if (result.radiosity && !result.radiosity->bounces.empty())
    folder.add_text("passes.csv", passes_csv(result));
  if (!result.passes.empty()) add_passes(result, folder);
  if (!result.solution.fixups.empty()) folder.add_text("positivity.csv", positivity_csv(result));
  folder.add_text("history.csv", history_csv(result));
  std::vector<std::string> names = folder.names();
  names.push_back("summary.json");
  names.insert(names.end(), foam.files().begin(), foam.files().end());
  folder.add_text("summary.json", summary_json(result, names, seconds()));
  folder.lock();
  foam.publish();
  folder.publish(files_of_earlier_run(directory));
  return {directory, names, seconds()};
}

}  // namespace etendue
