// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/resolution_text.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "solver/transport/cells/cell_coefficients.h"

namespace etendue {
namespace {

/// Transport mean free paths of a cell at a light above which what it absorbs is off by 2 % and more: skin
/// under a beam by 3.4 % with 2.3, by 2.5 % with 1.1 (validation/benchmarks/tissue).
constexpr double thick_cell = 1;
/// Distances of directions in half widths of a phase function above which results are off by percents, and
/// of directions that are fine enough: tissue with g = 0.9 by 2.5 % with 4.4, by 0.9 % with 2.2.
constexpr double coarse_directions = 4, fine_directions = 2.2;
/// Numbers of directions that are worth a try.
constexpr double most_directions = 1e5;

bool has_thick_cells(const Resolution& resolution) {
  return resolution.transport_thickness_at_lights > thick_cell;
}

bool has_coarse_directions(const Resolution& resolution) {
  return resolution.narrowest &&
         resolution.direction_spacing > coarse_directions * resolution.narrowest->half_width;
}

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

std::string cells_line(const Resolution& resolution) {
  if (resolution.largest_thickness <= 0) return "";
  std::string text = fmt::format("cells: {:.2g} mean free paths thick (median), {:.2g} at most",
                                 resolution.median_thickness, resolution.largest_thickness);
  if (resolution.transport_thickness_at_lights > 0)
    text +=
        fmt::format("; at lights {:.2g} transport mean free paths", resolution.transport_thickness_at_lights);
  if (resolution.thick_count > 0)
    text += fmt::format("; mass lumped in {} of {} cells and bands (thicker than {})", resolution.thick_count,
                        resolution.pair_count, lumping_thickness);
  return text + "\n";
}

}  // namespace

bool is_coarse(const Resolution& resolution) {
  return has_thick_cells(resolution) || has_coarse_directions(resolution);
}

std::string resolution_text(const Resolution& resolution, bool by_photons_too) {
  std::string text = cells_line(resolution);
  if (has_thick_cells(resolution))
    text += fmt::format(
        "caution: cells at lights are {:.2g} transport mean free paths thick (median), and what they absorb "
        "may be off by several percent; use finer cells there (mesh.max_volume){}\n",
        resolution.transport_thickness_at_lights, by_photons_too ? ", or solve.method = \"photons\"" : "");
  if (has_coarse_directions(resolution)) {
    const double needed =
        4 * std::numbers::pi / std::pow(fine_directions * resolution.narrowest->half_width, 2);
    const std::string finer = needed < most_directions
                                  ? fmt::format("{:.0f} directions or more", std::ceil(needed))
                                  : "more directions";
    text += fmt::format(
        "caution: directions are {:.2g} degrees apart, and light that scatters in {} turns by less than "
        "{:.2g} degrees (half width): beams and shadows may be off by percents; use {}{}\n",
        degrees(resolution.direction_spacing), resolution.narrowest->region,
        degrees(resolution.narrowest->half_width), finer,
        by_photons_too ? ", or solve.method = \"photons\"" : "");
  }
  return text;
}

}  // namespace etendue
