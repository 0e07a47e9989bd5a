// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "base/vec3.h"

namespace etendue {

/// A function of the place that has no formula, e.g. a field from a file. Threads may ask at the same time.
class PlaceFunction {
 public:
  virtual ~PlaceFunction() = default;

  /// Not a number where the function is not known.
  virtual double at(const Vec3& point) const = 0;
  virtual bool covers(const Vec3& point) const = 0;
  /// Length over which the function is smooth around a point [length]; infinite where it is smooth.
  virtual double smooth_length(const Vec3& point) const = 0;
  /// Returns whether it is constant in parts of space and jumps between them.
  virtual bool has_jumps() const = 0;
  /// What it is, for messages.
  virtual std::string name() const = 0;
};

/// The text of a formula, and the functions of x, y, z that it calls by name beside the usual ones.
struct Formula {
  using Functions = std::map<std::string, std::shared_ptr<const PlaceFunction>>;

  Formula() = default;
  Formula(std::string the_text, Functions the_functions = {})
      : text(std::move(the_text)), functions(std::move(the_functions)) {}
  Formula(const char* the_text) : text(the_text) {}

  std::string text;
  Functions functions;
};

}  // namespace etendue
