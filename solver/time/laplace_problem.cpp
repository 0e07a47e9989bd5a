// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/laplace_problem.h"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

namespace etendue {
namespace {

/// [rate][band][part] the band of the problem.
std::vector<int> repeated_bands(int bands, std::size_t rates) {
  std::vector<int> repeated;
  for (std::size_t rate = 0; rate < rates; ++rate)
    for (int band = 0; band < bands; ++band) repeated.insert(repeated.end(), 2, band);
  return repeated;
}

/// Takes the emission away from every other band: the imaginary parts.
template <class Values, class Value>
void darken_imaginary(Values& values, const Value& dark) {
  for (std::size_t b = 1; b < values.size(); b += 2) values[b] = dark;
}

void darken_imaginary(Medium& medium) {
  darken_imaginary(medium.emission, Coefficient(0.0));
  darken_imaginary(medium.blackbody, Coefficient(0.0));
  darken_imaginary(medium.emission_by_direction, std::nullopt);
}

void darken_imaginary(Wall& wall) {
  darken_imaginary(wall.radiance, 0.0);
  darken_imaginary(wall.radiance_by_direction, std::nullopt);
}

void darken_imaginary(PointLight& light) { darken_imaginary(light.power, 0.0); }
void darken_imaginary(BeamLight& light) { darken_imaginary(light.irradiance, 0.0); }
void darken_imaginary(SurfaceLight& light) { darken_imaginary(light.radiance, 0.0); }

Problem with_real_sources(const Problem& pairs) {
  std::vector<Medium> media(pairs.media().begin(), pairs.media().end());
  for (Medium& medium : media) {
    darken_imaginary(medium);
    medium.uncollided = Uncollided::no;
  }
  std::vector<Wall> walls(pairs.walls().begin(), pairs.walls().end());
  for (Wall& wall : walls) {
    darken_imaginary(wall);
    wall.uncollided = Uncollided::no;
  }
  std::vector<Light> lights(pairs.lights().begin(), pairs.lights().end());
  for (Light& light : lights) {
    std::visit([](auto& kind) { darken_imaginary(kind); }, light.kind);
    light.uncollided = Uncollided::no;
  }
  return Problem(pairs.mesh(), pairs.bands(), std::move(media), std::move(walls), pairs.space(),
                 std::move(lights));
}

AddedExtinction added_extinction(const Problem& problem, std::span<const std::complex<double>> rates,
                                 const Slowness& slowness) {
  AddedExtinction added;
  for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c) {
    const double slow = slowness[static_cast<std::size_t>(problem.mesh().region(CellIndex(c)))];
    for (const std::complex<double>& rate : rates)
      for (int band = 0; band < problem.band_count(); ++band) {
        added.real.push_back(rate.real() * slow);
        added.imaginary.push_back(rate.imag() * slow);
      }
  }
  return added;
}

}  // namespace

LaplaceProblem laplace_problem(const Problem& problem, std::span<const std::complex<double>> rates,
                               const Slowness& slowness) {
  for (const std::complex<double>& rate : rates)
    if (!(rate.real() >= 0 && rate.imag() >= 0))
      throw std::invalid_argument("a rate outside of the first quadrant");
  const std::vector<int> bands = repeated_bands(problem.band_count(), rates.size());
  return {with_real_sources(problem.of_bands(bands)), added_extinction(problem, rates, slowness)};
}

}  // namespace etendue
