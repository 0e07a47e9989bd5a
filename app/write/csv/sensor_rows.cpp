// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/csv/sensor_rows.h"

#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "app/case/build/daylight.h"
#include "app/write/csv/glare_rating.h"
#include "app/write/csv/illuminance_ratios.h"
#include "app/write/result/unit_labels.h"
#include "solver/observe/color/photometric_units.h"
#include "solver/observe/color/photometry.h"

namespace etendue {
namespace {

using Quantity = RadiometricQuantity;

/// Which unit a quantity has.
enum class Kind { per_area, leaving_area, per_area_and_angle, power, per_angle, path, angle, number };

struct QuantityWords {
  std::string radiometric;
  std::string photometric;
  Kind kind;
};

const std::map<Quantity, QuantityWords> words = {
    {Quantity::irradiance, {"irradiance", "illuminance", Kind::per_area}},
    {Quantity::exitance, {"exitance", "luminous_exitance", Kind::leaving_area}},
    {Quantity::radiosity, {"radiosity", "luminous_exitance", Kind::leaving_area}},
    {Quantity::fluence, {"fluence", "scalar_illuminance", Kind::per_area}},
    {Quantity::radiance, {"radiance", "luminance", Kind::per_area_and_angle}},
    {Quantity::radiance_mean, {"radiance_mean", "luminance_mean", Kind::per_area_and_angle}},
    {Quantity::irradiance_mean, {"irradiance_mean", "illuminance_mean", Kind::per_area}},
    {Quantity::irradiance_least, {"irradiance_least", "illuminance_least", Kind::per_area}},
    {Quantity::irradiance_most, {"irradiance_most", "illuminance_most", Kind::per_area}},
    {Quantity::flux_forward, {"flux_forward", "luminous_flux_forward", Kind::power}},
    {Quantity::flux_backward, {"flux_backward", "luminous_flux_backward", Kind::power}},
    {Quantity::flux_net, {"flux_net", "luminous_flux_net", Kind::power}},
    {Quantity::intensity_most, {"intensity_most", "luminous_intensity_most", Kind::per_angle}},
    {Quantity::path, {"radiance_integral", "", Kind::path}},
    {Quantity::flowing_in, {"flowing_in", "", Kind::power}},
    {Quantity::flowing_out, {"flowing_out", "", Kind::power}},
    {Quantity::emitted, {"emitted", "", Kind::power}},
    {Quantity::absorbed, {"absorbed", "", Kind::power}},
    {Quantity::scattered_in, {"scattered_in", "", Kind::power}},
    {Quantity::scattered_out, {"scattered_out", "", Kind::power}},
    {Quantity::solid_angle, {"solid_angle", "", Kind::angle}},
    {Quantity::account_residual, {"account_residual", "", Kind::number}}};

std::string unit_of(Kind kind, const UnitLabels& units, const std::string& angle) {
  switch (kind) {
    case Kind::per_area:
    case Kind::leaving_area:
      return units.flux;
    case Kind::per_area_and_angle:
      return units.radiance;
    case Kind::power:
      return units.power;
    case Kind::per_angle:
      return units.intensity;
    case Kind::path:
      return units.power.starts_with("1/") ? units.length + units.power.substr(1)
                                           : units.power + " " + units.length;
    case Kind::angle:
      return angle;
    case Kind::number:
      return "1";
  }
  return {};
}

class RowMaker {
 public:
  explicit RowMaker(const RunResult& result)
      : bands_(result.problem.bands()),
        units_(result.input.units),
        labels_(units_, result.problem.space()),
        photon_labels_({.length = units_.length, .power = "1/s"}, result.problem.space()),
        angle_(result.problem.space() == AngularSpace::plane ? "rad" : "sr"),
        photometry_(bands_),
        scale_(si_scale(units_.length, units_.power)) {}

