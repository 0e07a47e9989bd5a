// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/sensor_rows.h"

#include <map>

#include "app/write/unit_labels.h"
#include "solver/sensors/photometric_units.h"
#include "solver/sensors/photometry.h"

namespace etendue {
namespace {

using Quantity = RadiometricQuantity;

/// Which unit a quantity has.
enum class Kind { per_area, per_area_and_angle, power, per_angle, path, angle, number };

struct QuantityWords {
  std::string radiometric;
  std::string photometric;
  Kind kind;
};

const std::map<Quantity, QuantityWords> words = {
    {Quantity::irradiance, {"irradiance", "illuminance", Kind::per_area}},
    {Quantity::exitance, {"exitance", "luminous_exitance", Kind::per_area}},
    {Quantity::fluence, {"fluence", "scalar_illuminance", Kind::per_area}},
    {Quantity::radiance, {"radiance", "luminance", Kind::per_area_and_angle}},
    {Quantity::radiance_mean, {"radiance_mean", "luminance_mean", Kind::per_area_and_angle}},
    {Quantity::irradiance_mean, {"irradiance_mean", "illuminance_mean", Kind::per_area}},
    {Quantity::irradiance_least, {"irradiance_least", "", Kind::per_area}},
    {Quantity::irradiance_most, {"irradiance_most", "", Kind::per_area}},
    {Quantity::flux_forward, {"flux_forward", "luminous_flux_forward", Kind::power}},
    {Quantity::flux_backward, {"flux_backward", "luminous_flux_backward", Kind::power}},
    {Quantity::flux_net, {"flux_net", "luminous_flux_net", Kind::power}},
    {Quantity::intensity_most, {"intensity_most", "", Kind::per_angle}},
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
      return units.flux;
    case Kind::per_area_and_angle:
      return units.radiance;
    case Kind::power:
      return units.power;
    case Kind::per_angle:
      return units.intensity;
    case Kind::path:
      return units.power + " " + units.length;
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
        angle_(result.problem.space() == AngularSpace::plane ? "rad" : "sr"),
        photometry_(bands_),
        scale_(si_scale(units_.length, units_.power)) {}

  /// In its own unit, a row for each band.
  void add_radiant(const std::string& sensor, const Measurement& found,
                   std::vector<SensorTableRow>& rows) const {
    const QuantityWords& words_of = words.at(found.quantity);
    for (std::size_t b = 0; b < found.collided.size(); ++b)
      rows.push_back({sensor, bands_.names[b], words_of.radiometric, found.uncollided[b], found.collided[b],
                      found.error[b], unit_of(words_of.kind, labels_, angle_)});
  }

  void add(const std::string& sensor, const Measurement& found, std::vector<SensorTableRow>& rows) const {
    const QuantityWords& words_of = words.at(found.quantity);
    add_radiant(sensor, found, rows);
    if (!scale_) return;
    if (found.quantity == Quantity::fluence) add_densities(sensor, found, rows);
    if (found.quantity == Quantity::path) add_photons_there(sensor, found, rows);
    if (words_of.kind == Kind::power) add_photons(sensor, words_of.radiometric, found, rows);
    if (photometry_.known() && !words_of.photometric.empty()) add_photopic(sensor, words_of, found, rows);
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

  // N = integral of u/c over the region and directions, as energy and as photons.
  void add_photons_there(const std::string& sensor, const Measurement& found,
                         std::vector<SensorTableRow>& rows) const {
    const double joules = scale_->power * scale_->length / speed_of_light;
    for (std::size_t b = 0; b < found.collided.size(); ++b)
      add_scaled(sensor, b, "energy", found, joules, "J", rows);
    for (std::size_t b = 0; b < photometry_.photons_per_joule().size(); ++b)
      add_scaled(sensor, b, "photons", found, joules * photometry_.photons_per_joule()[b], "1", rows);
  }

  void add_photons(const std::string& sensor, const std::string& quantity, const Measurement& found,
                   std::vector<SensorTableRow>& rows) const {
    for (std::size_t b = 0; b < photometry_.photons_per_joule().size(); ++b)
      add_scaled(sensor, b, "photon_" + quantity, found, scale_->power * photometry_.photons_per_joule()[b],
                 "1/s", rows);
  }

  void add_photopic(const std::string& sensor, const QuantityWords& words_of, const Measurement& found,
                    std::vector<SensorTableRow>& rows) const {
    std::string unit = "lm";
    double factor = scale_->power;
    if (words_of.kind != Kind::power) {
      unit = words_of.kind == Kind::per_area ? units_.illuminance : units_.luminance;
      factor /= scale_->length * scale_->length * find_photometric_unit(unit)->in_si;
    }
    rows.push_back({sensor, "photopic", words_of.photometric, factor * photometry_.luminous(found.uncollided),
                    factor * photometry_.luminous(found.collided), factor * photometry_.luminous(found.error),
                    unit});
  }

  const Bands& bands_;
  const Units& units_;
  UnitLabels labels_;
  std::string angle_;
  Photometry photometry_;
  std::optional<SiScale> scale_;
};

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
  for (const SensorRow& row : result.sensors)
    for (const Measurement& found : row.reading.measurements) maker.add(row.place.name, found, rows);
  return rows;
}

}  // namespace etendue
