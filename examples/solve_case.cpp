// SPDX-License-Identifier: AGPL-3.0-or-later
// Solves a case file and prints its balance, walls and probes:
//   solve_case CASE.toml [KEY=VALUE]...
#include <cstdio>

#include <etendue/etendue.h>

namespace {

bool show(const etendue::Progress& progress) {
  if (progress.sweep == 0)
    std::fprintf(stderr, "%s\n", progress.stage.c_str());
  else
    std::fprintf(stderr, "  sweep %d: residual %.2e\n", progress.sweep, progress.residual.front());
  return true;
}

void print(const etendue::Solution& solution) {
  std::printf("%d cells, %s\n", solution.mesh().cell_count(),
              solution.converged() ? "converged" : "not converged");
  for (const etendue::BandBalance& band : solution.balances())
    std::printf("%s: emitted %.6g, absorbed %.6g, balance off by %.1e\n", band.band.c_str(),
                band.emitted + band.inflow, band.absorbed + band.outflow, band.residual);
  for (const etendue::WallTotals& wall : solution.walls())
    std::printf("wall %s, %s: %.6g on %.6g\n", wall.wall.c_str(), wall.band.c_str(), wall.incoming,
                wall.area);
  for (const etendue::ProbeReading& probe : solution.probes())
    std::printf("probe %s[%d], %s: fluence %.17g\n", probe.probe.c_str(), probe.index, probe.band.c_str(),
                probe.fluence);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) return std::fprintf(stderr, "usage: solve_case CASE.toml [KEY=VALUE]...\n"), 2;
  try {
    const auto input = etendue::Case::from_file(arguments[1], {arguments + 2, arguments + count});
    print(etendue::solve(input, {.progress = show}));
  } catch (const etendue::InputError& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 2;
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 3;
  }
}