  /// In its own unit, a row for each band.
  void add_radiant(const std::string& sensor, const Measurement& found,
                   std::vector<SensorTableRow>& rows) const {
    const QuantityWords& words_of = words.at(found.quantity);
    for (std::size_t b = 0; b < found.collided.size(); ++b)
      rows.push_back({sensor, bands_.names[b], words_of.radiometric, found.uncollided[b], found.collided[b],
                      found.error[b], unit_of(words_of.kind, labels_, angle_),
                      unit_of(words_of.kind, photon_labels_, angle_)});
  }

  /// `grid` is that of the sensor, which tells where the eye sees most.
  void add(const std::string& sensor, const Measurement& found, const GridReading& grid,
           std::vector<SensorTableRow>& rows) const {
    const QuantityWords& words_of = words.at(found.quantity);
    add_radiant(sensor, found, rows);
    if (!scale_) return;
    if (found.quantity == Quantity::fluence) add_densities(sensor, found, rows);
    if (found.quantity == Quantity::path) add_energy_there(sensor, found, rows);
    if (words_of.kind == Kind::power) add_photons(sensor, words_of.radiometric, found, rows);
    if (photometry_.known() && !words_of.photometric.empty())
      add_photopic(sensor, words_of, as_seen(found, grid), rows);
  }

 private:
  void add_scaled(const std::string& sensor, std::size_t band, const std::string& quantity,
                  const Measurement& found, double factor, const std::string& unit,
                  std::vector<SensorTableRow>& rows) const {
    rows.push_back({sensor, bands_.names[band], quantity, found.uncollided[band] * factor,
                    found.collided[band] * factor, found.error[band] * factor, unit});
  }

  // u/c = phi/c, and as many photons as that energy has.
  void add_densities(const std::string& sensor, const Measurement& found,
                     std::vector<SensorTableRow>& rows) const {
    const double joules = scale_->power / (scale_->length * scale_->length) / speed_of_light;
    for (std::size_t b = 0; b < found.collided.size(); ++b)
      add_scaled(sensor, b, "energy_density", found, joules, "J/m^3", rows);
    for (std::size_t b = 0; b < photometry_.photons_per_joule().size(); ++b)
      add_scaled(sensor, b, "photon_density", found, joules * photometry_.photons_per_joule()[b], "1/m^3",
                 rows);
  }

  // N = integral of u/c over the region and directions, as energy, as photons and as the eye sees it.
  void add_energy_there(const std::string& sensor, const Measurement& found,
                        std::vector<SensorTableRow>& rows) const {
    const double joules = scale_->power * scale_->length / speed_of_light;
    for (std::size_t b = 0; b < found.collided.size(); ++b)
      add_scaled(sensor, b, "energy", found, joules, "J", rows);
    for (std::size_t b = 0; b < photometry_.photons_per_joule().size(); ++b)
      add_scaled(sensor, b, "photons", found, joules * photometry_.photons_per_joule()[b], "1", rows);
    if (photometry_.known())
      rows.push_back({sensor, "photopic", "luminous_energy", joules * photometry_.luminous(found.uncollided),
                      joules * photometry_.luminous(found.collided),
                      joules * photometry_.luminous(found.error), units_.luminous_energy});
  }

  void add_photons(const std::string& sensor, const std::string& quantity, const Measurement& found,
                   std::vector<SensorTableRow>& rows) const {
    for (std::size_t b = 0; b < photometry_.photons_per_joule().size(); ++b)
      add_scaled(sensor, b, "photon_" + quantity, found, scale_->power * photometry_.photons_per_joule()[b],
                 "1/s", rows);
  }

