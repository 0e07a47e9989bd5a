// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/compare/method_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/study/study_level.h"
#include "app/write/result/balance_check.h"
#include "base/errors.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/solution/node_means.h"

namespace etendue {
namespace {

constexpr const char* by_ordinates = "solve.method=\"auto\"";

/// Lists the numbers of a run in an order that depends on the case alone.
class Numbers {
 public:
  explicit Numbers(const RunResult& run) : run_(run) {}

  std::vector<AnswerNumber> all() {
    for (std::size_t b = 0; b < run_.balances.size(); ++b) {
      band_ = b;
      add_powers();
      add_probes();
    }
    return std::move(numbers_);
  }

 private:
  void add(const std::string& where, const char* quantity, double value, double error) {
    numbers_.push_back({where, run_.problem.bands().names[band_], quantity, value, error});
  }

  void add_powers() {
    const RunErrors* errors = run_.errors ? &*run_.errors : nullptr;
    const Balance& balance = run_.balances[band_];
    add("balance", "absorbed", balance.absorbed, errors ? errors->balances[band_].absorbed : 0);
    add("balance", "outflow", balance.outflow, errors ? errors->balances[band_].outflow : 0);
    for (std::size_t r = 0; r < run_.regions.size(); ++r) {
      const RegionPower& power = run_.regions[r][band_];
      const std::string where = "region " + run_.problem.media()[r].name;
      add(where, "fluence", power.fluence_mean, errors ? errors->regions[r][band_].fluence_mean : 0);
      add(where, "absorbed", power.absorbed, errors ? errors->regions[r][band_].absorbed : 0);
    }
    for (std::size_t w = 0; w < run_.walls.size(); ++w) {
      const WallPower& power = run_.walls[w][band_];
      const std::string where = "wall " + run_.problem.walls()[w].name;
      add(where, "incoming", power.incoming, errors ? errors->walls[w][band_].incoming : 0);
      add(where, "net", power.incoming - power.outgoing, errors ? errors->net[w][band_] : 0);
    }
  }

  void add_probes() {
    for (const ProbeRow& row : run_.probes) {
      const std::string where = fmt::format("probe {} {}", row.name, row.index);
      add(where, "fluence", row.values[band_].fluence, row.errors ? row.errors->values[band_].fluence : 0);
      if (!row.irradiance) continue;
      const bool drawn = row.errors && row.errors->irradiance;
      add(where, "irradiance", (*row.irradiance)[band_], drawn ? (*row.errors->irradiance)[band_] : 0);
    }
  }

