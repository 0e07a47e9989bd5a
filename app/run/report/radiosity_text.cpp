// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/radiosity_text.h"

#include <fmt/format.h>

#include "app/progress/text_table.h"
#include "app/write/result/unit_labels.h"

namespace etendue {
namespace {

// Rows of passes that a person reads; the rest is in passes.csv.
constexpr std::size_t longest_pass_table = 24;

std::string checks_text(const RadiosityReport& report) {
  const FactorChecks& checks = report.checks;
  TextTable table({"what holds of form factors", "largest deviation"}, {Align::left, Align::right});
  const auto add = [&](const char* what, double deviation) {
    table.add_row({what, fmt::format("{:.2g}", deviation)});
  };
  add("rows sum to one, as found", checks.row_sum);
  add("rows sum to one, on the mean", checks.row_sum_mean);
  add(checks.closing_passes > 1 ? "rows sum to one, closed" : "rows sum to one, kept", checks.closed_row_sum);
  add("A_j F_jk = A_k F_kj, found both ways", checks.reciprocity);
  add("F_jj = 0", checks.self);
  add("F to a patch = sum of F to its parts", checks.additivity);
  if (report.extended_entries > 0) {
    const ExtendedClosing& closing = report.extended_closing;
    add("over mirrors and glossy walls all light of a patch stays somewhere, as found", closing.row_sum);
    add("the same, on the mean (more radiosity.path_rays bring it down)", closing.row_sum_mean);
    add("the same, closed", closing.closed_row_sum);
  }
  return "\nform factors\n" + table.text();
}

std::string passes_text(const RunResult& result) {
  const std::vector<Bounce>& bounces = result.radiosity->bounces;
  if (bounces.empty()) return "";
  TextTable table({"pass", "band", "exitant", "incident", "redirected", "deposit"},
                  {Align::right, Align::left, Align::right, Align::right, Align::right, Align::right});
  for (std::size_t i = 0; i < std::min(bounces.size(), longest_pass_table); ++i)
    table.add_row({fmt::to_string(bounces[i].pass), result.problem.bands().names[bounces[i].band],
                   number(bounces[i].exitant), number(bounces[i].incident), number(bounces[i].redirected),
                   number(bounces[i].deposit)});
  return fmt::format("\npasses from wall to wall [{}]{}\n", UnitLabels(result.input.units).power,
                     bounces.size() > longest_pass_table ? ", the first (all: passes.csv)" : "") +
         table.text();
}

}  // namespace

std::string radiosity_text(const RunResult& result) {
  if (!result.radiosity) return "";
  const RadiosityReport& report = *result.radiosity;
  std::string text;
  for (const std::string& note : result.solution.notes) text += "  " + note + "\n";
  text += fmt::format(
      "  {} patches of {:.3g} to {:.3g}; {}\n", report.patches, report.smallest_area, report.largest_area,
      report.convex ? "nothing can stand between them" : "what stands between them is found by rays");
  if (report.links > 0)
    text += fmt::format("  {} links between groups of patches, {:.3g} for each patch, after {} rounds\n",
                        report.links, static_cast<double>(report.links) / static_cast<double>(report.patches),
                        report.link_rounds.size());
  if (report.extended_entries > 0)
    text += fmt::format("  mirrors and glossy walls connect a patch with {:.3g} others, on the mean\n",
                        static_cast<double>(report.extended_entries) / static_cast<double>(report.patches));
  text += fmt::format(
      "  seconds: {:.3g} for form factors, {:.3g} for the solution, {:.3g} for the field in cells\n",
      report.factor_seconds, report.solve_seconds, report.field_seconds);
  text += checks_text(report) + passes_text(result);
  TextTable table({"band", "still on its way [%]", "passes", ""},
                  {Align::left, Align::right, Align::right, Align::left});
  for (std::size_t b = 0; b < result.solution.convergence.size(); ++b) {
    const BandConvergence& band = result.solution.convergence[b];
    table.add_row({result.problem.bands().names[b], fmt::format("{:.2g}", 100 * band.residual),
                   fmt::to_string(band.sweeps), band.converged ? "converged" : "NOT converged"});
  }
  return text + "\nradiosity\n" + table.text();
}

}  // namespace etendue