  /// Where bands have their most or least at points of a grid of their own, what is seen at that one where
  /// the eye sees most or least.
  Measurement as_seen(const Measurement& found, const GridReading& grid) const {
    const bool least = found.quantity == Quantity::irradiance_least;
    if (!least && found.quantity != Quantity::irradiance_most && found.quantity != Quantity::intensity_most)
      return found;
    const std::size_t bands = bands_.names.size();
    const auto seen = [&](std::size_t at) {
      const std::span uncollided(grid.uncollided), collided(grid.collided);
      return photometry_.luminous(uncollided.subspan(at, bands)) +
             photometry_.luminous(collided.subspan(at, bands));
    };
    std::size_t best = 0;
    for (std::size_t at = 0; at < grid.collided.size(); at += bands)
      if (std::isnan(seen(best)) || (least ? seen(at) < seen(best) : seen(at) > seen(best))) best = at;
    const auto at_best = [&](const std::vector<double>& values) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(best);
      return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(bands));
    };
    return {found.quantity, at_best(grid.uncollided), at_best(grid.collided), found.error};
  }

  /// A unit of photometry and what a radiant value in the case's units is multiplied by to have it.
  std::pair<std::string, double> photopic_unit(Kind kind) const {
    const double area = scale_->length * scale_->length;
    std::string unit = units_.luminous_flux;
    if (kind == Kind::per_angle) unit = units_.luminous_intensity;
    if (kind == Kind::per_area) unit = units_.illuminance;
    if (kind == Kind::leaving_area) unit = units_.luminous_exitance;
    if (kind == Kind::per_area_and_angle) unit = units_.luminance;
    const bool per_area = kind != Kind::power && kind != Kind::per_angle;
    return {unit, scale_->power / (per_area ? area : 1) / find_photometric_unit(unit)->in_si};
  }

  void add_photopic(const std::string& sensor, const QuantityWords& words_of, const Measurement& found,
                    std::vector<SensorTableRow>& rows) const {
    const auto [unit, factor] = photopic_unit(words_of.kind);
    rows.push_back({sensor, "photopic", words_of.photometric, factor * photometry_.luminous(found.uncollided),
                    factor * photometry_.luminous(found.collided), factor * photometry_.luminous(found.error),
                    unit});
  }

  const Bands& bands_;
  const Units& units_;
  UnitLabels labels_;
  UnitLabels photon_labels_;  ///< of photons per second in place of power
  std::string angle_;
  Photometry photometry_;
  std::optional<SiScale> scale_;
};

void append_rows(const std::vector<SensorTableRow>& more, std::vector<SensorTableRow>& rows) {
  rows.insert(rows.end(), more.begin(), more.end());
}

/// What the unobstructed sky brings to a horizontal plane, in the units of sensors.
std::vector<SensorTableRow> sky_rows(const RunResult& result, const RowMaker& maker) {
  const std::vector<double> nothing(static_cast<std::size_t>(result.problem.band_count()), 0);
  std::vector<SensorTableRow> rows;
  maker.add("sky", {Quantity::irradiance, unobstructed_sky_irradiance(result.input), nothing, nothing}, {},
            rows);
  return rows;
}

}  // namespace

std::vector<SensorTableRow> radiant_rows(const RunResult& result, const SensorRow& row) {
  const RowMaker maker(result);
  std::vector<SensorTableRow> rows;
  for (const Measurement& found : row.reading.measurements) {
    const Kind kind = words.at(found.quantity).kind;
    if (kind != Kind::angle && kind != Kind::number) maker.add_radiant(row.place.name, found, rows);
  }
  return rows;
}

std::vector<SensorTableRow> sensor_rows(const RunResult& result) {
  const RowMaker maker(result);
  std::vector<SensorTableRow> rows;
  for (const SensorRow& row : result.sensors) {
    std::vector<SensorTableRow> of_sensor;
    for (const Measurement& found : row.reading.measurements)
      maker.add(row.place.name, found, row.reading.grid, of_sensor);
    if (row.place.sensor.kind == SensorKind::grid) append_rows(uniformity_rows(of_sensor), of_sensor);
    if (row.place.sensor.kind == SensorKind::glare) append_rows(glare_rows(result, row), of_sensor);
    if (row.place.daylight_factor)
      append_rows(daylight_factor_rows(of_sensor, sky_rows(result, maker)), of_sensor);
    append_rows(of_sensor, rows);
  }
  return rows;
}

}  // namespace etendue
