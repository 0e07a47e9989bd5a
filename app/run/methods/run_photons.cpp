// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/methods/run_photons.h"

#include <fmt/format.h>

#include <optional>
#include "app/progress/photon_progress.h"
#include "app/readings/probes.h"
#include "app/run/methods/photon_numbers.h"
#include "app/setup/method_checks.h"
#include "app/setup/run_context.h"
#include "app/write/vtk/solution_file.h"
#include "solver/photons/solve/photon_mesh.h"
#include "solver/photons/solve/probe_histories.h"
#include "solver/solution/solve_observer.h"

namespace etendue {
namespace {

std::vector<PhotonProbe> probe_points(const std::vector<Probe>& probes) {
  std::vector<PhotonProbe> points;
  for (const Probe& probe : probes)
    for (const Vec3& point : probe.points) points.push_back({point, probe.normal});
  return points;
}

/// The numbers of all probe points in a batch's field: [point][band][fluence, flux x, y, z].
std::vector<double> field_at_probes(const std::vector<PhotonProbe>& points, const PhotonRunInput& run,
                                    const Solution& fields) {
  std::vector<double> numbers;
  for (const PhotonProbe& point : points)
    for (const ProbeValue& value : probe(run.problem, fields, run.locator, point.point)) {
      numbers.push_back(value.fluence);
      numbers.insert(numbers.end(), value.net_flux.begin(), value.net_flux.end());
    }
  return numbers;
}

/// Values of probes with their errors, from the field of the cells or from histories that start there.
class ProbeRows {
 public:
  explicit ProbeRows(const PhotonRunInput& run) : run_(run) {
    for (const Probe& place : run.input.probes)
      for (std::size_t i = 0; i < place.points.size(); ++i)
        rows_.push_back({place.name, static_cast<int>(i), place.points[i], {}, {}, {}, ProbeErrors{}});
  }

  std::vector<ProbeRow> from_field(const BatchStatistics& derived, std::size_t first) {
    const auto bands = static_cast<std::size_t>(run_.problem.band_count());
    for (ProbeRow& row : rows_)
      for (std::size_t b = 0; b < bands; ++b, first += 4) {
        const auto value = [&](auto number) {
          return ProbeValue{number(0), {number(1), number(2), number(3)}};
        };
        row.values.push_back(value([&](std::size_t i) { return derived.mean(first + i); }));
        row.errors->values.push_back(value([&](std::size_t i) { return derived.error(first + i); }));
      }
    return std::move(rows_);
  }

  /// Without the probes that have no estimates.
  std::vector<ProbeRow> from(const std::vector<std::vector<ProbeEstimate>>& estimates) {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (const ProbeEstimate& found : estimates[i]) {
        const auto& flux = found.net_flux;
        rows_[i].values.push_back({found.fluence.value, {flux[0].value, flux[1].value, flux[2].value}});
        rows_[i].errors->values.push_back(
            {found.fluence.error, {flux[0].error, flux[1].error, flux[2].error}});
        if (!found.irradiance) continue;
        if (!rows_[i].irradiance) rows_[i].irradiance = rows_[i].errors->irradiance.emplace();
        rows_[i].irradiance->push_back(found.irradiance->value);
        rows_[i].errors->irradiance->push_back(found.irradiance->error);
      }
    std::erase_if(rows_, [](const ProbeRow& row) { return row.values.empty(); });
    return std::move(rows_);
  }

