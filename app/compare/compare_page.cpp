// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/compare/compare_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/write/image/color.h"
#include "app/write/image/image_files.h"
#include "base/order_statistics.h"
#include "mesh/tetrahedra/search/cell_locator.h"

namespace etendue {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr int wide = 360;  // pixels of a slice
constexpr double shown_errors = 5;
constexpr Rgb outside = {255, 255, 255};

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// The cell under each pixel of a plane across one axis through the middle of the domain, -1: outside. Rows
/// from the top.
struct Slice {
  int across;  ///< the axis
  std::array<int, 2> pixels;
  std::vector<std::int32_t> cells;
};

Slice slice_of(const TetrahedralMesh& mesh, const CellLocator& locator, int across) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : mesh.points()) box.extend(point);
  const int u = across == 0 ? 1 : 0, v = across == 2 ? 1 : 2;
  const Vec3 size = box.sizes();
  Slice slice{
      across, {wide, std::clamp(static_cast<int>(std::lround(wide * size[v] / size[u])), 1, 4 * wide)}, {}};
  for (int row = 0; row < slice.pixels[1]; ++row)
    for (int column = 0; column < wide; ++column) {
      // A little off the middle, where cells often meet.
      Vec3 point = box.min() + 0.5003 * size;
      point[u] = box.min()[u] + (column + 0.5) / wide * size[u];
      point[v] = box.max()[v] - (row + 0.5) / slice.pixels[1] * size[v];
      const std::vector<CellPoint> found = locator.find(point);
      slice.cells.push_back(found.empty() ? -1 : found.front().cell.value());
    }
  return slice;
}

/// From dark blue over green to yellow, even in lightness.
Rgb brightness_color(double part) {
  const double t = std::clamp(part, 0.0, 1.0);
  constexpr std::array<std::array<double, 3>, 5> stops = {
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
  const auto i = std::min<std::size_t>(3, static_cast<std::size_t>(4 * t));
  const double rest = 4 * t - static_cast<double>(i);
  Rgb color;
  for (std::size_t k = 0; k < 3; ++k)
    color[k] = static_cast<std::uint8_t>(std::lround(stops[i][k] + rest * (stops[i + 1][k] - stops[i][k])));
  return color;
}

/// Blue below, white at zero, red above.
Rgb difference_color(double errors) {
  const double t = std::clamp(std::isfinite(errors) ? errors / shown_errors : 1.0, -1.0, 1.0);
  const auto faded = static_cast<std::uint8_t>(std::lround(255 * (1 - std::abs(t))));
  return t > 0 ? Rgb{255, faded, faded} : Rgb{faded, faded, 255};
}

template <class ColorOfCell>
std::string picture_of(const Slice& slice, const std::string& caption, ColorOfCell&& color) {
  std::vector<std::uint8_t> rgb;
  for (const std::int32_t cell : slice.cells) {
    const Rgb pixel = cell < 0 ? outside : color(static_cast<std::size_t>(cell));
    rgb.insert(rgb.end(), pixel.begin(), pixel.end());
  }
  return fmt::format(
      "<figure><img src=\"data:image/png;base64,{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n",
      base64(png_bytes(slice.pixels, rgb)), caption, caption);
}

/// What is bright in a slice: 99 % of the first answer's pixels are darker.
double white_of(const Slice& slice, const std::vector<double>& values, std::size_t bands, std::size_t band) {
  std::vector<double> seen;
  for (const std::int32_t cell : slice.cells)
    if (cell >= 0) seen.push_back(values[static_cast<std::size_t>(cell) * bands + band]);
  if (seen.empty()) return 1;
  const double white = quantile(std::move(seen), 0.99);
  return white > 0 ? white : 1;
}

std::string pictures_of(const Comparison& comparison, const Slice& slice, const std::string& name,
                        std::size_t bands, std::size_t band) {
  const double white = white_of(slice, comparison.first.cells, bands, band);
  const auto shade = [&](const MethodAnswer& answer) {
    return picture_of(slice, fmt::format("{}, {}", answer.method, name), [&](std::size_t cell) {
      return brightness_color(answer.cells[cell * bands + band] / white);
    });
  };
  const auto difference = [&](std::size_t cell) {
    const std::size_t i = cell * bands + band;
    return difference_color(in_errors(comparison.second.cells[i] - comparison.first.cells[i],
                                      comparison.first.cell_errors[i], comparison.second.cell_errors[i]));
  };
  return "<div class=\"row\">\n" + shade(comparison.first) + shade(comparison.second) +
         picture_of(slice,
                    fmt::format("{} - {}, in errors from -{} (blue) to {} (red)", comparison.second.method,
                                comparison.first.method, shown_errors, shown_errors),
                    difference) +
         "</div>\n";
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : (c == '>' ? "&gt;" : (c == '&' ? "&amp;" : std::string(1, c)));
  return result;
}

}  // namespace

std::string comparison_page(const Comparison& comparison, const Problem& problem, const std::string& title,
                            const std::string& tables) {
  const TetrahedralMesh& mesh = problem.mesh();
  const CellLocator locator(mesh);
  const auto& bands = problem.bands().names;
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n<style>"
      "body{{font-family:sans-serif;margin:2em}}.row{{display:flex;flex-wrap:wrap;gap:1em}}"
      "figure{{margin:0 0 "
      "1em}}figcaption{{font-size:85%;max-width:360px}}pre{{overflow-x:auto}}</style></head>\n"
      "<body><h1>{0}</h1>\n<pre>{1}</pre>\n",
      escaped(title), escaped(tables));
  for (int across = 2; across >= 0; --across) {
    const Slice slice = slice_of(mesh, locator, across);
    page += fmt::format("<h2>Mean fluence of the cells across {} through the middle</h2>\n", "xyz"[across]);
    for (std::size_t b = 0; b < bands.size(); ++b)
      page += pictures_of(comparison, slice, escaped(bands[b]), bands.size(), b);
  }
  return page + "</body></html>\n";
}

}  // namespace etendue
