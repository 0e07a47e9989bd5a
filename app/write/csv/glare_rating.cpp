// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/csv/glare_rating.h"

#include <fmt/format.h>

#include <limits>
#include <numbers>

#include "app/write/image/false_color_png.h"
#include "app/write/image/seen_luminance.h"

namespace etendue {
namespace {

/// [sr] of the sun's disc, 0.533 degrees across.
constexpr double sun = 6.8e-5;
/// [m^2] Projected area of a lamp without an extent (CIE 147:2002, small sources).
constexpr double small_area = 0.005;
/// [rad] Sources whose middles are nearer are one (evalglare); lamps stand by themselves.
constexpr double search_radius = 0.2;
/// Thresholds up to that are factors of the mean luminance (evalglare).
constexpr double largest_factor = 100;

/// [row][column] which pixels are sources.
std::vector<char> bright_pixels(const Sensor& sensor, const LuminanceView& view,
                                std::span<const double> of_lights) {
  double threshold = sensor.glare_threshold;
  if (threshold <= largest_factor) threshold *= mean_luminance(view);
  std::vector<char> bright;
  for (std::size_t at = 0; at < view.luminance.size(); ++at) {
    const bool is_source =
        sensor.glare_sources == GlareSources::lights ? of_lights[at] > 0 : view.luminance[at] >= threshold;
    bright.push_back(view.solid_angle[at] > 0 && is_source ? 1 : 0);
  }
  return bright;
}

void add_beams(const ObservedView& view, const LineOfSight& sight, const SeenLuminance& seen,
               std::vector<GlareSource>& sources) {
  for (const ObservedView::Beam& beam : view.beams) {
    const double meters = beam.distance * seen.meters();
    const double solid_angle = beam.distance == 0 ? sun : small_area / (meters * meters);
    const double illuminance = seen.in_si(beam.irradiance);
    if (illuminance > 0)
      sources.push_back(
          {beam.towards, illuminance / solid_angle, solid_angle, guth_position_index(sight, beam.towards)});
  }
}

}  // namespace

GlareRating rate_glare(const RunResult& result, const SensorRow& row) {
  const Sensor& sensor = row.place.sensor;
  const ObservedView& view = row.reading.view;
  const SeenLuminance seen(result.input);
  const LineOfSight sight{sensor.direction, sensor.up};
  const auto bands = static_cast<std::size_t>(result.problem.band_count());
  GlareRating rating;
  std::vector<double> of_lights, luminance;
  for (std::size_t at = 0; at < view.solid_angle.size(); ++at) {
    of_lights.push_back(seen.in_si(std::span(view.uncollided).subspan(at * bands, bands)));
    luminance.push_back(of_lights.back() + seen.in_si(std::span(view.collided).subspan(at * bands, bands)));
  }
  const LuminanceView seen_view{view.across, view.directions, view.solid_angle, luminance};
  const std::vector<char> bright = bright_pixels(sensor, seen_view, of_lights);
  rating.sources = glare_sources(seen_view, bright, sight,
                                 sensor.glare_sources == GlareSources::lights ? 0 : search_radius);
  add_beams(view, sight, seen, rating.sources);
  const Measurement& at_eye = row.reading.measurements.front();
  rating.eye_illuminance = seen.in_si(at_eye.uncollided) + seen.in_si(at_eye.collided);
  for (std::size_t at = 0; at < luminance.size(); ++at)
    if (bright[at] == 0 && view.solid_angle[at] > 0)
      rating.background_luminance +=
          luminance[at] * view.solid_angle[at] * view.directions[at].dot(sensor.direction) / std::numbers::pi;
  rating.luminance = luminance;
  for (std::size_t at = 0; at < luminance.size(); ++at)
    if (view.solid_angle[at] == 0) rating.luminance[at] = std::numeric_limits<double>::quiet_NaN();
  return rating;
}

std::vector<SensorTableRow> glare_rows(const RunResult& result, const SensorRow& row) {
  const GlareRating rating = rate_glare(result, row);
  const std::string& name = row.place.name;
  const auto value = [&](const std::string& quantity, double number, const std::string& unit) {
    return SensorTableRow{name, "photopic", quantity, 0, number, 0, unit};
  };
  return {value("background_luminance", rating.background_luminance, "cd/m^2"),
          value("glare_sources", static_cast<double>(rating.sources.size()), "1"),
          value("ugr", unified_glare_rating(rating.sources, rating.background_luminance), "1"),
          value("dgp", daylight_glare_probability(rating.sources, rating.eye_illuminance), "1")};
}

std::string glare_csv(const GlareRating& rating) {
  std::string table = "source,x,y,z,luminance,solid_angle,position_index\n";
  for (std::size_t i = 0; i < rating.sources.size(); ++i) {
    const GlareSource& source = rating.sources[i];
    table += fmt::format("{},{},{},{},{},{},{}\n", i + 1, source.towards.x(), source.towards.y(),
                         source.towards.z(), source.luminance, source.solid_angle, source.position);
  }
  return table;
}

std::string glare_png(const GlareRating& rating, int across) {
  FalseColor scale;
  scale.logarithmic = true;
  return false_color_png({across, across}, rating.luminance, scale, "luminance [cd/m^2]");
}

}  // namespace etendue
