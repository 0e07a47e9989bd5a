// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace etendue {

/// L2 and maximum norms of the error of a field and of the reference it is compared with, point by point.
class ErrorNorms {
 public:
  /// `weight` is the volume that the point represents; 0: the point counts in the maximum alone.
  void add(double value, double reference, double weight) {
    square_ += weight * (value - reference) * (value - reference);
    reference_square_ += weight * reference * reference;
    largest_ = std::max(largest_, std::abs(value - reference));
    reference_largest_ = std::max(reference_largest_, std::abs(reference));
  }
  /// Adds the points of another part of the field.
  void add(const ErrorNorms& part) {
    square_ += part.square_;
    reference_square_ += part.reference_square_;
    largest_ = std::max(largest_, part.largest_);
    reference_largest_ = std::max(reference_largest_, part.reference_largest_);
  }
  /// L2 norm of the error relative to that of the reference; not divided where the reference is 0.
  double l2() const { return std::sqrt(reference_square_ > 0 ? square_ / reference_square_ : square_); }
  /// Largest error relative to the largest reference; not divided where the reference is 0.
  double maximum() const { return reference_largest_ > 0 ? largest_ / reference_largest_ : largest_; }

 private:
  double square_ = 0, reference_square_ = 0, largest_ = 0, reference_largest_ = 0;
};

}  // namespace etendue
