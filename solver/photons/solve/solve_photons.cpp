// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/solve/solve_photons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>

#include "base/order_statistics.h"
#include "base/parallel/thread_count.h"
#include "base/wall_clock.h"
#include "solver/photons/solve/photon_batch.h"
#include "solver/solution/node_means.h"

namespace etendue {
namespace {

// Batches of a run of a given number of histories: with M of them a standard error is known to 1/sqrt(2 M).
constexpr double wanted_batches = 64;
// Largest number of histories in a batch: what a stopped run has of them is whole batches.
constexpr double largest_batch = 2e5;
// Batches between two looks at the error that was asked for; not by threads, so that none of them counts.
constexpr int batches_of_a_round = 16;

/// A run of histories while it goes on.
class PhotonRun {
 public:
  PhotonRun(const Problem& problem, const CellLocator& locator, const PhotonOptions& options,
            const PhotonObserver& observer, const BatchReader& reader)
      : problem_(problem),
        options_(options),
        observer_(observer),
        reader_(reader),
        bands_(static_cast<std::size_t>(problem.band_count())),
        batches_(problem, locator, options.seed),
        counter_(static_cast<std::size_t>(options.photons) * bands_, [this](double) { return go_on(); }) {
    if (options.initial != nullptr) start_from(*options.initial);
    begun_with_ = static_cast<double>(sums_.histories);
  }

  PhotonSolution solve() {
    while (!stopped_ && left() > 0 && !reached()) {
      walk_round();
      const std::vector<double> error = errors();
      for (std::size_t b = 0; b < bands_; ++b)
        history_.push_back({sums_.fluence.batches(), static_cast<int>(b), error[b]});
    }
    return result();
  }

 private:
  void start_from(const PhotonSums& sums) {
    const std::size_t cells = static_cast<std::size_t>(problem_.mesh().cell_count()) * bands_,
                      faces = static_cast<std::size_t>(problem_.mesh().boundary_face_count()) * bands_;
    if (sums.fluence.size() != 4 * cells || sums.cell_means.size() != cells ||
        sums.net_flux.size() != 12 * cells || sums.irradiance.size() != 3 * faces ||
        sums.face_means.size() != faces)
      throw InputError("the photons to start from are not of this mesh and these bands");
    sums_ = sums;
  }

  double done() const { return static_cast<double>(sums_.histories) - begun_with_; }
  double left() const { return std::max(0.0, std::floor(options_.photons) - done()); }

  bool reached() const {
    if (options_.until <= 0 || sums_.fluence.batches() < 2) return false;
    const std::vector<double> error = errors();
    return std::ranges::all_of(error, [&](double e) { return e <= options_.until; });
  }

  /// With an error to reach, batches grow with the run: their number rises as its logarithm.
  double batch_size() const {
    const double whole = options_.until > 0
                             ? std::max({1024.0, static_cast<double>(sums_.histories) / wanted_batches,
                                         problem_.mesh().cell_count() / 8.0})
                             : options_.photons / wanted_batches;
    return std::clamp(std::ceil(whole), 1.0, largest_batch);
  }

  /// Batches between two looks at the error.
  struct Round {
    double size, rest;
    std::uint64_t first;
    int count;

    std::size_t number(int batch) const {
      return static_cast<std::size_t>(std::min(size, rest - batch * size));
    }
    std::uint64_t begin(int batch) const { return first + static_cast<std::uint64_t>(batch * size); }
  };

  void walk_round() {
    const double size = batch_size(), rest = left();
    const Round round{size, rest, sums_.histories,
                      static_cast<int>(std::min<double>(batches_of_a_round, std::ceil(rest / size)))};
    if (options_.ranks != nullptr) return walk_by_ranks(round, *options_.ranks);
    const int threads = thread_count(options_.threads);
#pragma omp parallel for ordered schedule(static, 1) num_threads(threads)
    for (int i = 0; i < round.count; ++i) {
      const PhotonBatches::Outcome outcome = walk(round, i);
#pragma omp ordered
      add(outcome, round.number(i));
    }
  }

