// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <new>
#include <optional>

#include "app/case/build/build.h"
#include "app/compare/error_estimate.h"
#include "app/compare/estimate_files.h"
#include "app/compare/kept_run.h"
#include "app/progress/interruption.h"
#include "app/request/commands.h"
#include "app/run/report/run_log.h"
#include "app/study/study_level.h"
#include "base/errors.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue {
namespace {

/// Time that repetitions may take without being asked for: these seconds, or this part of the run.
constexpr double cheap_seconds = 5, cheap_part = 0.2;
/// From so many seconds on the progress of a repetition is shown.
constexpr double shown_from = 1;
/// Of a run on cells of eight times the volume, in that of the run: borders keep cells smaller than asked.
constexpr double share_of_coarser_cells = 0.15;
constexpr double share_of_larger_patches = 0.25;
/// Orders in the size of cells and directions: linear elements where the solution is smooth, and constants.
constexpr double smooth_order = 2, order_of_constants = 1;
/// Cells that are coarser by less than this do not tell the error.
constexpr double least_ratio = 1.1;

/// The repetitions of one run.
class Estimation {
 public:
  Estimation(const RunRequest& request, const KeptRun& run, std::ostream& out, std::ostream& err)
      : request_(request), run_(run), out_(out), err_(err) {}

  ErrorEstimate made() {
    if (run_.method == "photons") add_chance();
    if (run_.method == "radiosity") add_patches();
    if (run_.method == "ordinates") {
      add_cells();
      add_directions();
    }
    return error_estimate(run_.numbers, std::move(parts_), run_.is_coarse);
  }

 private:
  /// How a repetition is made, and what its changes come to.
  struct Repetition {
    ErrorCause cause;
    std::function<std::string()> override;  ///< throws InputError where it cannot be
    std::function<double()> forecast;       ///< [s]
    std::function<double(const KeptRun&)> ratio;
    double order;
    std::function<std::string(const KeptRun&)> how;
  };

  bool is_cheap(double forecast) const {
    return spent_ + forecast <= std::max(cheap_seconds, cheap_part * run_.seconds);
  }

  void add(const Repetition& repetition) {
    ErrorPart part{.cause = repetition.cause, .how = {}, .errors = {}};
    is_repeating_ = false;
    try {
      const std::string change = repetition.override();
      const double forecast = repetition.forecast();
      if (request_.estimate == EstimateWish::automatic && !is_cheap(forecast))
        part.how = fmt::format("that takes about {:.0f} s; --estimate finds it", std::ceil(forecast));
      else
        repeat(repetition, change, forecast, part);
    } catch (const InputError& error) {
      refuse_alone();
      part.how = error.what();
    } catch (const NotFiniteError& error) {
      part.how = error.what();
    } catch (const std::bad_alloc&) {
      refuse_alone();
      part.how = "the memory of this machine does not suffice for it";
    }
    parts_.push_back(std::move(part));
  }

  /// Within a repetition a process may fail that others wait for: then all of them end.
  void refuse_alone() const {
    if (request_.ranks != nullptr && is_repeating_) throw;
  }

  void repeat(const Repetition& repetition, const std::string& change, double forecast, ErrorPart& part) {
    RunRequest again = request_;
    again.overrides.push_back(change);
    again.traces = RunTraces::none;
    if (again.progress == ProgressStyle::automatic && forecast < shown_from)
      again.progress = ProgressStyle::none;
    if (forecast >= shown_from)
      out_ << fmt::format("error of the {}: the run again with {}, about {:.0f} s\n",
                          name_of(repetition.cause), change, forecast)
           << std::flush;
    std::optional<KeptRun> other;
    is_repeating_ = true;
    run_case(again, out_, err_, [&](const RunResult& result) { other = kept_of(result); });
    agree_on_costs(*other, request_.ranks);
    part.seconds = other->seconds;
    spent_ += other->seconds;
    const double ratio = repetition.ratio(*other);
    if (!other->whole || other->numbers.size() != run_.numbers.size()) {
      part.how = "the run with " + change + " came to no solution";
      return;
    }
    if (ratio > 1 / least_ratio && ratio < least_ratio) {
      part.how = fmt::format("the run with {} has nearly the same {}", change, name_of(repetition.cause));
      return;
    }
    part.how = repetition.how(*other);
    for (std::size_t i = 0; i < run_.numbers.size(); ++i)
      part.errors.push_back(
          error_of_change(change_of(run_.numbers[i], other->numbers[i]), ratio, repetition.order));
  }

