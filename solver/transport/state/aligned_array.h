// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <utility>

namespace etendue {

/// A fixed number of numbers, double or float, that start on a cache line and are zero at first. Large ones
/// ask for huge pages. Throws std::bad_alloc.
template <class T>
class AlignedArrayOf {
 public:
  AlignedArrayOf() = default;
  explicit AlignedArrayOf(std::size_t size);
  ~AlignedArrayOf();
  AlignedArrayOf(const AlignedArrayOf& other);
  AlignedArrayOf& operator=(const AlignedArrayOf& other);
  AlignedArrayOf(AlignedArrayOf&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  AlignedArrayOf& operator=(AlignedArrayOf&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return data_[i]; }
  T operator[](std::size_t i) const { return data_[i]; }
  std::span<T> span() { return {data_, size_}; }
  std::span<const T> span() const { return {data_, size_}; }
  void fill_zero();

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

extern template class AlignedArrayOf<double>;
extern template class AlignedArrayOf<float>;

using AlignedArray = AlignedArrayOf<double>;

}  // namespace etendue