  PhotonBatches::Outcome walk(const Round& round, int batch) {
    if (stopped_) return {};
    return batches_.walk(round.begin(batch), round.number(batch), counter_);
  }

  /// Each rank walks as many batches at a time as it has threads; all of them add all batches in their order.
  void walk_by_ranks(const Round& round, RankGroup& ranks) {
    const int threads = static_cast<int>(ranks.of_first(thread_count(options_.threads)));
    const int at_a_time = threads * ranks.count();
    for (int first = 0; first < round.count; first += at_a_time) {
      const int count = std::min(at_a_time, round.count - first);
      std::vector<PhotonBatches::Outcome> outcomes(static_cast<std::size_t>(count));
      const int begin = std::min(count, ranks.rank() * threads), end = std::min(count, begin + threads);
#pragma omp parallel for schedule(static, 1) num_threads(threads)
      for (int i = begin; i < end; ++i) outcomes[static_cast<std::size_t>(i)] = walk(round, first + i);
      for (int i = begin; i < end; ++i)
        if (outcomes[static_cast<std::size_t>(i)].fields.fluence.empty()) stopped_ = true;
      stopped_ = ranks.any(stopped_);
      for (int i = 0; i < count && !stopped_; ++i) {
        PhotonBatches::Outcome& outcome = outcomes[static_cast<std::size_t>(i)];
        batches_.bring(outcome, ranks, i / threads);
        merge(outcome, round.number(first + i));
        outcome = {};
      }
      if (!stopped_) stopped_ = ranks.any(!tell());
      if (stopped_) return;
    }
  }

  /// Batches behind one that was cut short are left out too: more histories are added behind the last.
  void add(const PhotonBatches::Outcome& outcome, std::size_t number) {
    if (outcome.fields.fluence.empty()) stopped_ = true;
    if (stopped_) return;
    merge(outcome, number);
    if (!tell()) stopped_ = true;
  }

  /// Tells the observer of batches that are whole. Returns whether to continue.
  bool tell() {
    std::vector<double> error = errors();
    const std::lock_guard<std::mutex> lock(telling_);
    whole_ = {sums_.fluence.batches(), static_cast<double>(sums_.histories), std::move(error)};
    return !observer_ || observer_(progress()) == SolveControl::proceed;
  }

  /// Within batches.
  bool go_on() {
    const std::lock_guard<std::mutex> lock(telling_);
    return !stopped_ && (!observer_ || observer_(progress()) == SolveControl::proceed);
  }

  void merge(const PhotonBatches::Outcome& outcome, std::size_t number) {
    const auto weight = static_cast<double>(number);
    const Solution& fields = outcome.fields;
    sums_.fluence.add(fields.fluence, weight);
    sums_.cell_means.add(node_means(fields.fluence, 4, bands_), weight);
    sums_.net_flux.add(fields.net_flux, weight);
    sums_.irradiance.add(fields.irradiance, weight);
    sums_.face_means.add(node_means(fields.irradiance, 3, bands_), weight);
    if (reflects_by_angle_) sums_.exitance.add(fields.exitance, weight);
    if (!fields.absorbed.empty()) sums_.absorbed.add(fields.absorbed, weight);
    if (reader_) add_derived(reader_(fields), weight);
    sums_.histories += number;
    report_.segments += static_cast<double>(outcome.counts.segments);
    report_.collisions += static_cast<double>(outcome.counts.collisions);
    report_.lost += static_cast<double>(outcome.counts.lost);
    report_.histories += weight * static_cast<double>(bands_);
    report_.seconds += outcome.seconds;
  }

  /// An earlier run may have asked for other numbers; then only this run's count.
  void add_derived(const std::vector<double>& values, double weight) {
    if (sums_.derived.size() != values.size()) sums_.derived = {};
    sums_.derived.add(values, weight);
  }

