// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/k_distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "base/errors.h"
#include "base/text/number_columns.h"

namespace etendue {
namespace {

/// How far the weights of a temperature may add up to other than 1 in a file that rounds them.
constexpr double rounding = 1e-4;
constexpr std::size_t most_points = 64;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& text) {
  throw InputError(fault_at({.file = path.string(), .line = 0, .key = ""}, "", text));
}

void check_not_negative(const std::filesystem::path& path, const std::vector<double>& column,
                        const char* what) {
  const auto bad = std::ranges::find_if(column, [](double value) { return value < 0; });
  if (bad != column.end()) fail(path, fmt::format("has {} of {:g}; use values of at least 0", what, *bad));
}

/// How many lines have the first temperature.
std::size_t point_count(const std::vector<double>& kelvin) {
  return static_cast<std::size_t>(
      std::ranges::find_if(kelvin, [&](double other) { return other != kelvin.front(); }) - kelvin.begin());
}

/// The temperatures, each once.
std::vector<double> temperatures(const std::filesystem::path& path, const std::vector<double>& kelvin,
                                 std::size_t points) {
  std::vector<double> result;
  for (std::size_t line = 0; line < kelvin.size(); line += points) {
    const auto first = kelvin.begin() + static_cast<std::ptrdiff_t>(line);
    const auto end = kelvin.begin() + static_cast<std::ptrdiff_t>(std::min(line + points, kelvin.size()));
    if (end - first != static_cast<std::ptrdiff_t>(points) || std::count(first, end, *first) != end - first)
      fail(path, fmt::format("{:g} K has not {} lines, as {:g} K has; give each temperature the same number "
                             "of points, one after the other",
                             *first, points, kelvin.front()));
    if (!(*first > (result.empty() ? 0 : result.back())))
      fail(path, fmt::format("the temperature {:g} K is not above {}; let temperatures rise", *first,
                             result.empty() ? "0" : fmt::format("{:g} K before it", result.back())));
    result.push_back(*first);
  }
  return result;
}

/// Weights of a temperature, which add up to 1 but for rounding, so that they add up to 1.
void normalize(const std::filesystem::path& path, double kelvin, std::span<double> weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (std::abs(sum - 1) > rounding)
    fail(path,
         fmt::format("the weights at {:g} K add up to {:.6g}; they are fractions of a blackbody's power, "
                     "and add up to 1",
                     kelvin, sum));
  for (double& weight : weights) weight /= sum;
}

/// By the temperatures; one number where a file means the same but rounds it.
TemperatureCurve absorption_curve(const std::vector<double>& kelvin, std::vector<double> values) {
  const auto [lowest, highest] = std::ranges::minmax(values);
  if (highest - lowest <= 1e-6 * highest) return values.front();
  return TemperatureCurve::Table{kelvin, std::move(values)};
}

/// Every `points`-th value, from a point on.
std::vector<double> of_point(const std::vector<double>& column, std::size_t point, std::size_t points) {
  std::vector<double> values;
  for (std::size_t line = point; line < column.size(); line += points) values.push_back(column[line]);
  return values;
}

}  // namespace

GrayGases k_distribution(const std::filesystem::path& path) {
  auto columns = read_columns(path, {"temperature", "absorption", "weight"});
  const std::vector<double>& kelvin = columns[0];
  const std::vector<double>& absorption = columns[1];
  std::vector<double>& weight = columns[2];
  if (kelvin.empty()) fail(path, "has no lines of temperature, absorption and weight between commas");
  check_not_negative(path, absorption, "an absorption");
  check_not_negative(path, weight, "a weight");
  const std::size_t points = point_count(kelvin);
  if (points > most_points)
    fail(path, fmt::format("has {} points, each of which is a band; use at most {}", points, most_points));
  const std::vector<double> rising = temperatures(path, kelvin, points);
  for (std::size_t t = 0; t < rising.size(); ++t)
    normalize(path, rising[t], std::span(weight).subspan(t * points, points));
  GrayGases mixture{{}, rising.front(), rising.back()};
  for (std::size_t point = 0; point < points; ++point)
    mixture.gases.push_back({absorption_curve(rising, of_point(absorption, point, points)),
                             TemperatureCurve::Table{rising, of_point(weight, point, points)}});
  return mixture;
}

}  // namespace etendue
