// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/fields/field_data_bytes.h"

#include <algorithm>

#include "base/array_bytes.h"

namespace etendue {
namespace {

using Place = std::array<double, 3>;

/// Of an image: its points along the axes, its origin and its steps; nothing where there is none.
struct GridNumbers {
  std::array<int, 3> points;
  std::array<double, 3> origin;
  std::array<double, 9> steps;
};

std::vector<GridNumbers> numbers_of(const std::optional<ImageGrid>& grid) {
  if (!grid) return {};
  GridNumbers numbers{grid->points, {}, {}};
  std::copy_n(grid->origin.data(), 3, numbers.origin.begin());
  std::copy_n(grid->steps.data(), 9, numbers.steps.begin());
  return {numbers};
}

}  // namespace

void write_field_data(std::FILE* file, const FieldData& field) {
  write_array(file, numbers_of(field.image));
  std::vector<Place> places;
  places.reserve(field.points.size());
  for (const Vec3& point : field.points) places.push_back({point.x(), point.y(), point.z()});
  write_array(file, places);
  write_array(file, field.cells);
  write_array(file, std::vector<FieldValues>{field.on});
  write_array(file, field.values);
}

FieldData take_field_data(std::string_view bytes) {
  FieldData field;
  for (const GridNumbers& numbers : take_array<GridNumbers>(bytes)) {
    field.image.emplace().points = numbers.points;
    std::ranges::copy(numbers.origin, field.image->origin.data());
    std::ranges::copy(numbers.steps, field.image->steps.data());
  }
  for (const auto& [x, y, z] : take_array<Place>(bytes)) field.points.emplace_back(x, y, z);
  field.cells = take_array<std::array<int, 4>>(bytes);
  field.on = take_value<FieldValues>(bytes);
  field.values = take_array<double>(bytes);
  return field;
}

}  // namespace etendue