  /// While `telling_` is held.
  PhotonProgress progress() const {
    PhotonProgress progress;
    // Other ranks are as far as this one.
    const double walked = static_cast<double>(counter_.done()) / static_cast<double>(bands_) *
                          (options_.ranks != nullptr ? options_.ranks->count() : 1);
    progress.histories = begun_with_ + walked;
    progress.batches = whole_.batches;
    progress.planned = begun_with_ + options_.photons;
    progress.error = whole_.error;
    progress.until = options_.until;
    progress.seconds = seconds_since(start_);
    double share = walked / options_.photons;
    if (options_.until > 0 && !whole_.error.empty()) {
      // The error falls as 1/sqrt(histories).
      const double worst = *std::ranges::max_element(whole_.error);
      const double needed = whole_.histories * std::pow(worst / options_.until, 2) - begun_with_;
      share = std::max(share, needed > 0 ? walked / needed : 1.0);
    }
    progress.seconds_left =
        std::isfinite(share) && share > 0 ? std::max(0.0, progress.seconds * (1 / share - 1)) : -1;
    return progress;
  }

  /// [band] sqrt(sum of V error^2) / sqrt(sum of V mean^2) over the cells.
  std::vector<double> errors() const {
    std::vector<double> error(bands_, 0), norm(bands_, 0);
    for (std::size_t i = 0; i < sums_.cell_means.size(); ++i) {
      const double volume = problem_.mesh().volume(CellIndex(static_cast<std::int64_t>(i / bands_)));
      error[i % bands_] += volume * std::pow(sums_.cell_means.error(i), 2);
      norm[i % bands_] += volume * std::pow(sums_.cell_means.mean(i), 2);
    }
    for (std::size_t b = 0; b < bands_; ++b) error[b] = norm[b] > 0 ? std::sqrt(error[b] / norm[b]) : 0;
    return error;
  }

  double median_error(std::size_t band) const {
    std::vector<double> errors;
    for (std::size_t i = band; i < sums_.cell_means.size(); i += bands_)
      if (const double mean = sums_.cell_means.mean(i); mean > 0)
        errors.push_back(sums_.cell_means.error(i) / mean);
    return median(std::move(errors));
  }

  PhotonSolution result() {
    PhotonSolution result;
    Solution& solution = result.solution;
    solution.method = "photons";
    solution.interrupted = stopped_;
    if (sums_.fluence.batches() == 0) return result;
    solution.fluence = sums_.fluence.means();
    solution.net_flux = sums_.net_flux.means();
    solution.irradiance = sums_.irradiance.means();
    solution.exitance.assign(solution.irradiance.size(), 0);
    complete_fields(problem_, solution);
    batches_.add_emission(solution);
    // It does not follow from the irradiance alone; what formulas emit is in it.
    if (reflects_by_angle_) solution.exitance = sums_.exitance.means();
    solution.absorbed = sums_.absorbed.means();
    solution.history = std::move(history_);
    report_.error = errors();
    const double all = static_cast<double>(sums_.histories) * static_cast<double>(bands_);
    for (std::size_t b = 0; b < bands_; ++b) {
      const bool converged = options_.until <= 0 || report_.error[b] <= options_.until;
      solution.convergence.push_back({0, report_.error[b], converged && !stopped_});
      report_.cell_error.push_back(median_error(b));
      // All histories count, at this run's speed.
      const double cost = report_.histories > 0 ? report_.seconds / report_.histories * all : 0;
      report_.figure.push_back(cost > 0 && report_.error[b] > 0 ? 1 / (std::pow(report_.error[b], 2) * cost)
                                                                : 0);
    }
    add_notes(solution);
    solution.state.bands = static_cast<int>(bands_);
    solution.state.fluence = solution.fluence;
    solution.state.photons = sums_.packed();
    // A file keeps them band by band.
    solution.state.photons.resize((solution.state.photons.size() + bands_ - 1) / bands_ * bands_);
    result.sums = std::move(sums_);
    result.report = std::move(report_);
    return result;
  }

  void add_notes(Solution& solution) const {
    if (begun_with_ > 0)
      solution.notes.push_back(fmt::format("{:.6g} histories a band of earlier runs count too", begun_with_));
    if (const double beyond = batches_.beyond_bounds(options_.ranks); beyond > 0)
      solution.notes.push_back(fmt::format(
          "in {:.2g} of the directions drawn a kernel was larger than was found beforehand, and cut there",
          beyond));
    if (report_.lost > 0)
      solution.notes.push_back(fmt::format(
          "{:.0f} of {:.6g} histories were given up: their light goes on for ever between mirrors",
          report_.lost, report_.histories));
  }

