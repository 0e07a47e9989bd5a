// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <etendue/errors.h>

namespace etendue {
ETENDUE_INTERFACE_BEGIN
/// Tetrahedra as a program has them, in any order. The arrays are copied.
struct MeshArrays {
  std::span<const double> points = {};            ///< [point][x, y, z] [length]
  std::span<const std::int32_t> tetrahedra = {};  ///< [tetrahedron][4] index of a point
  std::span<const std::int32_t> regions = {};     ///< [tetrahedron] index into region_names; empty: all 0
  std::vector<std::string> region_names = {"medium"};
  /// [triangle][3] index of a point; on the boundary or between cells
  std::span<const std::int32_t> triangles = {};
  std::span<const std::int32_t> walls = {};  ///< [triangle] index into wall_names
  std::vector<std::string> wall_names = {};  ///< without triangles the whole boundary is "boundary"
};

/// A conforming tetrahedral mesh, checked once and immutable. Copies share it.
///
/// Cells, points and faces are renumbered: those of fields are these, not those of the arrays or the file.
/// The points of a cell and of a face are sorted by number.
class ETENDUE_EXPORT Mesh {
 public:
  /// Throws InputError where cells have no volume, faces do not conform, numbers are out of range, or only
  /// a part of the boundary has walls.
  static Mesh from_arrays(const MeshArrays& arrays);
  /// Reads Gmsh .msh (2.2 and 4.1 ASCII), VTK .vtu and TetGen .node/.ele/.face; coordinates are multiplied
  /// by `scale`. Throws FileError and InputError.
  static Mesh from_file(const std::filesystem::path& file, double scale = 1);
  ~Mesh();
  Mesh(const Mesh&);
  Mesh(Mesh&&) noexcept;
  Mesh& operator=(const Mesh&);
  Mesh& operator=(Mesh&&) noexcept;

  int point_count() const;
  int cell_count() const;
  int boundary_face_count() const;
  std::span<const double> points() const;                ///< [point][x, y, z] [length]
  std::span<const std::int32_t> cells() const;           ///< [cell][4] point
  std::span<const std::int32_t> cell_regions() const;    ///< [cell] index into region_names()
  std::span<const double> volumes() const;               ///< [cell] [length^3]
  std::span<const std::int32_t> boundary_faces() const;  ///< [boundary face][3] point
  std::span<const std::int32_t> face_walls() const;      ///< [boundary face] index into wall_names()
  /// [cell] the cell of the file that it is a part of; empty of a .vtu or .msh of tetrahedra alone.
  std::span<const std::int32_t> parents() const;
  const std::vector<std::string>& region_names() const;
  const std::vector<std::string>& wall_names() const;

  /// Writes .vtu, which from_file() and the key mesh.file read back to the last bit. Throws FileError.
  void write(const std::filesystem::path& file) const;

  struct Impl;
  explicit Mesh(std::shared_ptr<const Impl> impl);
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

ETENDUE_INTERFACE_END
}  // namespace etendue
