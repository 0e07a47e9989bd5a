// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/adjoint/share_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "app/progress/text_table.h"
#include "app/write/csv/csv_field.h"

namespace etendue {
namespace {

/// Emitters beyond which the rest is left to the CSV file.
constexpr std::size_t longest_table = 40;

const char* name_of(EmitterKind kind) {
  switch (kind) {
    case EmitterKind::region:
      return "region";
    case EmitterKind::wall:
      return "wall";
    case EmitterKind::light:
      return "light";
  }
  return "";
}

double total(const EmitterShare& share, std::size_t band) {
  return share.uncollided[band] + share.swept[band];
}

/// 0 of nothing.
double part(double of, double whole) { return whole != 0 ? of / whole : 0; }

double sum_over_bands(const EmitterShare& share) {
  return std::accumulate(share.uncollided.begin(), share.uncollided.end(), 0.0) +
         std::accumulate(share.swept.begin(), share.swept.end(), 0.0);
}

/// The sum of all shares.
EmitterShare all_of(const AdjointSolution& solution) {
  const std::vector<double> whole = solution.response();
  EmitterShare all{EmitterKind::light, "", std::vector<double>(whole.size(), 0),
                   std::vector<double>(whole.size(), 0)};
  for (const EmitterShare& share : solution.shares)
    for (std::size_t b = 0; b < whole.size(); ++b) {
      all.uncollided[b] += share.uncollided[b];
      all.swept[b] += share.swept[b];
    }
  return all;
}

}  // namespace

std::string importance_csv(const std::vector<SolvedResponse>& solved, const Bands& bands) {
  std::string table = "response,quantity,unit,kind,emitter,band,uncollided,collided,total,share\n";
  for (const auto& [response, solution, gradient, derivatives] : solved) {
    const EmitterShare all = all_of(solution);
    const auto add = [&](const std::string& kind, const EmitterShare& share) {
      for (std::size_t b = 0; b < bands.names.size(); ++b)
        fmt::format_to(std::back_inserter(table), "{},{},{},{},{},{},{},{},{},{}\n", csv_field(response.name),
                       response.quantity, csv_field(response.unit), kind, csv_field(share.name),
                       csv_field(bands.names[b]), share.uncollided[b], share.swept[b], total(share, b),
                       part(total(share, b), total(all, b)));
    };
    for (const EmitterShare& share : solution.shares) add(name_of(share.kind), share);
    add("all", all);
  }
  return table;
}

std::string share_text(const SolvedResponse& solved, const Bands& bands) {
  const EmitterShare all = all_of(solved.solution);
  std::vector<EmitterShare> shares = solved.solution.shares;
  std::ranges::stable_sort(shares, std::greater<>(), sum_over_bands);
  const std::size_t shown = std::min(shares.size(), longest_table);
  TextTable table({"emitter", "band", "uncollided", "collided", "total", "share"},
                  {Align::left, Align::left, Align::right, Align::right, Align::right, Align::right});
  const auto add = [&](const std::string& name, const EmitterShare& share) {
    for (std::size_t b = 0; b < bands.names.size(); ++b)
      table.add_row({name, bands.names[b], number(share.uncollided[b]), number(share.swept[b]),
                     number(total(share, b)),
                     fmt::format("{:.2f} %", 100 * part(total(share, b), total(all, b)))});
  };
  for (std::size_t i = 0; i < shown; ++i)
    add(fmt::format("{} {}", name_of(shares[i].kind), shares[i].name), shares[i]);
  add("all", all);
  std::string text = fmt::format("\n{}: {} [{}]\n{}", solved.response.name, solved.response.quantity,
                                 solved.response.unit, table.text());
  if (shown < shares.size()) text += fmt::format("  {} more in importance.csv\n", shares.size() - shown);
  return text;
}

}  // namespace etendue
