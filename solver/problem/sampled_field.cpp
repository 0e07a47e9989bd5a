// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/sampled_field.h"

#include <limits>
#include <utility>

namespace etendue {
namespace {

std::variant<ImageField, TetrahedralField> field_of(FieldData data) {
  if (data.image) return ImageField(*data.image, data.on, std::move(data.values));
  return TetrahedralField(std::move(data.points), std::move(data.cells), data.on, std::move(data.values));
}

}  // namespace

SampledField::SampledField(std::string name, FieldData data, std::optional<double> outside)
    : name_(std::move(name)),
      has_jumps_(data.on == FieldValues::on_cells),
      field_(field_of(std::move(data))),
      outside_(outside) {}

std::optional<double> SampledField::inside(const Vec3& point) const {
  return std::visit([&point](const auto& field) { return field.at(point); }, field_);
}

double SampledField::at(const Vec3& point) const {
  return inside(point).value_or(outside_.value_or(std::numeric_limits<double>::quiet_NaN()));
}

bool SampledField::covers(const Vec3& point) const { return outside_ || inside(point); }

double SampledField::smooth_length(const Vec3& point) const {
  if (const auto* image = std::get_if<ImageField>(&field_)) return image->cell_length();
  return std::get<TetrahedralField>(field_).cell_length(point);
}

}  // namespace etendue
