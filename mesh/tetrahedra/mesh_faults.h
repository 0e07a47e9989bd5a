// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/errors.h"
#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// A length or volume as people read it: six digits.
std::string to_text(double value);
/// `(x, y, z)`
std::string to_text(const Vec3& point);

/// Collects what is wrong with a mesh. Points and cells are named as its file names them. Only the first
/// few faults of a kind are kept: a mesh that is wrong is often wrong everywhere.
class MeshFaults {
 public:
  explicit MeshFaults(const RawMesh& raw) : raw_(raw) {}

  /// `cell 207: problem (vertices 4 9 31 2, centroid (x, y, z)); advice`
  void add_cell(int cell, const std::string& problem, const std::string& advice);
  /// `face of vertices 4 9 31 at (x, y, z), cells 207 208: problem; advice`, the place being the centroid.
  void add_face(const std::array<std::int32_t, 3>& points, const std::vector<int>& cells,
                const std::string& problem, const std::string& advice);
  void add(const std::string& text) { add_at_line(0, text); }
  /// Throws InputError if anything was added.
  void throw_if_any() const;

  std::string point_name(int point) const;
  std::string cell_name(int cell) const;

 private:
  void add_at_line(int line, const std::string& text);
  int line_of(int cell) const;

  const RawMesh& raw_;
  std::vector<Fault> faults_;
  int left_out_ = 0;
};

}  // namespace etendue