  void add_cells() {
    const double sweeping = run_.seconds - run_.of_points;
    add({ErrorCause::cells, [&] { return refined_mesh(read_case(request_.file, request_.overrides), -1); },
         [&] { return run_.of_points + share_of_coarser_cells * sweeping; },
         [&](const KeptRun& other) { return std::cbrt(run_.cells / other.cells); }, run_.order_of_cells,
         [](const KeptRun& other) { return fmt::format("by {:.0f} cells", other.cells); }});
  }

  void add_directions() {
    std::string change;
    add({ErrorCause::directions,
         [&] {
           const Case input = read_case(request_.file, request_.overrides);
           return change = other_directions(input);
         },
         [&] {
           Overrides overrides = request_.overrides;
           overrides.push_back(change);
           const int count = build_directions(read_case(request_.file, overrides)).count();
           return run_.seconds + run_.of_directions * (count / run_.directions - 1);
         },
         [&](const KeptRun& other) {
           const double ratio = run_.directions / other.directions;
           return run_.is_flat ? ratio : std::sqrt(ratio);
         },
         smooth_order,
         [](const KeptRun& other) { return fmt::format("by {:.0f} directions", other.directions); }});
  }

  void add_patches() {
    add({ErrorCause::patches, [&] { return run_.larger_patches; },
         [&] { return share_of_larger_patches * run_.seconds; }, [](const KeptRun&) { return 2.0; },
         order_of_constants, [](const KeptRun&) { return std::string("by patches of twice the size"); }});
  }

  void add_chance() {
    ErrorPart part{.cause = ErrorCause::histories,
                   .how = fmt::format("standard errors of {:.3g} histories", run_.histories),
                   .errors = {}};
    for (const AnswerNumber& number : run_.numbers) part.errors.push_back(number.error);
    parts_.push_back(std::move(part));
  }

  const RunRequest& request_;
  const KeptRun& run_;
  std::ostream& out_;
  std::ostream& err_;
  std::vector<ErrorPart> parts_;
  double spent_ = 0;
  bool is_repeating_ = false;
};

}  // namespace

ExitCode run_and_estimate(const RunRequest& request, std::ostream& out, std::ostream& err) {
  std::optional<KeptRun> kept;
  // Between the runs, whose own signals they decide on, the results are whole.
  std::optional<Interruption> between;
  if (request.estimate != EstimateWish::never) between.emplace(last_words_of_repetition);
  const ExitCode code = run_case(request, out, err, [&](const RunResult& result) { kept = kept_of(result); });
  if (request.estimate == EstimateWish::never || !kept || code == ExitCode::interrupted) return code;
  agree_on_costs(*kept, request.ranks);
  if (!kept->whole || kept->numbers.empty()) {
    if (request.estimate == EstimateWish::always)
      out << "\nno estimate of errors: the run did not converge, or there is nothing to tell it of\n";
    return code;
  }
  const ErrorEstimate estimate = Estimation(request, *kept, out, err).made();
  if (!writes_results(request.ranks)) return code;
  if (is_known(estimate)) {
    Interruption writing;
    writing.note_all();  // the files become whole
    write_estimate(estimate, kept->directory);
  }
  const std::string text = estimate_text(estimate);
  out << text << std::flush;
  append_to_log(kept->directory, text);
  return code;
}

}  // namespace etendue
