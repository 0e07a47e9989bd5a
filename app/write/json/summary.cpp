// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/json/summary.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/write/result/balance_check.h"
#include "app/write/result/beam_power.h"
#include "app/write/result/commit.h"
#include "app/write/result/lamp_light.h"
#include "app/write/result/negative_fluence.h"
#include "app/write/result/program_version.h"
#include "app/write/result/stage_seconds.h"

namespace etendue {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* program_name = "etendue";

template <class Items, class Convert>
Json array_of(const Items& items, Convert convert) {
  Json array = Json::array();
  for (const auto& item : items) array.push_back(convert(item));
  return array;
}

Json as_json(const Balance& balance) {
  return {{"emitted", balance.emitted},
          {"inflow", balance.inflow},
          {"absorbed", balance.absorbed},
          {"outflow", balance.outflow},
          {"residual", balance.residual}};
}

Json as_json(const RunErrors& errors) {
  const PhotonReport& report = errors.report;
  return {{"histories", errors.histories},
          {"error", report.error},
          {"cell_error", report.cell_error},
          {"figure_of_merit", report.figure},
          {"photons_per_ms", report.seconds > 0 ? 1e-3 * report.histories / report.seconds : 0},
          {"steps", report.segments},
          {"collisions", report.collisions},
          {"lost", report.lost},
          {"balance_error", array_of(errors.balances, [](const Balance& b) { return as_json(b); })}};
}

Json as_json(const ExtendedClosing& closing, std::size_t pairs) {
  return {{"pairs", pairs},
          {"row_sum_error", closing.row_sum},
          {"row_sum_error_mean", closing.row_sum_mean},
          {"row_sum_error_closed", closing.closed_row_sum},
          {"closing_passes", closing.passes}};
}

Json as_json(const RunRanks& ranks) {
  return {{"count", ranks.count},
          {"exchange_seconds", ranks.of_first.seconds},
          {"sent_bytes", ranks.of_first.bytes},
          {"exchanges", ranks.of_first.exchanges}};
}

Json as_json(const RadiosityReport& report) {
  const FactorChecks& checks = report.checks;
  return {{"patches", report.patches},
          {"patches_by_round", report.rounds},
          {"smallest_patch", report.smallest_area},
          {"largest_patch", report.largest_area},
          {"convex", report.convex},
          {"matrix_kept", report.kept},
          {"links", report.links},
          {"links_by_round", report.link_rounds},
          {"row_sum_error", checks.row_sum},
          {"row_sum_error_mean", checks.row_sum_mean},
          {"row_sum_error_closed", checks.closed_row_sum},
          {"closing_passes", checks.closing_passes},
          {"reciprocity_error", checks.reciprocity},
          {"self_factor", checks.self},
          {"additivity_error", checks.additivity},
          {"extended",
           report.extended_entries > 0 ? as_json(report.extended_closing, report.extended_entries) : Json()},
          {"passes", report.passes},
          {"seconds",
           {{"factors", report.factor_seconds},
            {"solution", report.solve_seconds},
            {"fields", report.field_seconds}}}};
}

Json as_json(const StepsInTime& steps) {
  double error = 0;
  for (const StepInTime& step : steps.steps) {
    error = std::max(error, step.error);
  }
  return {{"steps", steps.steps.size()},    {"until", steps.steps.empty() ? 0 : steps.steps.back().end},
          {"sweeps", steps.sweeps},         {"error", error},
          {"imbalance", steps.imbalance()}, {"frames", steps.frames.size()}};
}

Json as_json(const TimeResult& time) {
  Json json = {{"rates", time.rates},
               {"sweeps", time.sweeps},
               {"residual", time.residual},
               {"converged", time.converged}};
  if (time.steps) json["march"] = as_json(*time.steps);
  return json;
}

Json as_json(const UncollidedBalance& balance) {
  return {{"sent", balance.sent},           {"absorbed", balance.absorbed}, {"collided", balance.collided},
          {"reflected", balance.reflected}, {"kept", balance.kept},         {"residual", balance.residual}};
}

Json as_json(const KernelReport& kernel) {
  return {{"medium", kernel.medium},
          {"band", kernel.band},
          {"asymmetry", kernel.asymmetry},
          {"energy_error", kernel.energy_error},
          {"momentum_error", kernel.momentum_error},
          {"reciprocity_error", kernel.reciprocity_error},
          {"integral_error", kernel.integral_error},
          {"backend", kernel.backend},
          {"phase", kernel.phase},
          {"smallest", kernel.smallest},
          {"negative_share", kernel.negative_share},
          {"forward", {kernel.smallest_forward, kernel.largest_forward}}};
}

Json as_json(const LampLight& lamp) {
  return {{"name", lamp.name},
          {"power", lamp.power},
          {"luminous_flux", lamp.luminous_flux},
          {"luminous_efficacy", lamp.efficacy}};
}

Json as_json(const Daylight& day) {
  Json json = {{"name", day.name}, {"level_irradiance", day.irradiance}};
  if (day.illuminance >= 0) json["level_illuminance"] = day.illuminance;
  if (!day.note.empty()) json["note"] = day.note;
  return json;
}

Json as_json(const BeamPower& beam) {
  return {{"name", beam.name},           {"power", beam.power},
          {"entering", beam.entering},   {"turned_back", beam.turned_back},
          {"beside_walls", beam.beside}, {"behind_symmetry_planes", beam.behind_symmetry}};
}

Json as_json(const NegativeFluence& negative) {
  Json json = {{"count", negative.count}, {"smallest", negative.smallest}, {"share", negative.share}};
  if (negative.count > 0) json["place"] = {negative.place.x(), negative.place.y(), negative.place.z()};
  return json;
}

/// Whether a listed name is a plain file name: nothing outside the directory may be removed.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos;
}

