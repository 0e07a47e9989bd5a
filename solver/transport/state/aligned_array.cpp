// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/state/aligned_array.h"

#include <sys/mman.h>

#include <cstdlib>
#include <cstring>
#include <new>

namespace etendue {
namespace {

constexpr std::size_t cache_line = 64;
constexpr std::size_t huge_page = std::size_t{2} << 20;

void* allocate(std::size_t bytes) {
  if (bytes == 0) return nullptr;
  const std::size_t alignment = bytes >= 2 * huge_page ? huge_page : cache_line;
  const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
  if (rounded < bytes) throw std::bad_alloc();
  void* memory = std::aligned_alloc(alignment, rounded);
  if (memory == nullptr) throw std::bad_alloc();
  // Only advice: where the kernel has no huge pages, small ones serve.
  if (alignment == huge_page) madvise(memory, rounded, MADV_HUGEPAGE);
  return memory;
}

}  // namespace

template <class T>
AlignedArrayOf<T>::AlignedArrayOf(std::size_t size)
    : data_(static_cast<T*>(allocate(size * sizeof(T)))), size_(size) {
  fill_zero();
}

template <class T>
AlignedArrayOf<T>::~AlignedArrayOf() {
  std::free(data_);
}

template <class T>
AlignedArrayOf<T>::AlignedArrayOf(const AlignedArrayOf& other)
    : data_(static_cast<T*>(allocate(other.size_ * sizeof(T)))), size_(other.size_) {
  if (size_ > 0) std::memcpy(data_, other.data_, size_ * sizeof(T));
}

template <class T>
AlignedArrayOf<T>& AlignedArrayOf<T>::operator=(const AlignedArrayOf& other) {
  AlignedArrayOf copy(other);
  return *this = std::move(copy);
}

template <class T>
void AlignedArrayOf<T>::fill_zero() {
  if (size_ > 0) std::memset(data_, 0, size_ * sizeof(T));
}

template class AlignedArrayOf<double>;
template class AlignedArrayOf<float>;

}  // namespace etendue
