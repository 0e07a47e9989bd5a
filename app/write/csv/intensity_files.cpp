// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/csv/intensity_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "app/write/csv/csv_field.h"
#include "app/write/result/unit_labels.h"
#include "solver/observe/color/photometry.h"
#include "solver/observe/sensors/wall_intensity.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Values at polar angle k and azimuth j.
class Diagram {
 public:
  Diagram(const RunResult& result, const SensorRow& row)
      : grid_(row.reading.grid),
        bands_(result.problem.bands().names.size()),
        count_(row.place.sensor.count) {}

  int azimuths() const { return count_[0]; }
  int polar_angles() const { return count_[1]; }
  double polar(int k) const { return polar_angle(k, count_[1]); }
  // In degrees, round numbers as they are.
  double polar_degrees(int k) const { return count_[1] > 1 ? 90. * k / (count_[1] - 1) : 0; }
  double azimuth_degrees(int j) const { return 360. * j / count_[0]; }
  double uncollided(int k, int j, std::size_t band) const { return grid_.uncollided[at(k, j, band)]; }
  double collided(int k, int j, std::size_t band) const { return grid_.collided[at(k, j, band)]; }
  std::span<const double> uncollided(int k, int j) const {
    return std::span(grid_.uncollided).subspan(at(k, j, 0), bands_);
  }
  std::span<const double> collided(int k, int j) const {
    return std::span(grid_.collided).subspan(at(k, j, 0), bands_);
  }
  double sum(int k, int j) const {
    double total = 0;
    for (const std::span<const double> part : {uncollided(k, j), collided(k, j)})
      for (const double value : part) total += value;
    return total;
  }

 private:
  std::size_t at(int k, int j, std::size_t band) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(count_[0]) +
            static_cast<std::size_t>(j % count_[0])) *
               bands_ +
           band;
  }

  const GridReading& grid_;
  std::size_t bands_;
  std::array<int, 2> count_;
};

/// From radiant intensity to candela.
class CandelaScale {
 public:
  explicit CandelaScale(const RunResult& result)
      : photometry_(result.problem.bands()),
        scale_(si_scale(result.input.units.length, result.input.units.power)) {}
  /// Whether the eye sees the bands, and the units are known.
  bool known() const { return photometry_.known() && scale_; }
  const std::string& rule() const { return photometry_.rule(); }
  double of(std::span<const double> radiant) const { return scale_->power * photometry_.luminous(radiant); }

 private:
  Photometry photometry_;
  std::optional<SiScale> scale_;
};

/// The corners of a curve: one plane through the axis, from one side to the other, downwards.
std::string curve(const Diagram& diagram, int azimuth, double scale) {
  std::string points;
  const auto add = [&](int k, int j, double side) {
    const double length = scale * diagram.sum(k, j), angle = diagram.polar(k);
    points += fmt::format("{:.2f},{:.2f} ", side * length * std::sin(angle), length * std::cos(angle));
  };
  for (int k = diagram.polar_angles() - 1; k >= 0; --k) add(k, azimuth + diagram.azimuths() / 2, -1);
  for (int k = 1; k < diagram.polar_angles(); ++k) add(k, azimuth, 1);
  return points;
}

}  // namespace

std::string intensity_csv(const RunResult& result, const SensorRow& row) {
  const Diagram diagram(result, row);
  const CandelaScale candela(result);
  const std::vector<std::string>& bands = result.problem.bands().names;
  const UnitLabels labels(result.input.units);
  std::string table = "polar,azimuth,band,uncollided,collided,intensity,unit\n";
  for (int k = 0; k < diagram.polar_angles(); ++k)
    for (int j = 0; j < diagram.azimuths(); ++j) {
      const auto add = [&](const std::string& band, double uncollided, double collided,
                           const std::string& unit) {
        table += fmt::format("{},{},{},{},{},{},{}\n", diagram.polar_degrees(k), diagram.azimuth_degrees(j),
                             csv_field(band), uncollided, collided, uncollided + collided, csv_field(unit));
      };
      for (std::size_t b = 0; b < bands.size(); ++b)
        add(bands[b], diagram.uncollided(k, j, b), diagram.collided(k, j, b), labels.intensity);
      if (candela.known())
        add("photopic", candela.of(diagram.uncollided(k, j)), candela.of(diagram.collided(k, j)),
            result.input.units.luminous_intensity);
    }
  return table;
}

