// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/api/mesh_impl.h"
#include "app/api/translated.h"
#include "mesh/files/mesh_file.h"

namespace etendue::v0 {
namespace {

/// A case must name a geometry: of arrays, a file that is always there and holds none.
constexpr const char* source_of_arrays = R"({ file = "/dev/null" })";

[[noreturn]] void refuse(const std::string& text) { throw etendue::InputError(text); }

/// Throws where a list of numbers does not consist of groups of `size`, or where one is not from 0 to below
/// `count`.
void check_indices(const char* name, std::span<const std::int32_t> numbers, std::size_t size,
                   std::size_t count, const std::string& of) {
  if (numbers.size() % size != 0)
    refuse(fmt::format("{}: {} numbers are no groups of {}; give {} for each", name, numbers.size(), size,
                       size));
  const auto bad = std::ranges::find_if(
      numbers, [&](std::int32_t number) { return number < 0 || static_cast<std::size_t>(number) >= count; });
  if (bad == numbers.end()) return;
  refuse(fmt::format("{}[{}] = {}: there are {} {}; use 0 to {}", name,
                     (bad - numbers.begin()) / static_cast<long>(size), *bad, count, of,
                     count > 0 ? count - 1 : 0));
}

void check_lengths(const char* name, std::size_t length, const char* of, std::size_t wanted) {
  if (length != wanted)
    refuse(fmt::format("{}: {} numbers for {} {}; give one for each", name, length, wanted, of));
}

void check(const MeshArrays& arrays) {
  if (arrays.points.size() % 3 != 0)
    refuse(
        fmt::format("points: {} coordinates are no points; give x, y and z of each", arrays.points.size()));
  const auto bad = std::ranges::find_if(arrays.points, [](double value) { return !std::isfinite(value); });
  if (bad != arrays.points.end())
    refuse(fmt::format("points[{}]: {} is no coordinate; use finite numbers",
                       (bad - arrays.points.begin()) / 3, *bad));
  if (arrays.tetrahedra.empty()) refuse("tetrahedra: the mesh has none; give at least one");
  check_indices("tetrahedra", arrays.tetrahedra, 4, arrays.points.size() / 3, "points");
  check_indices("triangles", arrays.triangles, 3, arrays.points.size() / 3, "points");
  if (!arrays.regions.empty())
    check_lengths("regions", arrays.regions.size(), "tetrahedra", arrays.tetrahedra.size() / 4);
  check_indices("regions", arrays.regions, 1, arrays.region_names.size(), "names of regions");
  check_lengths("walls", arrays.walls.size(), "triangles", arrays.triangles.size() / 3);
  check_indices("walls", arrays.walls, 1, arrays.wall_names.size(), "names of walls");
}

template <std::size_t Size>
std::vector<std::array<int, Size>> grouped(std::span<const std::int32_t> numbers) {
  std::vector<std::array<int, Size>> groups(numbers.size() / Size);
  for (std::size_t i = 0; i < numbers.size(); ++i) groups[i / Size][i % Size] = numbers[i];
  return groups;
}

RawMesh raw_mesh(const MeshArrays& arrays) {
  check(arrays);
  RawMesh raw;
  for (std::size_t i = 0; i < arrays.points.size(); i += 3)
    raw.points.emplace_back(arrays.points[i], arrays.points[i + 1], arrays.points[i + 2]);
  raw.cells = grouped<4>(arrays.tetrahedra);
  raw.cell_regions.assign(arrays.regions.begin(), arrays.regions.end());
  raw.cell_regions.resize(raw.cells.size(), 0);
  raw.triangles = grouped<3>(arrays.triangles);
  raw.triangle_walls.assign(arrays.walls.begin(), arrays.walls.end());
  raw.region_names = arrays.region_names;
  raw.wall_names = arrays.wall_names;
  return raw;
}

}  // namespace

Mesh Mesh::from_arrays(const MeshArrays& arrays) {
  return translated([&] {
    return Mesh(std::make_shared<const Impl>(
        Impl{std::make_shared<const TetrahedralMesh>(raw_mesh(arrays)), source_of_arrays}));
  });
}

Mesh Mesh::from_file(const std::filesystem::path& file, double scale) {
  return translated([&] {
    if (!(scale > 0) || !std::isfinite(scale))
      refuse(fmt::format("scale = {}: no scale; use a number above 0", scale));
    // A JSON string is a TOML string too.
    const std::string path = nlohmann::json(std::filesystem::absolute(file).string()).dump();
    return Mesh(
        std::make_shared<const Impl>(Impl{std::make_shared<const TetrahedralMesh>(read_mesh(file, scale)),
                                          fmt::format("{{ file = {}, scale = {} }}", path, scale)}));
  });
}

Mesh::Mesh(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
Mesh::~Mesh() = default;
Mesh::Mesh(const Mesh&) = default;
Mesh::Mesh(Mesh&&) noexcept = default;
Mesh& Mesh::operator=(const Mesh&) = default;
Mesh& Mesh::operator=(Mesh&&) noexcept = default;

int Mesh::point_count() const { return impl_->mesh->vertex_count(); }
int Mesh::cell_count() const { return impl_->mesh->cell_count(); }
int Mesh::boundary_face_count() const { return impl_->mesh->boundary_face_count(); }

std::span<const double> Mesh::points() const {
  const std::span<const Vec3> points = impl_->mesh->points();
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return {points.empty() ? nullptr : points.front().data(), 3 * points.size()};
}

std::span<const std::int32_t> Mesh::cells() const {
  const auto cells = impl_->mesh->cell_vertices();
  return {cells.front().data(), 4 * cells.size()};
}

std::span<const std::int32_t> Mesh::cell_regions() const { return impl_->mesh->cell_regions(); }
std::span<const double> Mesh::volumes() const { return impl_->mesh->volumes(); }

std::span<const std::int32_t> Mesh::boundary_faces() const {
  const auto faces = impl_->mesh->face_vertices();
  return {faces.front().data(), 3 * static_cast<std::size_t>(impl_->mesh->boundary_face_count())};
}

std::span<const std::int32_t> Mesh::face_walls() const { return impl_->mesh->face_walls(); }
std::span<const std::int32_t> Mesh::parents() const { return impl_->mesh->parents().cells; }
const std::vector<std::string>& Mesh::region_names() const { return impl_->mesh->region_names(); }
const std::vector<std::string>& Mesh::wall_names() const { return impl_->mesh->wall_names(); }

void Mesh::write(const std::filesystem::path& file) const {
  translated([&] { write_mesh(file, *impl_->mesh); });
}

}  // namespace etendue::v0