  const RunResult& run_;
  std::size_t band_ = 0;
  std::vector<AnswerNumber> numbers_;
};

RunRequest request_for(const RunRequest& run, const std::filesystem::path& directory,
                       const std::vector<std::string>& overrides) {
  RunRequest request = run;
  request.overrides.insert(request.overrides.end(), overrides.begin(), overrides.end());
  request.overrides.push_back("output.directory=" + nlohmann::json(directory.string()).dump());
  return request;
}

/// Adds a change in quadrature.
void widen(double& error, double change) { error = std::hypot(error, change); }

/// What another run on the same cells changes.
void widen_by(const MethodAnswer& other, MethodAnswer& answer) {
  for (std::size_t i = 0; i < answer.numbers.size(); ++i)
    widen(answer.numbers[i].error, other.numbers[i].value - answer.numbers[i].value);
  for (std::size_t i = 0; i < answer.cells.size(); ++i)
    widen(answer.cell_errors[i], other.cells[i] - answer.cells[i]);
  answer.whole = answer.whole && other.whole;
}

/// Runs the case with other directions; the cells are the same.
void add_error_of_directions(const ComparedCase& base, MethodAnswer& answer, std::ostream& out,
                             std::ostream& err) {
  try {
    const Case input = read_case(base.run.file, base.run.overrides);
    const RunRequest request = request_for(base.run, base.directory / "ordinates-directions",
                                           {by_ordinates, other_directions(input)});
    run_case(request, out, err, [&](const RunResult& fine) { widen_by(answer_of(fine), answer); });
  } catch (const InputError& error) {
    answer.notes.push_back(std::string("the error of the directions is not known: ") + error.what());
  }
}

/// Runs the case on cells of eight times the volume, and looks at them from the middles of its own.
void add_error_of_mesh(const ComparedCase& base, MethodAnswer& answer, std::ostream& out, std::ostream& err) {
  try {
    const Case input = read_case(base.run.file, base.run.overrides);
    const RunRequest request =
        request_for(base.run, base.directory / "ordinates-mesh", {by_ordinates, refined_mesh(input, -1)});
    run_case(request, out, err, [&](const RunResult& coarse) {
      const MethodAnswer other = answer_of(coarse);
      for (std::size_t i = 0; i < answer.numbers.size(); ++i)
        widen(answer.numbers[i].error, other.numbers[i].value - answer.numbers[i].value);
      const CellLocator locator(coarse.problem.mesh());
      const std::size_t bands = coarse.problem.bands().names.size();
      for (std::int32_t c = 0; c < base.mesh.cell_count(); ++c) {
        // Bodies of facets may be smaller on coarse cells: there nothing is known.
        const std::vector<ProbeValue> there =
            probe(coarse.problem, coarse.solution, locator, base.mesh.centroid(CellIndex(c)));
        for (std::size_t b = 0; b < there.size(); ++b) {
          const std::size_t i = static_cast<std::size_t>(c) * bands + b;
          widen(answer.cell_errors[i], there[b].fluence - answer.cells[i]);
        }
      }
      answer.whole = answer.whole && other.whole;
    });
  } catch (const InputError& error) {
    answer.notes.push_back(std::string("the error of the cells is not known: ") + error.what());
  }
}

/// Light in time but for irradiances, which photons do not read.
std::vector<AnswerNumber> numbers_in_time(const RunResult& run) {
  std::vector<AnswerNumber> numbers;
  if (!run.time) return numbers;
  for (std::size_t q = 0; q < run.time->histories.size(); ++q) {
    const TimeQuantity& of = run.time->quantities[q];
    if (of.quantity == "irradiance") continue;
    for (std::size_t i = 0; i < run.time->histories[q].size(); ++i) {
      const ValueInTime& found = run.time->histories[q][i];
      numbers.push_back({of.name, of.band,
                         fmt::format("{} at t = {:.6g}", of.quantity, run.input.time->times[i]), found.value,
                         found.error});
    }
  }
  return numbers;
}

}  // namespace

std::vector<AnswerNumber> steady_numbers(const RunResult& run) { return Numbers(run).all(); }

std::string other_directions(const Case& input) {
  for (int order = (input.direction_order + 1) / 2; order < input.direction_order; ++order)
    if (check_direction_order(input.direction_set, order).empty())
      return fmt::format("directions.order={}", order);
  return refined_directions(input, 1);
}

std::string coarser_patches(const RunResult& run) {
  double size = run.input.radiosity->patch_size;
  if (size <= 0) {
    double area = 0;
    for (const auto& wall : run.walls) area += wall.front().area;
    size = std::sqrt(area / static_cast<double>(run.radiosity->patches));
  }
  return fmt::format("radiosity.patch_size={}", 2 * size);
}

MethodAnswer answer_of(const RunResult& run) {
  MethodAnswer answer;
  answer.method = run.solution.method;
  answer.numbers = steady_numbers(run);
  std::ranges::copy(numbers_in_time(run), std::back_inserter(answer.numbers));
  answer.cells = node_means(run.solution.fluence, 4, run.problem.bands().names.size());
  answer.cell_errors = run.errors ? run.errors->fluence_mean : std::vector<double>(answer.cells.size(), 0);
  answer.seconds = run.seconds.total;
  answer.whole = !run.interrupted();
  const std::string method = run.errors ? "photons" : run.radiosity ? "radiosity" : "ordinates";
  for (const std::string& note : {balance_warning(run), balance_caution(run)})
    if (!note.empty()) answer.notes.push_back(method + ": " + note.substr(0, note.find('\n')));
  if (run.errors && run.errors->unreached_probes > 0)
    answer.notes.push_back(fmt::format(
        "{}: values of probes that no history reached: {}; the error is an upper bound there, three "
        "histories' worth",
        method, run.errors->unreached_probes));
  return answer;
}

MethodAnswer answer_by_ordinates(const ComparedCase& compared, std::ostream& out, std::ostream& err) {
  MethodAnswer answer;
  run_case(request_for(compared.run, compared.directory / "ordinates", {by_ordinates}), out, err,
           [&](const RunResult& result) { answer = answer_of(result); });
  answer.method = "ordinates";
  if (answer.whole) {
    out << "\nwhat other directions change\n";
    add_error_of_directions(compared, answer, out, err);
  }
  if (answer.whole) {
    out << "\nwhat coarser cells change\n";
    add_error_of_mesh(compared, answer, out, err);
  }
  return answer;
}

MethodAnswer answer_by_photons(const ComparedCase& compared, std::ostream& out, std::ostream& err) {
  MethodAnswer answer;
  run_case(request_for(compared.run, compared.directory / "photons", {"solve.method=\"photons\""}), out, err,
           [&](const RunResult& result) { answer = answer_of(result); });
  return answer;
}

MethodAnswer answer_by_radiosity(const ComparedCase& compared, std::ostream& out, std::ostream& err) {
  const std::string method = "solve.method=\"radiosity\"";
  MethodAnswer answer;
  std::string coarser;
  run_case(request_for(compared.run, compared.directory / "radiosity", {method}), out, err,
           [&](const RunResult& result) {
             answer = answer_of(result);
             coarser = coarser_patches(result);
           });
  if (!answer.whole) return answer;
  out << "\nwhat larger patches change\n";
  run_case(request_for(compared.run, compared.directory / "radiosity-patches", {method, coarser}), out, err,
           [&](const RunResult& result) { widen_by(answer_of(result), answer); });
  return answer;
}

MethodAnswer answer_by(const std::string& method, const ComparedCase& compared, std::ostream& out,
                       std::ostream& err) {
  if (method == "photons") return answer_by_photons(compared, out, err);
  if (method == "radiosity") return answer_by_radiosity(compared, out, err);
  return answer_by_ordinates(compared, out, err);
}

}  // namespace etendue