 private:
  const PhotonRunInput& run_;
  std::vector<ProbeRow> rows_;
};

RunErrors errors_of(const PhotonRunInput& run, const PhotonSolution& found) {
  RunErrors errors;
  errors.fluence = found.sums.fluence.errors();
  errors.fluence_mean = found.sums.cell_means.errors();
  errors.net_flux = found.sums.net_flux.errors();
  errors.irradiance = found.sums.irradiance.errors();
  MeasuredNumbers numbers(run.problem, found.solution);
  numbers.assign(found.sums.derived.errors());
  errors.walls = std::move(numbers.walls);
  errors.net = std::move(numbers.net);
  errors.regions = std::move(numbers.regions);
  errors.balances = std::move(numbers.balances);
  errors.report = found.report;
  errors.histories = static_cast<double>(found.sums.histories);
  return errors;
}

PhotonSums sums_to_start_from(const PhotonRunInput& run, std::ostream& out) {
  const SavedState state = read_initial(*run.input.initial, run.input, run.problem.mesh());
  out << "adds to " << run.input.initial->path.string() << std::endl;
  return PhotonSums::unpacked(state.photons);
}

PhotonOptions options_of(const PhotonRunInput& run) {
  const PhotonCase& wanted = *run.input.photons;
  PhotonOptions options;
  options.photons = wanted.photons;
  options.until = wanted.until;
  options.seed = static_cast<std::uint64_t>(wanted.seed);
  options.threads = run.threads;
  options.ranks = run.ranks;
  return options;
}

/// Before the first batch is whole a signal ends the program at once: there is nothing to keep.
PhotonSolution walk_visibly(const PhotonRunInput& run, const PhotonOptions& options,
                            const BatchReader& reader) {
  std::optional<ShownStage> setting_up(std::in_place, run.stages, "setting up photons");
  PhotonDisplay display(run.stages.style, run.stages.out);
  PhotonSolution found = solve_photons(
      run.problem, run.locator, options,
      [&](const PhotonProgress& progress) {
        setting_up.reset();
        if (progress.batches > 0) run.interruption.note_the_first();
        display.show(progress);
        return run.interruption.noted() ? SolveControl::stop : SolveControl::proceed;
      },
      reader);
  setting_up.reset();
  display.finish();
  return found;
}

/// From histories that start there, or, where none can go back, from the field of the cells.
void add_probes(const PhotonRunInput& run, const std::vector<PhotonProbe>& points,
                const BatchStatistics& derived, PhotonRun& result) {
  ProbeRows rows(run);
  const std::size_t numbers = 4 * points.size() * static_cast<std::size_t>(run.problem.band_count());
  if (!can_walk_back(run.problem)) {
    result.probes = rows.from_field(derived, derived.size() - numbers);
    return;
  }
  if (points.empty()) return;
  const PhotonCase& wanted = *run.input.photons;
  result.probes =
      rows.from(walk_back_from(points, run.problem, run.locator,
                               {wanted.probe_photons, static_cast<std::uint64_t>(wanted.seed), run.threads},
                               ShownStage(run.stages, "probes").observer()));
  result.walked_back = wanted.probe_photons;
  run.stages.out << fmt::format("probes: {:.3g} histories walked back from each of {} points\n",
                                wanted.probe_photons, result.probes.size());
}

}  // namespace

void check_for_photons(const Case& input, const Problem& problem) {
  refuse_for_photons(problem);
  refuse_what_needs_ordinates(input, "photons have",
                              "its source is made for the ordinates of a set, and photons have none");
}

PhotonRun run_photons(const PhotonRunInput& run) {
  Stopwatch watch;
  const std::vector<PhotonProbe> points = probe_points(run.input.probes);
  PhotonOptions options = options_of(run);
  PhotonSums initial;
  if (run.input.initial) {
    initial = sums_to_start_from(run, run.stages.out);
    options.initial = &initial;
  }
  PhotonSolution found = walk_visibly(run, options, [&](const Solution& batch) {
    std::vector<double> numbers = MeasuredNumbers(run.problem, batch).list();
    const std::vector<double> probes = field_at_probes(points, run, batch);
    numbers.insert(numbers.end(), probes.begin(), probes.end());
    return numbers;
  });
  found.solution.seconds.sweep = watch.lap();
  PhotonRun result{std::move(found.solution), {}, {}};
  add_probes(run, points, found.sums.derived, result);
  result.probe_seconds = watch.lap();
  result.errors = errors_of(run, {result.solution, std::move(found.sums), std::move(found.report)});
  return result;
}

}  // namespace etendue
