// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/csv/illuminance_ratios.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace etendue {
namespace {

/// "_mean" of "irradiance_mean" and of "illuminance_mean"; empty for an irradiance at a point.
std::string suffix_of(const SensorTableRow& row) {
  const std::size_t at = row.quantity.find('_');
  return at == std::string::npos ? "" : row.quantity.substr(at);
}

bool is_irradiance(const SensorTableRow& row) {
  const std::string_view name(row.quantity);
  return name.starts_with("irradiance") || name.starts_with("illuminance");
}

const SensorTableRow* find_row(const std::vector<SensorTableRow>& rows, const std::string& band,
                               std::string_view suffix) {
  const auto found = std::ranges::find_if(rows, [&](const SensorTableRow& row) {
    return row.band == band && is_irradiance(row) && suffix_of(row) == suffix;
  });
  return found == rows.end() ? nullptr : &*found;
}

/// Both errors count in full: they may have opposite signs.
SensorTableRow ratio(const SensorTableRow& row, const SensorTableRow& to, const std::string& quantity,
                     double factor, const std::string& unit) {
  const double scale = factor / to.value();
  return {row.sensor,
          row.band,
          quantity,
          scale * row.uncollided,
          scale * row.collided,
          scale * (row.error + row.value() / to.value() * to.error),
          unit};
}

}  // namespace

std::vector<SensorTableRow> uniformity_rows(const std::vector<SensorTableRow>& rows) {
  std::vector<SensorTableRow> ratios;
  for (const SensorTableRow& least : rows) {
    if (suffix_of(least) != "_least") continue;
    const SensorTableRow* mean = find_row(rows, least.band, "_mean");
    const SensorTableRow* most = find_row(rows, least.band, "_most");
    if (mean == nullptr || most == nullptr || !(mean->value() > 0)) continue;
    ratios.push_back(ratio(least, *mean, "uniformity_u0", 1, "1"));
    ratios.push_back(ratio(least, *most, "uniformity_ud", 1, "1"));
  }
  return ratios;
}

std::vector<SensorTableRow> daylight_factor_rows(const std::vector<SensorTableRow>& rows,
                                                 const std::vector<SensorTableRow>& sky) {
  std::vector<SensorTableRow> ratios;
  for (const SensorTableRow& row : rows) {
    if (!is_irradiance(row)) continue;
    const SensorTableRow* outside = find_row(sky, row.band, "");
    if (outside != nullptr && outside->value() > 0)
      ratios.push_back(ratio(row, *outside, "daylight_factor" + suffix_of(row), 100, "%"));
  }
  return ratios;
}

}  // namespace etendue
