// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/adjoint/gradient_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/progress/text_table.h"
#include "app/write/csv/csv_field.h"
#include "base/field_view.h"

namespace etendue {
namespace {

constexpr std::size_t most_derivatives = 20;

/// Sums over the cells of each region, [region][band]: of values, and of values times a coefficient.
struct RegionSums {
  std::vector<std::vector<double>> plain, weighted;

  RegionSums(const Problem& problem, const std::vector<double>& values, std::span<const double> coefficient)
      : plain(problem.media().size(), std::vector<double>(static_cast<std::size_t>(problem.band_count()), 0)),
        weighted(plain) {
    const std::size_t bands = plain.empty() ? 1 : plain.front().size();
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto region =
          static_cast<std::size_t>(problem.mesh().region(CellIndex(static_cast<std::int64_t>(i / bands))));
      plain[region][i % bands] += values[i];
      if (!coefficient.empty()) weighted[region][i % bands] += values[i] * coefficient[i];
    }
  }
};

/// Sums over the faces of each wall, [wall][band].
std::vector<std::vector<double>> wall_sums(const Problem& problem, const std::vector<double>& values) {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<std::vector<double>> sums(problem.walls().size(), std::vector<double>(bands, 0));
  for (std::size_t i = 0; i < values.size(); ++i)
    sums[static_cast<std::size_t>(problem.mesh().wall(FaceIndex(static_cast<std::int64_t>(i / bands))))]
        [i % bands] += values[i];
  return sums;
}

std::optional<double> ratio(double part, double whole) { return whole != 0 ? part / whole : 0; }

}  // namespace

std::vector<Derivative> derivatives_of(const Gradient& gradient, const Problem& problem,
                                       const std::vector<double>& whole) {
  std::vector<Derivative> list;
  const auto add_regions = [&](const char* by, const std::vector<double>& values,
                               std::span<const double> coefficient) {
    const RegionSums sums(problem, values, coefficient);
    for (std::size_t r = 0; r < problem.media().size(); ++r)
      for (std::size_t b = 0; b < whole.size(); ++b)
        if (problem.media()[r].reradiation.empty())
          list.push_back({"region", problem.media()[r].name, by, static_cast<int>(b), sums.plain[r][b],
                          coefficient.empty() ? std::nullopt : ratio(sums.weighted[r][b], whole[b])});
  };
  const auto add_walls = [&](const char* by, const std::vector<double>& values,
                             std::vector<double> Wall::*number) {
    const auto sums = wall_sums(problem, values);
    for (std::size_t w = 0; w < problem.walls().size(); ++w)
      for (std::size_t b = 0; b < whole.size(); ++b)
        if (const Wall& wall = problem.walls()[w]; wall.reradiation.empty() && wall.refractive_index == 1)
          list.push_back(
              {"wall", wall.name, by, static_cast<int>(b), sums[w][b],
               number == nullptr ? std::nullopt : ratio(sums[w][b] * (wall.*number)[b], whole[b])});
  };
  add_regions("absorption", gradient.absorption, problem.absorption());
  add_regions("scattering", gradient.scattering, problem.scattering());
  add_regions("emission", gradient.emission, {});
  add_walls("radiance", gradient.radiance, nullptr);
  add_walls("diffuse", gradient.diffuse, &Wall::diffuse);
  return list;
}

std::string gradient_csv(const std::vector<std::pair<std::string, std::vector<Derivative>>>& responses,
                         const Bands& bands) {
  std::string table = "response,kind,name,by,band,derivative,relative\n";
  for (const auto& [response, derivatives] : responses)
    for (const Derivative& one : derivatives)
      fmt::format_to(std::back_inserter(table), "{},{},{},{},{},{},{}\n", csv_field(response), one.kind,
                     csv_field(one.name), one.by, csv_field(bands.names[static_cast<std::size_t>(one.band)]),
                     one.value, one.relative ? fmt::to_string(*one.relative) : "");
  return table;
}

std::string difference_text(const std::vector<double>& on_directions, const std::vector<double>& whole,
                            const Bands& bands) {
  constexpr double noticeable = 0.01;
  std::string text;
  for (std::size_t b = 0; b < whole.size(); ++b)
    if (std::abs(on_directions[b] - whole[b]) > noticeable * std::abs(whole[b]))
      text += fmt::format(
          "CAUTION: in band {} the directions alone give {}, not {}: the derivatives are of that; use more "
          "directions\n",
          bands.names[b], number(on_directions[b]), number(whole[b]));
  return text;
}

std::string gradient_text(const std::vector<Derivative>& derivatives, const Bands& bands) {
  std::vector<Derivative> largest;
  std::ranges::copy_if(derivatives, std::back_inserter(largest),
                       [](const Derivative& one) { return one.relative.value_or(0) != 0; });
  std::ranges::stable_sort(largest, std::greater<>(),
                           [](const Derivative& one) { return std::abs(*one.relative); });
  if (largest.size() > most_derivatives) largest.resize(most_derivatives);
  TextTable table({"where", "by", "band", "derivative", "1 % more brings"},
                  {Align::left, Align::left, Align::left, Align::right, Align::right});
  for (const Derivative& one : largest)
    table.add_row({one.kind + " " + one.name, one.by, bands.names[static_cast<std::size_t>(one.band)],
                   number(one.value), fmt::format("{:+.3f} %", *one.relative)});
  return "\n" + table.text();
}

}  // namespace etendue
