// SPDX-License-Identifier: AGPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "base/array_bytes.h"
#include "base/errors.h"
#include "mesh/geometry/surface_files/bounded_child.h"
#include "mesh/geometry/surface_files/polygon_soup.h"

namespace etendue {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Place = std::array<double, 3>;

/// Runs in the child process: CGAL's readers trust the counts in a file. Writes the points, the number
/// of corners of each polygon, and the corners of all.
void read_to_file(const std::filesystem::path& path, std::FILE* file) {
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  const bool is_read = CGAL::IO::read_polygon_soup(path.string(), points, polygons);
  std::vector<Place> places;
  for (const Kernel::Point_3& p : points) places.push_back({p.x(), p.y(), p.z()});
  std::vector<std::size_t> sizes;
  std::vector<std::int32_t> corners;
  bool is_whole = is_read && points.size() <= std::numeric_limits<std::int32_t>::max();
  for (const std::vector<std::size_t>& polygon : polygons) {
    sizes.push_back(polygon.size());
    for (const std::size_t corner : polygon) {
      is_whole = is_whole && corner < points.size();
      corners.push_back(static_cast<std::int32_t>(corner));
    }
  }
  if (!is_whole)
    throw std::invalid_argument(
        fmt::format("is not a whole {} file (CGAL cannot read it)", path.extension().string()));
  write_array(file, places);
  write_array(file, sizes);
  write_array(file, corners);
}

PolygonSoup soup_from(std::string_view bytes) {
  PolygonSoup soup;
  for (const Place& p : take_array<Place>(bytes)) {
    soup.points.emplace_back(p[0], p[1], p[2]);
    if (!soup.points.back().allFinite())
      throw std::invalid_argument(fmt::format("point {} is not finite", soup.points.size() - 1));
  }
  const std::vector<std::size_t> sizes = take_array<std::size_t>(bytes);
  const std::vector<std::int32_t> corners = take_array<std::int32_t>(bytes);
  auto corner = corners.begin();
  for (const std::size_t size : sizes) {
    const auto end = corner + static_cast<std::ptrdiff_t>(size);
    soup.polygons.emplace_back(corner, end);
    corner = end;
  }
  soup.walls.assign(soup.polygons.size(), 0);
  soup.wall_names = {"boundary"};
  return soup;
}

}  // namespace

PolygonSoup read_by_cgal(const std::filesystem::path& path) {
  try {
    return soup_from(bytes_of_child("CGAL", limits_for_file(std::filesystem::file_size(path)),
                                    [&](std::FILE* file) { read_to_file(path, file); }));
  } catch (const std::invalid_argument& problem) {
    throw InputError(Fault{path.string(), 0, problem.what()});
  }
}

}  // namespace etendue
