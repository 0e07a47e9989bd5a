// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <utility>

namespace etendue {

/// A fixed number of values that start on a cache line and are zero at first. Large ones ask for huge pages.
/// Throws std::bad_alloc.
class AlignedArray {
 public:
  AlignedArray() = default;
  explicit AlignedArray(std::size_t size);
  ~AlignedArray();
  AlignedArray(const AlignedArray& other);
  AlignedArray& operator=(const AlignedArray& other);
  AlignedArray(AlignedArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  AlignedArray& operator=(AlignedArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }

  double* data() { return data_; }
  const double* data() const { return data_; }
  std::size_t size() const { return size_; }
  double& operator[](std::size_t i) { return data_[i]; }
  double operator[](std::size_t i) const { return data_[i]; }
  std::span<double> span() { return {data_, size_}; }
  std::span<const double> span() const { return {data_, size_}; }
  void fill_zero();

 private:
  double* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace etendue
