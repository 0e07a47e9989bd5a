// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "base/expression/formula.h"
#include "base/field_data.h"
#include "solver/materials/media/image_field.h"
#include "solver/materials/media/tetrahedral_field.h"

namespace etendue {

/// Where a field comes from.
struct FieldSource {
  std::string file;         ///< its path; empty: none
  double length_scale = 1;  ///< of the file's coordinates
};

/// A field that is known by numbers on a grid, as a function of the place.
class SampledField : public PlaceFunction {
 public:
  /// `outside` is the value where the grid ends; without it the field is not known there.
  SampledField(std::string name, FieldData data, std::optional<double> outside, FieldSource source = {});

  double at(const Vec3& point) const override;
  bool covers(const Vec3& point) const override;
  double smooth_length(const Vec3& point) const override;
  bool has_jumps() const override { return has_jumps_; }
  std::string name() const override { return name_; }
  const FieldSource& source() const { return source_; }
  /// A number that a field with other values or on another grid will not have.
  std::uint64_t content() const { return content_; }

 private:
  std::optional<double> inside(const Vec3& point) const;

  std::string name_;
  std::uint64_t number_;  ///< of all fields there were
  bool has_jumps_;
  std::uint64_t content_;
  std::variant<ImageField, TetrahedralField> field_;
  std::optional<double> outside_;
  FieldSource source_;
};

}  // namespace etendue
