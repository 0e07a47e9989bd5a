// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <etendue/mesh.h>

namespace etendue {
ETENDUE_INTERFACE_BEGIN
/// How the iteration of a band ended.
struct BandIteration {
  std::string band;
  int sweeps = 0;
  double residual = 0;  ///< estimated relative error of the iteration
  bool converged = false;
};

/// Powers of a band [power]: emitted + inflow = absorbed + outflow where the solution has converged.
struct BandBalance {
  std::string band;
  double emitted = 0;   ///< by the media
  double inflow = 0;    ///< emitted by walls and lights
  double absorbed = 0;  ///< in the media
  double outflow = 0;   ///< that walls absorb or let out
  double residual = 0;  ///< (emitted + inflow - absorbed - outflow) / (emitted + inflow)
};

/// Totals of a wall and band.
struct WallTotals {
  std::string wall, band;
  double area = 0;             ///< [length^2]
  double irradiance_mean = 0;  ///< [power/length^2]
  double incoming = 0;         ///< arriving from the domain [power]
  double outgoing = 0;         ///< sent into the domain, emitted and reflected [power]
};

/// Totals of a region and band.
struct RegionTotals {
  std::string region, band;
  double volume = 0;        ///< [length^3]
  double fluence_mean = 0;  ///< [power/length^2]
  double absorbed = 0;      ///< [power]
  double emitted = 0;       ///< [power]
};

/// Heat of a wall or region, all bands together.
struct HeatTotals {
  std::string kind, name;  ///< "wall" or "region"
  double extent = 0;       ///< area [m^2] or volume [m^3]
  double emitted = 0;      ///< [W]
  double absorbed = 0;     ///< [W]
  double net = 0;          ///< by radiation: into a wall, out of a region [W]
  double conducted = 0;    ///< from media into a wall [W]
  double convected = 0;    ///< away from a wall [W]
  double temperature = 0;  ///< mean [K]; 0 where there is none
};

/// The field at a point of a probe of the case.
struct ProbeReading {
  std::string probe;
  int index = 0;  ///< of the point in its probe
  std::array<double, 3> point{};
  std::string band;
  double fluence = 0;                ///< [power/length^2]
  std::array<double, 3> net_flux{};  ///< [power/length^2]
  std::optional<double> irradiance;  ///< where the probe has a normal [power/length^2]
};

/// A number of a sensor of the case.
struct SensorReading {
  std::string sensor, band, quantity;
  double uncollided = 0, collided = 0;  ///< value = uncollided + collided
  double value = 0;
  double error = 0;  ///< of the integral over directions
  std::string unit;
};

/// A picture of a camera of the case. Rows begin at the top.
struct Image {
  int width = 0, height = 0, bands = 0;
  std::vector<double> radiance;  ///< [row][column][band] [power/(length^2 sr)]
  std::vector<std::uint8_t>
      srgb;  ///< [row][column][red, green, blue] as the camera's exposure and tone show it
};

/// A solution of a case. Copies share it; spans live as long as one of the copies.
class ETENDUE_EXPORT Solution {
 public:
  ~Solution();
  Solution(const Solution&);
  Solution(Solution&&) noexcept;
  Solution& operator=(const Solution&);
  Solution& operator=(Solution&&) noexcept;

  const Mesh& mesh() const;
  const std::vector<std::string>& bands() const;
  const std::string& method() const;  ///< "gmres", "photons", …
  bool converged() const;
  std::vector<BandIteration> iterations() const;  ///< [band]
  /// Choices that were made, with their reasons.
  const std::vector<std::string>& notes() const;

  // Fields, with the bits that the command writes. They jump between cells.
  std::span<const double> fluence() const;   ///< [cell][4 vertices][band] [power/length^2]
  std::span<const double> net_flux() const;  ///< [cell][4 vertices][x, y, z][band] [power/length^2]
  std::span<const double> irradiance()
      const;                                 ///< [boundary face][3 vertices][band] arriving [power/length^2]
  std::span<const double> exitance() const;  ///< [boundary face][3 vertices][band] sent in [power/length^2]

  /// [cell] at the centroid [K]; 0 where there is none. Empty where nothing has a temperature.
  std::vector<double> cell_temperature() const;
  /// [boundary face][3 vertices] [K]; 0 where there is none. Empty where nothing has a temperature.
  std::vector<double> wall_temperature() const;

  /// [point][band] [power/length^2], as probes read it: by ordinates uncollided light is exact at the
  /// point. NaN outside of the mesh. `points` are [point][x, y, z].
  std::vector<double> fluence_at(std::span<const double> points) const;

  std::vector<BandBalance> balances() const;   ///< [band]
  std::vector<WallTotals> walls() const;       ///< [wall][band]
  std::vector<RegionTotals> regions() const;   ///< [region][band]
  std::vector<HeatTotals> heat() const;        ///< walls, then regions; empty where nothing has a temperature
  std::vector<ProbeReading> probes() const;    ///< [point][band], in the order of the case
  std::vector<SensorReading> sensors() const;  ///< the rows of sensors.csv; empty of photons, which read none

  /// Takes the picture of a camera of the case. Throws InputError where the case has no camera of that
  /// name, and Stopped where `stop`, asked some twenty times a second, returns true.
  Image render(const std::string& camera, const std::function<bool()>& stop = {}) const;
  /// Writes fields.vtu: fluence, net flux and coefficients in every cell. Throws FileError.
  void write_fields(const std::filesystem::path& file) const;
  /// Writes every file that `etendue run` writes but pictures. Throws FileError.
  void write(const std::filesystem::path& directory) const;

  struct Impl;
  explicit Solution(std::shared_ptr<const Impl> impl);

 private:
  std::shared_ptr<const Impl> impl_;
};

ETENDUE_INTERFACE_END
}  // namespace etendue
