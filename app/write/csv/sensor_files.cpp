// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/csv/sensor_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "app/write/csv/csv_field.h"
#include "app/write/csv/glare_rating.h"
#include "app/write/csv/intensity_files.h"
#include "app/write/csv/sensor_rows.h"
#include "app/write/image/image_files.h"
#include "app/write/image/toned_png.h"
#include "app/write/result/unit_labels.h"
#include "solver/observe/color/photometry.h"

namespace etendue {
namespace {

std::string grid_csv(const RunResult& result, const SensorRow& row) {
  const std::vector<std::string>& bands = result.problem.bands().names;
  const Sensor& sensor = row.place.sensor;
  const GridReading& grid = row.reading.grid;
  std::string table = "column,row,x,y,z,band,uncollided,collided,irradiance\n";
  std::size_t at = 0;
  for (int j = 0; j < sensor.count[1]; ++j)
    for (int i = 0; i < sensor.count[0]; ++i)
      for (const std::string& band : bands) {
        if (std::isnan(grid.collided[at])) {
          ++at;
          continue;
        }
        const Vec3 point = grid_point(sensor, i, j);
        table += fmt::format("{},{},{},{},{},{},{},{},{}\n", i, j, point.x(), point.y(), point.z(),
                             csv_field(band), grid.uncollided[at], grid.collided[at],
                             grid.uncollided[at] + grid.collided[at]);
        ++at;
      }
  return table;
}

std::string grid_exr(const RunResult& result, const SensorRow& row) {
  const std::vector<std::string>& bands = result.problem.bands().names;
  const GridReading& grid = row.reading.grid;
  std::vector<ImageChannel> channels;
  for (std::size_t b = 0; b < bands.size(); ++b) {
    ImageChannel whole{"irradiance." + bands[b], {}}, uncollided{"uncollided." + bands[b], {}};
    for (std::size_t at = b; at < grid.collided.size(); at += bands.size()) {
      whole.values.push_back(static_cast<float>(grid.uncollided[at] + grid.collided[at]));
      uncollided.values.push_back(static_cast<float>(grid.uncollided[at]));
    }
    channels.push_back(std::move(whole));
    channels.push_back(std::move(uncollided));
  }
  return exr_bytes(row.place.sensor.count, channels,
                   fmt::format("irradiance [{}]", UnitLabels(result.input.units).flux));
}

/// A square of so many pixels for each part of a grid: the longer side has about this many.
constexpr int pixels_of_a_grid = 512;

/// The grid as colors, as a camera would have them of a white paper there; what is outside of the mesh is
/// black.
std::string grid_png(const RunResult& result, const SensorRow& row) {
  const GridReading& grid = row.reading.grid;
  const std::array<int, 2> parts = row.place.sensor.count;
  const std::size_t bands = result.problem.bands().names.size();
  const BandColor rule(result.problem.bands());
  const WhiteBalance white(result.problem.bands());
  const int block = std::max(1, pixels_of_a_grid / std::max(parts[0], parts[1]));
  std::vector<LinearColor> colors;
  for (int y = 0; y < parts[1] * block; ++y)
    for (int x = 0; x < parts[0] * block; ++x) {
      const auto first = static_cast<std::size_t>(y / block * parts[0] + x / block) * bands;
      if (std::isnan(grid.collided[first])) {
        colors.push_back({0, 0, 0});
        continue;
      }
      std::vector<double> irradiance;
      for (std::size_t i = first; i < first + bands; ++i)
        irradiance.push_back(grid.uncollided[i] + grid.collided[i]);
      colors.push_back(white.of(rule.of(irradiance)));
    }
  return toned_png({parts[0] * block, parts[1] * block}, colors, std::nullopt, Tone::linear);
}

/// Significant digits that are told: of what a view is rated by, of what has no error, and at most.
constexpr int digits_of_a_view = 3, digits_without_error = 4, most_digits = 6;

bool is_of_a_view(const SensorTableRow& row) {
  return row.quantity == "background_luminance" || row.quantity == "glare_sources" || row.quantity == "ugr" ||
         row.quantity == "dgp";
}

bool has_no_sources(const std::string& sensor, const std::vector<SensorTableRow>& rows) {
  return std::ranges::any_of(rows, [&](const SensorTableRow& row) {
    return row.sensor == sensor && row.quantity == "glare_sources" && row.value() == 0;
  });
}

/// " W/m^2"; of a plain number nothing.
std::string unit_text(const SensorTableRow& row) { return row.unit == "1" ? "" : " " + row.unit; }

std::string rating_text(const SensorTableRow& row, const std::vector<SensorTableRow>& rows) {
  if (row.quantity == "glare_sources") return fmt::format("{:.0f}", row.value());
  if (row.quantity == "ugr" && has_no_sources(row.sensor, rows)) return "no sources";
  return fmt::format("{:.{}g}{}", row.value(), digits_of_a_view, unit_text(row));
}

/// Digits down to the second of the error.
int digits_of(double value, double error) {
  if (!(error > 0) || value == 0 || !std::isfinite(error)) return digits_without_error;
  const double places = std::floor(std::log10(std::abs(value))) - std::floor(std::log10(error)) + 2;
  return static_cast<int>(std::clamp(places, 1., static_cast<double>(most_digits)));
}

std::string reading_text(const SensorTableRow& row) {
  const std::string left = row.error > 0 ? fmt::format(", rays leave {:.1g}", row.error) : "";
  return fmt::format("{:.{}g}{} (uncollided {:.{}g}{})", row.value(), digits_of(row.value(), row.error),
                     unit_text(row), row.uncollided, digits_of(row.uncollided, row.error), left);
}

}  // namespace

std::string sensors_csv(const RunResult& result) {
  std::string table = "sensor,band,quantity,uncollided,collided,value,unit,error\n";
  for (const SensorTableRow& row : sensor_rows(result))
    table +=
        fmt::format("{},{},{},{},{},{},{},{}\n", csv_field(row.sensor), csv_field(row.band), row.quantity,
                    row.uncollided, row.collided, row.value(), csv_field(row.unit), row.error);
  return table;
}

/// The quantities of a sensor over wavelengths: what each band brings, per nanometre too, and as photons.
std::string spectrum_csv(const RunResult& result, const SensorRow& row) {
  const Bands& bands = result.problem.bands();
  std::string table =
      "quantity,band,from_nm,to_nm,photon_energy_J,uncollided,collided,value,unit,per_nm,photons,"
      "photon_unit\n";
  const std::optional<SiScale> scale = si_scale(result.input.units.length, result.input.units.power);
  const Photometry photometry(bands);
  const std::span<const double> photons = photometry.photons_per_joule();
  for (const SensorTableRow& value : radiant_rows(result, row)) {
    const auto b = static_cast<std::size_t>(std::ranges::find(bands.names, value.band) - bands.names.begin());
    const double width = std::abs(bands.edges[b + 1] - bands.edges[b]);
    table += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", value.quantity, csv_field(value.band),
                         std::min(bands.edges[b], bands.edges[b + 1]),
                         std::max(bands.edges[b], bands.edges[b + 1]), 1 / photons[b], value.uncollided,
                         value.collided, value.value(), csv_field(value.unit), value.value() / width,
                         scale ? fmt::format("{}", value.value() * scale->power * photons[b]) : "",
                         scale ? csv_field(value.photon_unit) : "");
  }
  return table;
}

