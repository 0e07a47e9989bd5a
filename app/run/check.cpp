// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

#include "app/case/build/build.h"
#include "app/case/temperatures.h"
#include "app/progress/interruption.h"
#include "app/progress/progress.h"
#include "app/progress/stage_progress.h"
#include "app/progress/text_table.h"
#include "app/request/commands.h"
#include "app/request/verbose_log.h"
#include "app/run/check_run.h"
#include "app/run/memory_forecast.h"
#include "app/run/report/field_text.h"
#include "app/run/report/lamp_text.h"
#include "app/run/report/phase_text.h"
#include "app/run/report/resolution_text.h"
#include "app/setup/deprecation_notes.h"
#include "app/setup/output_memory.h"
#include "app/setup/run_context.h"
#include "app/write/vtk/solution_file.h"
#include "mesh/tetrahedra/mesh_report.h"

namespace etendue {
namespace {

std::string geometry_text(const MeshCase& mesh) {
  if (mesh.file) return "tetrahedra of " + mesh.file->path.string();
  if (mesh.labels) return "voxels of " + mesh.labels->file.path.string();
  if (mesh.surface) return "surface " + mesh.surface->path.string();
  return fmt::format("{} primitives, {} patches", mesh.geometry.primitives.size(),
                     mesh.geometry.patches.size());
}

template <class Entry>
std::string names_of(const std::map<std::string, Entry>& entries) {
  std::vector<std::string> names;
  names.reserve(entries.size());
  for (const auto& [name, entry] : entries) names.push_back(name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string probes_line(const std::vector<Probe>& probes) {
  std::size_t points = 0;
  for (const Probe& probe : probes) points += probe.points.size();
  return fmt::format("{} with {} points", probes.size(), points);
}

std::string summary_of(const Case& input) {
  TextTable table({"title", input.title}, {Align::left, Align::left});
  table.add_row({"units", input.units.length + ", " + input.units.power});
  table.add_row({"geometry", geometry_text(input.mesh)});
  table.add_row({"bands", fmt::format("{}", fmt::join(input.bands.names, ", "))});
  table.add_row({"media", names_of(input.media)});
  table.add_row({"walls", names_of(input.walls)});
  for (const std::string& phase : phase_texts(input)) table.add_row({"scattering in", phase});
  const DirectionSet directions = build_directions(input);
  table.add_row(
      {"directions", fmt::format("{} {}: {}{}", directions.name(), directions.order(), directions.count(),
                                 input.rotations > 1 ? fmt::format(", {} rotations", input.rotations) : "")});
  if (input.first_collided) {
    const DirectionSet first = make_directions(input.first_collided->set, input.first_collided->order);
    const std::string& reason = input.first_collided->reason;
    table.add_row(
        {"of light that collided once", fmt::format("{} {}: {}{}", first.name(), first.order(), first.count(),
                                                    reason.empty() ? "" : " (" + reason + ")")});
  }
  table.add_row({"solve", fmt::format("tolerance {}, at most {} sweeps", input.solve.tolerance,
                                      input.solve.max_sweeps)});
  table.add_row({"probes", probes_line(input.probes)});
  table.add_row({"output", fmt::format("{} ({})", input.output.directory.string(),
                                       fmt::join(input.output.fields, ", "))});
  return table.text();
}

}  // namespace

ExitCode check_case(const CheckRequest& request, std::ostream& out, std::ostream& err) {
  const Interruption interruption;
  const Case input = read_case(request.file, request.overrides);
  check_output_memory(input);
  write_deprecations(input, err);
  if (request.phase) {
    out << phase_values(input);
    return ExitCode::done;
  }
  check_kernels(input);
  if (input.initial) check_initial(*input.initial, input);
  const Log log = verbose_log(request, err);
  const StageDisplay stages{resolved_style(ProgressStyle::automatic, err), err, {}};
  // What a run refuses does not depend on the size of cells.
  const Case meshed = request.mesh ? input : with_coarsest_cells(input);
  const TetrahedralMesh mesh = mesh_visibly(meshed, log, stages);
  std::optional<ShownStage> setting_up(std::in_place, stages, "setting up");
  const Problem problem = build_problem(input, mesh);
  const CheckedRun checked = check_run(input, problem);
  const bool is_meshed = request.mesh || input.mesh.file.has_value();
  std::string memory;
  if (checked.memory)
    memory = is_meshed ? memory_text(*checked.memory, problem)
                       : expected_memory_text(*checked.memory, input, problem, log);
  setting_up.reset();
  out << request.file.string() << " is a valid case\n" << summary_of(input) << lamp_text(problem, input);
  for (const std::string& field : field_texts(input, mesh)) out << field << '\n';
  if (is_meshed) {
    for (const std::string& plan : checked.plans) out << "scattering in " << plan << '\n';
    if (checked.resolution) out << resolution_text(*checked.resolution, !iterates_temperatures(input));
  }
  out << memory;
  if (request.mesh) out << '\n' << to_string(mesh_report(mesh), mesh, input.units.length);
  return ExitCode::done;
}

}  // namespace etendue
