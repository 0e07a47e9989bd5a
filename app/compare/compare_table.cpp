// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/compare/compare_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "app/progress/text_table.h"
#include "base/order_statistics.h"

namespace etendue {
namespace {

constexpr std::size_t longest_comparison = 40;
// Differences beyond this many errors are not chance.
constexpr double allowed = 3;

double in_errors(const Comparison& c, std::size_t i) {
  const AnswerNumber &a = c.first.numbers[i], &b = c.second.numbers[i];
  return etendue::in_errors(b.value - a.value, a.error, b.error);
}

/// The rows to print: all, or those that differ most, in their order.
std::vector<std::size_t> rows_to_show(const Comparison& comparison) {
  std::vector<std::size_t> rows(comparison.first.numbers.size());
  std::iota(rows.begin(), rows.end(), 0);
  if (rows.size() <= longest_comparison) return rows;
  std::ranges::stable_sort(rows, [&](std::size_t i, std::size_t j) {
    return std::abs(in_errors(comparison, i)) > std::abs(in_errors(comparison, j));
  });
  rows.resize(longest_comparison);
  std::ranges::sort(rows);
  return rows;
}

}  // namespace

double in_errors(double difference, double first_error, double second_error) {
  if (difference == 0) return 0;
  return difference / std::hypot(first_error, second_error);
}

std::vector<CellAgreement> cell_agreement(const Comparison& comparison, const TetrahedralMesh& mesh,
                                          std::size_t bands) {
  std::vector<CellAgreement> agreement(bands);
  for (std::size_t b = 0; b < bands; ++b) {
    CellAgreement& found = agreement[b];
    std::vector<double> first, second;
    double square = 0, difference = 0, norm = 0;
    const auto cells = static_cast<std::size_t>(mesh.cell_count());
    for (std::size_t c = 0; c < cells; ++c) {
      const std::size_t i = c * bands + b;
      const double value = comparison.first.cells[i], change = comparison.second.cells[i] - value;
      const double errors =
          in_errors(change, comparison.first.cell_errors[i], comparison.second.cell_errors[i]);
      found.within += std::abs(errors) <= allowed ? 1 : 0;
      square += std::isfinite(errors) ? errors * errors : 0;
      const double volume = mesh.volumes()[c];
      difference += volume * change * change;
      norm += volume * value * value;
      if (value > 0) first.push_back(comparison.first.cell_errors[i] / value);
      if (comparison.second.cells[i] > 0)
        second.push_back(comparison.second.cell_errors[i] / comparison.second.cells[i]);
    }
    found.within /= static_cast<double>(cells);
    found.root_mean_square = std::sqrt(square / static_cast<double>(cells));
    found.difference = norm > 0 ? std::sqrt(difference / norm) : 0;
    found.median_first = median(std::move(first));
    found.median_second = median(std::move(second));
  }
  return agreement;
}

std::string comparison_text(const Comparison& comparison, const std::vector<CellAgreement>& cells,
                            const std::vector<std::string>& bands) {
  const MethodAnswer &first = comparison.first, &second = comparison.second;
  std::string text = fmt::format("\n{} ({:.3g} s) and {} ({:.3g} s)\n", first.method, first.seconds,
                                 second.method, second.seconds);
  for (const MethodAnswer* answer : {&first, &second})
    for (const std::string& note : answer->notes) text += "  " + note + "\n";
  TextTable agreement({"band", "within 3 errors [%]", "rms [errors]", "difference [%]",
                       "error of " + first.method + " [%]", "error of " + second.method + " [%]"},
                      {Align::left, Align::right, Align::right, Align::right, Align::right, Align::right});
  for (std::size_t b = 0; b < cells.size(); ++b)
    agreement.add_row({bands[b], fmt::format("{:.2f}", 100 * cells[b].within),
                       fmt::format("{:.2f}", cells[b].root_mean_square),
                       fmt::format("{:.3g}", 100 * cells[b].difference),
                       fmt::format("{:.3g}", 100 * cells[b].median_first),
                       fmt::format("{:.3g}", 100 * cells[b].median_second)});
  text += "\nfluence of the cells: differences, and medians of their errors\n" + agreement.text();
  TextTable table({"", "band", "quantity", first.method, "error", second.method, "error", "in errors"},
                  {Align::left, Align::left, Align::left, Align::right, Align::right, Align::right,
                   Align::right, Align::right});
  const std::vector<std::size_t> rows = rows_to_show(comparison);
  for (const std::size_t i : rows) {
    const AnswerNumber &a = first.numbers[i], &b = second.numbers[i];
    table.add_row({a.where, a.band, a.quantity, number(a.value), fmt::format("{:.2g}", a.error),
                   number(b.value), fmt::format("{:.2g}", b.error),
                   fmt::format("{:+.2f}", in_errors(comparison, i))});
  }
  const bool all = rows.size() == first.numbers.size();
  return text + (all ? "\nnumbers\n" : "\nnumbers that differ most (all: comparison.csv)\n") + table.text();
}

std::string comparison_csv(const Comparison& comparison) {
  const MethodAnswer &first = comparison.first, &second = comparison.second;
  std::string table = fmt::format("where,band,quantity,{0},{0}_error,{1},{1}_error,difference,in_errors\n",
                                  first.method, second.method);
  for (std::size_t i = 0; i < first.numbers.size(); ++i) {
    const AnswerNumber &a = first.numbers[i], &b = second.numbers[i];
    fmt::format_to(std::back_inserter(table), "\"{}\",\"{}\",{},{},{},{},{},{},{}\n", a.where, a.band,
                   a.quantity, a.value, a.error, b.value, b.error, b.value - a.value,
                   in_errors(comparison, i));
  }
  return table;
}

}  // namespace etendue
