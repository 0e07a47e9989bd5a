// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/baked_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

#include "app/write/color.h"

namespace etendue {
namespace {

static_assert(std::endian::native == std::endian::little, "both formats are little-endian");

template <class Value>
void append(std::string& bytes, Value value) {
  std::array<char, sizeof(Value)> raw;
  std::memcpy(raw.data(), &value, sizeof(Value));
  bytes.append(raw.data(), raw.size());
}

void append(std::string& bytes, const Vec3& vector) {
  for (const double value : vector) append(bytes, static_cast<float>(value));
}

/// A chunk of a .glb file: its length, type and bytes, filled up to whole words.
std::string chunk(const std::string& type, std::string bytes, char filler) {
  bytes.resize((bytes.size() + 3) / 4 * 4, filler);
  std::string result;
  append(result, static_cast<std::uint32_t>(bytes.size()));
  return result + type + bytes;
}

nlohmann::json vector_of(const Vec3& vector) {
  // As they stand in the file: limits must hold its rounded numbers.
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()), static_cast<float>(vector.z())};
}

constexpr int float_type = 5126, unsigned_type = 5125;       // component types of glTF
constexpr int array_buffer = 34962, element_buffer = 34963;  // targets of glTF

}  // namespace

std::string ply_bytes(const BakedSurface& baked) {
  const WallSurface& surface = baked.surface;
  std::string bytes = fmt::format("ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\n",
                                  baked.comment, surface.vertices.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    bytes += fmt::format("property float {}\n", name);
  for (const char* name : {"red", "green", "blue"}) bytes += fmt::format("property uchar {}\n", name);
  for (std::string name : baked.names) {
    std::ranges::replace(name, ' ', '_');
    bytes += "property float " + name + "\n";
  }
  bytes += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                       surface.triangles.size());
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    append(bytes, surface.vertices[v].position);
    append(bytes, surface.vertices[v].normal);
    for (const double value : baked.colors[v]) append(bytes, display_value(value, Exposure{1}));
    for (std::size_t i = 0; i < baked.names.size(); ++i)
      append(bytes, static_cast<float>(baked.values[v * baked.names.size() + i]));
  }
  for (const std::array<std::int32_t, 3>& triangle : surface.triangles) {
    append(bytes, std::uint8_t{3});
    for (const std::int32_t vertex : triangle) append(bytes, vertex);
  }
  return bytes;
}

std::string glb_bytes(const BakedSurface& baked) {
  const WallSurface& surface = baked.surface;
  const std::size_t vertices = surface.vertices.size(), indices = 3 * surface.triangles.size();
  std::string buffer;
  Vec3 low = surface.vertices.front().position, high = low;
  for (const WallSurface::Vertex& vertex : surface.vertices) {
    append(buffer, vertex.position);
    low = low.cwiseMin(vertex.position);
    high = high.cwiseMax(vertex.position);
  }
  for (const WallSurface::Vertex& vertex : surface.vertices) append(buffer, vertex.normal);
  for (const LinearColor& color : baked.colors)
    for (const double value : color) append(buffer, static_cast<float>(std::clamp(value, 0., 1.)));
  for (const std::array<std::int32_t, 3>& triangle : surface.triangles)
    for (const std::int32_t vertex : triangle) append(buffer, static_cast<std::uint32_t>(vertex));

  const std::size_t part = 12 * vertices;  // bytes of three floats for each vertex
  const auto view = [](std::size_t offset, std::size_t length, int target) {
    return nlohmann::json{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}, {"target", target}};
  };
  const auto three_floats = [&](int buffer_view) {
    return nlohmann::json{
        {"bufferView", buffer_view}, {"componentType", float_type}, {"count", vertices}, {"type", "VEC3"}};
  };
  nlohmann::json positions = three_floats(0);
  positions["min"] = vector_of(low);
  positions["max"] = vector_of(high);
  const nlohmann::json document = {
      {"asset", {{"version", "2.0"}, {"generator", "etendue"}, {"copyright", baked.comment}}},
      {"extensionsUsed", {"KHR_materials_unlit"}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0}}}}},
      // glTF has y up: a quarter turn about x.
      {"nodes", {{{"mesh", 0}, {"name", "walls"}, {"rotation", {-0.70710678, 0, 0, 0.70710678}}}}},
      {"meshes",
       {{{"primitives",
          {{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"COLOR_0", 2}}},
            {"indices", 3},
            {"material", 0}}}}}}},
      {"materials",
       {{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 1}}, {"metallicFactor", 0}}},
         {"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}}}}},
      {"accessors",
       {positions,
        three_floats(1),
        three_floats(2),
        {{"bufferView", 3}, {"componentType", unsigned_type}, {"count", indices}, {"type", "SCALAR"}}}},
      {"bufferViews",
       {view(0, part, array_buffer), view(part, part, array_buffer), view(2 * part, part, array_buffer),
        view(3 * part, 4 * indices, element_buffer)}},
      {"buffers", {{{"byteLength", buffer.size()}}}}};
  const std::string chunks =
      chunk("JSON", document.dump(), ' ') + chunk(std::string("BIN\0", 4), buffer, '\0');
  std::string bytes = "glTF";
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(12 + chunks.size()));
  return bytes + chunks;
}

}  // namespace etendue