/// The summary.json of an earlier run; an empty object where there is none, or where it is not ours.
Json summary_in(const std::filesystem::path& directory) {
  std::ifstream stream(directory / "summary.json");
  Json summary = Json::parse(stream, nullptr, false);
  if (!summary.is_object() || summary.value("program", Json()) != program_name) return Json::object();
  return summary;
}

// Names from foreign mesh files need not be UTF-8.
std::string summary_text(const Json& summary) {
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Names that a summary lists, and more.
void add_file_names(const std::vector<std::string>& more, Json& summary) {
  Json& names = summary["files"];
  if (!names.is_array()) names = Json::array();
  for (const std::string& name : more)
    if (std::count(names.begin(), names.end(), Json(name)) == 0) names.push_back(name);
}

/// A stage after the writing; the total stays the last.
void add_stage(const char* stage, double taken, Json& summary) {
  if (!summary["seconds"].is_object() || !summary["seconds"].value("total", Json()).is_number()) return;
  Json& seconds = summary["seconds"];
  const double total = seconds["total"];
  seconds.erase("total");
  seconds[stage] = taken;
  seconds["total"] = total + taken;
}

}  // namespace

long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;  // Linux counts KiB
}

void restart_peak_memory() { std::ofstream("/proc/self/clear_refs") << "5\n"; }