std::string intensity_svg(const RunResult& result, const SensorRow& row) {
  const Diagram diagram(result, row);
  double most = 0;
  for (int k = 0; k < diagram.polar_angles(); ++k)
    for (int j = 0; j < diagram.azimuths(); ++j) most = std::max(most, diagram.sum(k, j));
  constexpr double radius = 200;
  const double scale = most > 0 ? radius / most : 0;
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-240 -40 480 290\" font-family=\"sans-serif\" "
      "font-size=\"11\">\n<rect x=\"-240\" y=\"-40\" width=\"480\" height=\"290\" fill=\"white\"/>\n";
  for (int ring = 1; ring <= 4; ++ring)
    svg += fmt::format("<path d=\"M {0} 0 A {1} {1} 0 0 0 {1} 0\" fill=\"none\" stroke=\"#ccc\"/>\n",
                       -radius * ring / 4, radius * ring / 4);
  for (int angle = -90; angle <= 90; angle += 30) {
    const double x = std::sin(angle * pi / 180), y = std::cos(angle * pi / 180);
    svg += fmt::format(
        "<line x1=\"0\" y1=\"0\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"#ccc\"/>\n<text x=\"{:.2f}\" "
        "y=\"{:.2f}\" "
        "text-anchor=\"middle\" fill=\"#666\">{}°</text>\n",
        radius * x, radius * y, 1.1 * radius * x, 1.1 * radius * y + 4, std::abs(angle));
  }
  svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"#c33\" stroke-width=\"2\"/>\n",
                     curve(diagram, 0, scale));
  if (diagram.azimuths() % 4 == 0)
    svg += fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"#36c\" stroke-width=\"2\" stroke-dasharray=\"6 "
        "4\"/>\n",
        curve(diagram, diagram.azimuths() / 4, scale));
  svg += fmt::format(
      "<text x=\"-230\" y=\"-22\">{}: radiant intensity, outer circle {:.4g} {}; azimuth 0 red, 90° blue "
      "dashed</text>\n</svg>\n",
      row.place.name, most, UnitLabels(result.input.units).intensity);
  return svg;
}

std::string intensity_ies(const RunResult& result, const SensorRow& row) {
  const CandelaScale candela(result);
  if (!candela.known()) return "";
  const Diagram diagram(result, row);
  std::string text = fmt::format(
      "IESNA:LM-63-2002\n[TEST] {}\n[TESTLAB] etendue\n[ISSUEDATE] none\n[MANUFAC] none\n[LUMINAIRE] light "
      "that leaves by the wall {}; {}\nTILT=NONE\n1 -1 1 {} {} 1 2 0 0 0\n1 1 0\n",
      row.place.name, row.place.wall, candela.rule(), diagram.polar_angles(), diagram.azimuths() + 1);
  for (int k = 0; k < diagram.polar_angles(); ++k) text += fmt::format("{:.6g}\n", diagram.polar_degrees(k));
  for (int j = 0; j <= diagram.azimuths(); ++j) text += fmt::format("{:.6g}\n", diagram.azimuth_degrees(j));
  for (int j = 0; j <= diagram.azimuths(); ++j)
    for (int k = 0; k < diagram.polar_angles(); ++k)
      text +=
          fmt::format("{:.6g}\n", candela.of(diagram.uncollided(k, j)) + candela.of(diagram.collided(k, j)));
  return text;
}

}  // namespace etendue
