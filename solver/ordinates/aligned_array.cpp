// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/aligned_array.h"

#include <sys/mman.h>

#include <cstdlib>
#include <cstring>
#include <new>

namespace etendue {
namespace {

constexpr std::size_t cache_line = 64;
constexpr std::size_t huge_page = std::size_t{2} << 20;

double* allocate(std::size_t size) {
  if (size == 0) return nullptr;
  const std::size_t bytes = size * sizeof(double);
  const std::size_t alignment = bytes >= 2 * huge_page ? huge_page : cache_line;
  const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
  if (rounded < bytes) throw std::bad_alloc();
  void* memory = std::aligned_alloc(alignment, rounded);
  if (memory == nullptr) throw std::bad_alloc();
  // Only advice: where the kernel has no huge pages, small ones serve.
  if (alignment == huge_page) madvise(memory, rounded, MADV_HUGEPAGE);
  return static_cast<double*>(memory);
}

}  // namespace

AlignedArray::AlignedArray(std::size_t size) : data_(allocate(size)), size_(size) { fill_zero(); }

AlignedArray::~AlignedArray() { std::free(data_); }

AlignedArray::AlignedArray(const AlignedArray& other) : data_(allocate(other.size_)), size_(other.size_) {
  if (size_ > 0) std::memcpy(data_, other.data_, size_ * sizeof(double));
}

AlignedArray& AlignedArray::operator=(const AlignedArray& other) {
  AlignedArray copy(other);
  return *this = std::move(copy);
}

void AlignedArray::fill_zero() {
  if (size_ > 0) std::memset(data_, 0, size_ * sizeof(double));
}

}  // namespace etendue