std::string summary_json(const RunResult& result, const std::vector<std::string>& files,
                         double seconds_writing) {
  const Solution& solution = result.solution;
  Json summary;
  summary["title"] = result.input.title;
  summary["program"] = program_name;
  summary["version"] = program_version();
  summary["commit"] = program_commit();
  summary["date"] = iso_date(result.record.begun);
  summary["host"] = host_name();
  summary["process"] = getpid();
  summary["command_line"] = result.record.command_line;
  summary["method"] = solution.method;
  summary["cells"] = result.problem.mesh().cell_count();
  summary["directions"] = solution.directions;
  summary["direction_set"] = {{"set", result.input.direction_set}, {"order", result.input.direction_order}};
  summary["bands"] = result.problem.bands().names;
  summary["units"] = {{"length", result.input.units.length}, {"power", result.input.units.power}};
  summary["threads"] = result.threads;
  if (result.ranks) summary["ranks"] = as_json(*result.ranks);
  summary["converged"] = solution.converged();
  summary["interrupted"] = result.interrupted();
  if (!result.left_out.empty()) summary["left_out"] = result.left_out;
  summary["balanced"] = is_balanced(result);
  summary["tolerance"] = result.input.solve.tolerance;
  summary["balance_tolerance"] = result.input.balance_tolerance;
  summary["sweeps"] = array_of(solution.convergence, [](const BandConvergence& c) { return c.sweeps; });
  summary["residual"] = array_of(solution.convergence, [](const BandConvergence& c) { return c.residual; });
  summary["balance"] = array_of(result.balances, [](const Balance& b) { return as_json(b); });
  if (const auto lamps = lamp_lights(result.problem, result.input); !lamps.empty())
    summary["lamps"] = array_of(lamps, [](const LampLight& lamp) { return as_json(lamp); });
  if (const auto days = daylight(result.input); !days.empty())
    summary["daylight"] = array_of(days, [](const Daylight& day) { return as_json(day); });
  if (const auto beams = beam_powers(result.problem, result.input); !beams.empty())
    summary["beams"] = array_of(beams, [](const BeamPower& beam) { return as_json(beam); });
  if (!solution.lights.balance.empty())
    summary["uncollided"] =
        array_of(solution.lights.balance, [](const UncollidedBalance& b) { return as_json(b); });
  if (result.errors) summary["photons"] = as_json(*result.errors);
  if (result.radiosity) summary["radiosity"] = as_json(*result.radiosity);
  if (result.time) summary["time"] = as_json(*result.time);
  summary["negative"] = array_of(negative_fluence(result.problem, solution),
                                 [](const NegativeFluence& n) { return as_json(n); });
  if (!solution.fixups.empty())
    summary["positivity"] = array_of(fixup_totals(solution), [](const FixupTotal& total) {
      return Json{{"cells", total.cells},
                  {"failed", total.failed},
                  {"smallest", total.smallest},
                  {"moved", total.moved}};
    });
  summary["kernels"] = array_of(solution.kernels, [](const KernelReport& k) { return as_json(k); });
  if (result.exact)
    summary["exact"] = array_of(result.exact->fluence, [](const FluenceError& error) {
      return Json{{"fluence_L2", error.l2}, {"fluence_Linf", error.linf}};
    });
  summary["lagged_faces"] = solution.lagged_faces;
  for (const auto& [name, seconds] : stage_seconds(result, seconds_writing))
    summary["seconds"][name] = seconds;
  summary["sweep_cost"] = solution.sweep_cost;
  summary["peak_memory"] = peak_memory();
  summary["notes"] = solution.notes;
  summary["files"] = files;
  summary["case_file"] = std::filesystem::absolute(result.input.file).string();
  summary["case"] = result.input.resolved_toml;
  return summary_text(summary);
}

std::vector<std::string> files_of_earlier_run(const std::filesystem::path& directory,
                                              const std::string& folder) {
  const Json summary = summary_in(directory);
  const std::string beginning = folder.empty() ? "" : folder + "/";
  std::vector<std::string> names;
  for (const Json& entry : summary.value("files", Json::array())) {
    if (!entry.is_string()) continue;
    const auto name = entry.get<std::string>();
    if (name.starts_with(beginning) && is_plain_name(name.substr(beginning.size())))
      names.push_back(name.substr(beginning.size()));
  }
  return names;
}

std::string summary_with_files(const std::filesystem::path& directory, const std::vector<std::string>& more,
                               std::optional<double> seconds_of_pictures) {
  Json summary = summary_in(directory);
  if (summary.empty()) return "";
  add_file_names(more, summary);
  if (seconds_of_pictures) add_stage("pictures", *seconds_of_pictures, summary);
  return summary_text(summary);
}

std::string summary_with_estimate(const std::filesystem::path& directory, const std::string& estimate,
                                  double seconds) {
  Json summary = summary_in(directory);
  if (summary.empty()) return "";
  add_file_names({"estimate.csv"}, summary);
  add_stage("estimate", seconds, summary);
  summary["estimate"] = Json::parse(estimate);
  return summary_text(summary);
}

std::string summary_with_accuracy(const std::filesystem::path& directory, const std::string& accuracy) {
  Json summary = summary_in(directory);
  if (summary.empty()) return "";
  add_file_names({"accuracy.csv"}, summary);
  summary["accuracy"] = Json::parse(accuracy);
  return summary_text(summary);
}

bool holds_other_run(const std::filesystem::path& directory) {
  const Json summary = summary_in(directory);
  return !summary.empty() &&
         (summary.value("host", Json()) != host_name() || summary.value("process", Json()) != getpid());
}

std::optional<SavedCase> case_of_earlier_run(const std::filesystem::path& directory) {
  const Json summary = summary_in(directory);
  const Json text = summary.value("case", Json()), file = summary.value("case_file", Json());
  if (!text.is_string() || !file.is_string()) return std::nullopt;
  return SavedCase{text.get<std::string>(), file.get<std::string>()};
}

}  // namespace etendue