  const Problem& problem_;
  const PhotonOptions& options_;
  const PhotonObserver& observer_;
  const BatchReader& reader_;
  std::size_t bands_;
  PhotonBatches batches_;
  StageCounter counter_;  ///< histories of all bands
  std::mutex telling_;    ///< held while the observer is told, and while `whole_` changes
  struct {
    int batches = 0;
    double histories = 0;
    std::vector<double> error;
  } whole_;
  PhotonSums sums_;
  PhotonReport report_;
  std::vector<HistoryEntry> history_;  ///< by batches
  double begun_with_ = 0;
  std::atomic<bool> stopped_ = false;
  bool reflects_by_angle_ = std::ranges::any_of(
      problem_.walls(), [](const Wall& wall) { return wall.is_glossy() || wall.refractive_index != 1; });
  WallClock::time_point start_ = WallClock::now();
};

constexpr std::array statistics_of_sums = {
    &PhotonSums::fluence,    &PhotonSums::cell_means, &PhotonSums::net_flux, &PhotonSums::irradiance,
    &PhotonSums::face_means, &PhotonSums::derived,    &PhotonSums::exitance, &PhotonSums::absorbed};

}  // namespace

std::vector<double> PhotonSums::packed() const {
  std::vector<double> numbers = {static_cast<double>(histories)};
  for (const auto part : statistics_of_sums) {
    const std::vector<double> packed = (this->*part).packed();
    numbers.push_back(static_cast<double>(packed.size()));
    numbers.insert(numbers.end(), packed.begin(), packed.end());
  }
  return numbers;
}

PhotonSums PhotonSums::unpacked(std::span<const double> numbers) {
  const auto cut = [] { return InputError("the sums of the photons are cut short"); };
  // Beyond 2^53 a double does not count one by one.
  if (numbers.empty() || !(numbers[0] >= 0 && numbers[0] <= 0x1p53)) throw cut();
  PhotonSums sums;
  sums.histories = static_cast<std::uint64_t>(numbers[0]);
  numbers = numbers.subspan(1);
  for (const auto part : statistics_of_sums) {
    // Runs that had no use for the last ones may end before them.
    if ((part == &PhotonSums::exitance || part == &PhotonSums::absorbed) && numbers.empty()) break;
    if (numbers.empty() || !(numbers[0] >= 0) || numbers[0] > static_cast<double>(numbers.size() - 1))
      throw cut();
    const auto size = static_cast<std::size_t>(numbers[0]);
    sums.*part = BatchStatistics::unpacked(numbers.subspan(1, size));
    numbers = numbers.subspan(1 + size);
  }
  return sums;
}

// Per cell and band: 17 values, and what is absorbed where that does not follow from them, with their
// squares, twice where they are saved or read as means; the record of the cell; and for each thread the sums
// of one band and the fields of a batch.
std::size_t estimate_photon_memory(const Problem& problem, int threads) {
  const auto cells = static_cast<std::size_t>(problem.mesh().cell_count());
  const auto faces = static_cast<std::size_t>(problem.mesh().boundary_face_count());
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const std::size_t of_a_cell = depends_on_direction(problem) ? 18 : 17;
  const std::size_t values = bands * (of_a_cell * cells + 7 * faces);
  const std::size_t records = bands * (cells * sizeof(PhotonCell) + faces * sizeof(PhotonFace));
  const std::size_t of_a_thread = (17 * cells + 4 * faces + values + bands * 3 * faces) * sizeof(double);
  return 7 * values * sizeof(double) + records + static_cast<std::size_t>(threads) * of_a_thread;
}

PhotonSolution solve_photons(const Problem& problem, const CellLocator& locator, const PhotonOptions& options,
                             const PhotonObserver& observer, const BatchReader& reader) {
  refuse_for_photons(problem);
  return PhotonRun(problem, locator, options, observer, reader).solve();
}

}  // namespace etendue
