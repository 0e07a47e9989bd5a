// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/media/sampled_field.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <utility>

#include "base/content_hash.h"

namespace etendue {
namespace {

std::variant<ImageField, TetrahedralField> field_of(FieldData data) {
  if (data.image) return ImageField(*data.image, data.on, std::move(data.values));
  return TetrahedralField(std::move(data.points), std::move(data.cells), data.on, std::move(data.values));
}

std::uint64_t content_of(const FieldData& data) {
  ContentHash hash;
  const auto add_point = [&hash](const auto& point) {
    for (const double coordinate : point) hash.add(coordinate);
  };
  if (data.image) {
    add_point(data.image->origin);
    for (int axis = 0; axis < 3; ++axis) add_point(data.image->steps.col(axis));
    for (const std::int32_t count : data.image->points) hash.add(count);
  }
  std::ranges::for_each(data.points, add_point);
  for (const auto& cell : data.cells)
    for (const std::int32_t vertex : cell) hash.add(vertex);
  hash.add(static_cast<std::int32_t>(data.on));
  for (const double value : data.values) hash.add(value);
  return hash.value();
}

std::uint64_t next_number() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

struct Lookup {
  std::uint64_t field = 0;
  Vec3 point = Vec3::Zero();
  double value = 0;
};

}  // namespace

SampledField::SampledField(std::string name, FieldData data, std::optional<double> outside,
                           FieldSource source)
    : name_(std::move(name)),
      number_(next_number()),
      has_jumps_(data.on == FieldValues::on_cells),
      content_(content_of(data)),
      field_(field_of(std::move(data))),
      outside_(outside),
      source_(std::move(source)) {}

std::optional<double> SampledField::inside(const Vec3& point) const {
  return std::visit([&point](const auto& field) { return field.at(point); }, field_);
}

double SampledField::at(const Vec3& point) const {
  // A formula may ask for one place a dozen times, of several fields in turn.
  thread_local std::array<Lookup, 4> lookups;
  Lookup& last = lookups[number_ % lookups.size()];
  if (last.field != number_ || last.point != point)
    last = {number_, point,
            inside(point).value_or(outside_.value_or(std::numeric_limits<double>::quiet_NaN()))};
  return last.value;
}

bool SampledField::covers(const Vec3& point) const { return outside_ || inside(point); }

double SampledField::smooth_length(const Vec3& point) const {
  if (const auto* image = std::get_if<ImageField>(&field_)) return image->cell_length();
  return std::get<TetrahedralField>(field_).cell_length(point);
}

}  // namespace etendue
