// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/name_table.h"
#include "base/text/text_lines.h"
#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// What both versions of the Gmsh format have in common: points and elements with tags, and the names of
/// physical groups.
class GmshElements {
 public:
  /// Reads the section of names; the line is its opening.
  void read_physical_names(TextLines& lines);
  void add_point(TextLines& lines, std::int64_t tag, const Vec3& point);
  /// Reads the points of an element from the rest of the line. Tetrahedra become cells, triangles of a
  /// physical group become walls; lines, points and quadrangles are passed over. physical 0: in no group.
  void add_element(TextLines& lines, std::int64_t tag, std::int64_t type, std::int64_t physical);
  RawMesh take(const std::string& file) &&;

 private:
  int point_index(TextLines& lines) const;
  std::string name(int dimension, std::int64_t physical) const;

  RawMesh mesh_;
  std::unordered_map<std::int64_t, int> points_;                        ///< [tag]
  std::map<std::pair<std::int64_t, std::int64_t>, std::string> names_;  ///< [dimension, physical tag]
  NameTable regions_;
  NameTable walls_;
};

}  // namespace etendue
