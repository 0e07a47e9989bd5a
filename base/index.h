// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace etendue {

/// A number that counts things of one kind. Cells, faces and vertices do not mix by accident.
template <class Tag>
class Index {
 public:
  constexpr explicit Index(std::int64_t value) : value_(static_cast<std::int32_t>(value)) {}
  constexpr std::int32_t value() const { return value_; }
  constexpr std::size_t at() const { return static_cast<std::size_t>(value_); }
  constexpr auto operator<=>(const Index&) const = default;

 private:
  std::int32_t value_;
};

using CellIndex = Index<struct CellTag>;
using FaceIndex = Index<struct FaceTag>;
using VertexIndex = Index<struct VertexTag>;
using OrdinateIndex = Index<struct OrdinateTag>;

}  // namespace etendue