std::string sensors_text(const RunResult& result) {
  std::string text;
  const std::vector<SensorTableRow> rows = sensor_rows(result);
  for (const SensorTableRow& row : rows) {
    text += fmt::format("sensor {}: {} {} ", row.sensor, row.quantity, row.band);
    text += is_of_a_view(row) ? rating_text(row, rows) : reading_text(row);
    text += '\n';
  }
  const Photometry photometry(result.problem.bands());
  if (!text.empty() && photometry.known()) text += "  photopic: " + photometry.rule() + "\n";
  return text;
}

void add_sensor_files(const RunResult& result, OutputFolder& folder) {
  if (result.sensors.empty()) return;
  folder.add_text("sensors.csv", sensors_csv(result));
  for (const SensorRow& row : result.sensors) {
    const std::string& name = row.place.name;
    if (!result.problem.bands().edges.empty())
      folder.add_text(name + ".spectrum.csv", spectrum_csv(result, row));
    if (row.place.sensor.kind == SensorKind::grid) {
      folder.add_text(name + ".grid.csv", grid_csv(result, row));
      folder.add_text(name + ".grid.exr", grid_exr(result, row));
      folder.add_text(name + ".grid.png", grid_png(result, row));
    }
    if (row.place.sensor.kind == SensorKind::glare) {
      const GlareRating rating = rate_glare(result, row);
      folder.add_text(name + ".glare.csv", glare_csv(rating));
      folder.add_text(name + ".glare.png", glare_png(rating, row.reading.view.across));
    }
    if (row.place.sensor.kind != SensorKind::intensity) continue;
    folder.add_text(name + ".intensity.csv", intensity_csv(result, row));
    folder.add_text(name + ".intensity.svg", intensity_svg(result, row));
    const std::string ies = intensity_ies(result, row);
    if (!ies.empty()) folder.add_text(name + ".ies", ies);
  }
}

}  // namespace etendue
