// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/run_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/case/temperatures.h"
#include "app/run/report/report_parts.h"
#include "app/run/report/run_log.h"
#include "app/write/result/balance_check.h"
#include "app/write/result/negative_fluence.h"
#include "app/write/result/stage_seconds.h"
#include "app/write/result/unit_labels.h"

namespace etendue {
namespace {

/// What scattering became: effective mean cosine, energy, signs, and why it is discretised so.
std::string kernel_text(const KernelReport& kernel) {
  std::string text = fmt::format("    {}: {}; effective g {:.6g}, energy to {:.1e}", kernel.phase,
                                 kernel.backend, kernel.asymmetry, kernel.energy_error);
  if (kernel.momentum_error > 0) text += fmt::format(", momentum to {:.1e}", kernel.momentum_error);
  if (kernel.integral_error > 0)
    text += fmt::format(", integrals of the formula to {:.1e}", kernel.integral_error);
  if (kernel.integral_error > unremarkable_integral_error)
    text += fmt::format(" (warning: more than {:.0e}, as kinks and sharp peaks make it)",
                        unremarkable_integral_error);
  if (kernel.largest_forward > 0 || kernel.smallest_forward < 0)
    text += fmt::format("; {:.3g} to {:.3g} of it straight ahead, taken as not scattered",
                        kernel.smallest_forward, kernel.largest_forward);
  if (kernel.negative_share > 0)
    text += fmt::format("; negative down to {:.2g} of the mean, {:.2g} % of all", kernel.smallest,
                        100 * kernel.negative_share);
  return text + "\n";
}

/// Bands that scatter alike stand together.
std::string kernels_text(const std::vector<KernelReport>& kernels) {
  std::string text;
  for (std::size_t i = 0; i < kernels.size();) {
    const std::string what = kernel_text(kernels[i]);
    std::string bands = kernels[i].band;
    std::size_t next = i + 1;
    for (; next < kernels.size() && kernels[next].medium == kernels[i].medium &&
           kernel_text(kernels[next]) == what;
         ++next)
      bands += ", " + kernels[next].band;
    text += fmt::format("  scattering in {}, {} {}\n{}", kernels[i].medium, next - i == 1 ? "band" : "bands",
                        bands, what);
    i = next;
  }
  return text;
}

std::string outcome(const RunResult& result, const BandConvergence& band) {
  if (band.converged) return "converged";
  return result.solution.interrupted ? "interrupted" : "NOT converged";
}

/// What keeping values positive did: cells that had a negative value on the way, and how much was moved.
std::string positivity_text(const RunResult& result) {
  std::string text;
  const std::vector<FixupTotal> totals = fixup_totals(result.solution);
  const UnitLabels units(result.input.units);
  for (std::size_t b = 0; b < totals.size(); ++b) {
    double fluence = 0;
    for (const std::vector<RegionPower>& region : result.regions)
      fluence += region[b].fluence_mean * region[b].volume;
    const double visits =
        static_cast<double>(result.solution.directions) * result.problem.mesh().cell_count();
    text += fmt::format(
        "  kept positive in band {}: {:.3g} % of the cells and directions, smallest {:.3g} {}, moved {:.2g} "
        "% "
        "of the fluence\n",
        band_name(result, b), 100 * static_cast<double>(totals[b].cells) / visits, totals[b].smallest,
        units.radiance, fluence > 0 ? 100 * totals[b].moved / fluence : 0.0);
    if (totals[b].failed > 0)
      text += fmt::format("  {} of them stayed negative: their source is negative\n", totals[b].failed);
  }
  return text;
}

/// Parts of the whole fluence below which negative values do not matter to powers and means, and above which
/// they do.
constexpr double harmless_share = 1e-3, harmful_share = 1e-2;

std::string weight_of_negative(double share) {
  if (share <= harmless_share)
    return "powers and means do not suffer from so little, since each cell keeps its balance; single values "
           "around such places do";
  if (share <= harmful_share)
    return "each cell keeps its balance, so powers hardly suffer; values and means around such places do";
  return "WARNING: that is much; trust no value around such places, and powers there only after a run with "
         "smaller cells";
}

/// How much of the fluence is negative and where, whether it matters, and what helps.
std::string negative_text(const RunResult& result) {
  std::string text;
  double largest = 0;
  const UnitLabels units(result.input.units);
  const std::vector<NegativeFluence> negative = negative_fluence(result.problem, result.solution);
  for (std::size_t b = 0; b < negative.size(); ++b) {
    const NegativeFluence& band = negative[b];
    if (band.count == 0) continue;
    largest = std::max(largest, band.share);
    text += fmt::format(
        "  negative fluence in band {}: {} of {} values, together {:.2g} % of all fluence; smallest {:.3g} "
        "{} "
        "in {} at ({:.4g}, {:.4g}, {:.4g})\n",
        band_name(result, b), band.count, 4L * result.problem.mesh().cell_count(), 100 * band.share,
        band.smallest, units.flux,
        result.problem.mesh().region_names()[static_cast<std::size_t>(band.region)], band.place.x(),
        band.place.y(), band.place.z());
  }
  if (text.empty()) return "";
  const char* rescaling = iterates_temperatures(result.input)
                              ? ""
                              : ", or space.positivity = \"rescale\" where no value may be negative";
  return text + "    " + weight_of_negative(largest) +
         fmt::format("\n    what helps: smaller cells there{} (docs/user/positivity.md)\n", rescaling);
}

}  // namespace

std::string convergence_text(const RunResult& result) {
  const Solution& solution = result.solution;
  std::string text;
  for (const std::string& note : solution.notes) text += "  " + note + "\n";
  text += kernels_text(solution.kernels);
  TextTable table({"band", "sweeps", "residual", ""}, {Align::left, Align::right, Align::right, Align::left});
  for (std::size_t b = 0; b < solution.convergence.size(); ++b) {
    const BandConvergence& band = solution.convergence[b];
    table.add_row({band_name(result, b), std::to_string(band.sweeps), fmt::format("{:.2e}", band.residual),
                   outcome(result, band)});
  }
  return text + titled("iteration (" + solution.method + ")", table);
}

std::string balance_text(const RunResult& result) {
  TextTable table({"band", "emitted", "inflow", "absorbed", "outflow", "residual"},
                  {Align::left, Align::right, Align::right, Align::right, Align::right, Align::right});
  for (std::size_t b = 0; b < result.balances.size(); ++b) {
    const Balance& balance = result.balances[b];
    const Balance error = result.errors ? result.errors->balances[b] : Balance{};
    table.add_row({band_name(result, b), number(balance.emitted, error.emitted),
                   number(balance.inflow, error.inflow), number(balance.absorbed, error.absorbed),
                   number(balance.outflow, error.outflow), fmt::format("{:.1e}", balance.residual)});
  }
  return titled("balance [" + result.input.units.power + "]: emitted + inflow = absorbed + outflow", table) +
         balance_warning(result) + balance_caution(result);
}

std::string uncollided_text(const RunResult& result) {
  const std::vector<UncollidedBalance>& balances = result.solution.lights.balance;
  if (balances.empty()) return "";
  TextTable table(
      {"band", "sent", "absorbed", "collided", "reflected", "kept", "residual"},
      {Align::left, Align::right, Align::right, Align::right, Align::right, Align::right, Align::right});
  for (std::size_t b = 0; b < balances.size(); ++b)
    table.add_row({band_name(result, b), number(balances[b].sent), number(balances[b].absorbed),
                   number(balances[b].collided), number(balances[b].reflected), number(balances[b].kept),
                   fmt::format("{:.1e}", balances[b].residual)});
  return titled(
      "uncollided light [" + result.input.units.power + "]: sent = absorbed + collided + reflected + kept",
      table);
}

std::string exact_text(const RunResult& result) {
  if (!result.exact) return "";
  TextTable table({"band", "L2", "Linf"}, {Align::left, Align::right, Align::right});
  for (std::size_t b = 0; b < result.exact->fluence.size(); ++b)
    table.add_row({band_name(result, b), fmt::format("{:.3e}", result.exact->fluence[b].l2),
                   fmt::format("{:.3e}", result.exact->fluence[b].linf)});
  return titled("relative error of the fluence against the exact solution on these directions", table);
}

std::string cautions_text(const RunResult& result) {
  std::string text = positivity_text(result);
  text += negative_text(result);
  if (result.solution.lagged_faces > 0)
    text += fmt::format("  {} faces, over all directions, were lagged to break cycles of the sweep order\n",
                        result.solution.lagged_faces);
  return text.empty() ? "" : "\n" + text;
}

std::string closing_text(const RunResult& result, const WrittenResults& written) {
  std::string text = "\ntime [s]";
  for (const auto& [name, seconds] : stage_seconds(result, written.seconds))
    if (seconds > 0) text += fmt::format("  {} {:.3g}", name, seconds);
  if (result.solution.sweep_cost == 0)  // by photons or radiosity
    text += fmt::format(" (threads: {})\n", result.threads);
  else
    text +=
        fmt::format(" (threads: {}; a sweep took {:.3g} ns of processor time per cell, direction and band)\n",
                    result.threads, result.solution.sweep_cost);
  const std::string directory = written.directory.string();
  text += "written to " + directory + ":";
  for (const std::string& name : written.files) text += " " + name;
  text += " " + std::string(run_log_name);
  return text + fmt::format("\nopen with: paraview {0}/fields.vtu {0}/walls.vtp\n", directory);
}

}  // namespace etendue
