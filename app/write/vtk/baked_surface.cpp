// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/baked_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/write/image/color.h"
#include "app/write/image/image_files.h"

namespace etendue {
namespace {

static_assert(std::endian::native == std::endian::little, "both formats are little-endian");

template <class Value>
void append_bytes(std::string& bytes, Value value) {
  std::array<char, sizeof(Value)> raw;
  std::memcpy(raw.data(), &value, sizeof(Value));
  bytes.append(raw.data(), raw.size());
}

void append_bytes(std::string& bytes, const Vec3& vector) {
  for (const double value : vector) append_bytes(bytes, static_cast<float>(value));
}

/// A chunk of a .glb file: its length, type and bytes, filled up to whole words.
std::string chunk(const std::string& type, std::string bytes, char filler) {
  bytes.resize((bytes.size() + 3) / 4 * 4, filler);
  std::string result;
  append_bytes(result, static_cast<std::uint32_t>(bytes.size()));
  return result + type + bytes;
}

nlohmann::json vector_of(const Vec3& vector) {
  // As they are in the file: limits must hold its rounded numbers.
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()), static_cast<float>(vector.z())};
}

constexpr int float_type = 5126, unsigned_type = 5125;       // component types of glTF
constexpr int array_buffer = 34962, element_buffer = 34963;  // targets of glTF

constexpr int clamp_to_edge = 33071, linear_filter = 9729;  // texture samplers of glTF

/// A surface becoming a glTF file: positions, normals and indices are there, more is added.
class GlbWriter {
 public:
  explicit GlbWriter(const WallSurface& surface) : vertices_(surface.vertices.size()) {
    std::string positions, normals, indices;
    Vec3 low = surface.vertices.front().position, high = low;
    for (const WallSurface::Vertex& vertex : surface.vertices) {
      append_bytes(positions, vertex.position);
      append_bytes(normals, vertex.normal);
      low = low.cwiseMin(vertex.position);
      high = high.cwiseMax(vertex.position);
    }
    for (const std::array<std::int32_t, 3>& triangle : surface.triangles)
      for (const std::int32_t vertex : triangle) append_bytes(indices, static_cast<std::uint32_t>(vertex));
    add_attribute("POSITION", positions, "VEC3");
    accessors_[0]["min"] = vector_of(low);
    accessors_[0]["max"] = vector_of(high);
    add_attribute("NORMAL", normals, "VEC3");
    accessors_.push_back({{"bufferView", add_view(indices, element_buffer)},
                          {"componentType", unsigned_type},
                          {"count", 3 * surface.triangles.size()},
                          {"type", "SCALAR"}});
    indices_ = accessors_.size() - 1;
  }

  /// Floats for each vertex.
  void add_attribute(const std::string& name, const std::string& bytes, const std::string& type) {
    accessors_.push_back({{"bufferView", add_view(bytes, array_buffer)},
                          {"componentType", float_type},
                          {"count", vertices_},
                          {"type", type}});
    attributes_[name] = accessors_.size() - 1;
  }

  /// What the surface is coloured by, in place of vertex colours.
  void add_texture(const std::string& png) {
    document_["images"] = {{{"bufferView", add_view(png, 0)}, {"mimeType", "image/png"}}};
    document_["samplers"] = {{{"magFilter", linear_filter},
                              {"minFilter", linear_filter},
                              {"wrapS", clamp_to_edge},
                              {"wrapT", clamp_to_edge}}};
    document_["textures"] = {{{"sampler", 0}, {"source", 0}}};
    surface_["baseColorTexture"] = {{"index", 0}};
  }

  std::string bytes(const std::string& comment) && {
    document_["asset"] = {{"version", "2.0"}, {"generator", "etendue"}, {"copyright", comment}};
    document_["extensionsUsed"] = {"KHR_materials_unlit"};
    document_["scene"] = 0;
    document_["scenes"] = {{{"nodes", {0}}}};
    // glTF has y up: a quarter turn about x.
    document_["nodes"] = {{{"mesh", 0}, {"name", "walls"}, {"rotation", {-0.70710678, 0, 0, 0.70710678}}}};
    document_["meshes"] = {
        {{"primitives", {{{"attributes", attributes_}, {"indices", indices_}, {"material", 0}}}}}};
    surface_["baseColorFactor"] = {1, 1, 1, 1};
    surface_["metallicFactor"] = 0;
    document_["materials"] = {{{"pbrMetallicRoughness", surface_},
                               {"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}}}};
    document_["accessors"] = accessors_;
    document_["bufferViews"] = views_;
    document_["buffers"] = {{{"byteLength", buffer_.size()}}};
    const std::string chunks =
        chunk("JSON", document_.dump(), ' ') + chunk(std::string("BIN\0", 4), buffer_, '\0');
    std::string bytes = "glTF";
    append_bytes(bytes, std::uint32_t{2});
    append_bytes(bytes, static_cast<std::uint32_t>(12 + chunks.size()));
    return bytes + chunks;
  }

 private:
  /// The number of a part of the buffer, which begins at a whole word; 0 is no target.
  std::size_t add_view(const std::string& bytes, int target) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4, '\0');
    nlohmann::json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
    if (target != 0) view["target"] = target;
    buffer_ += bytes;
    views_.push_back(view);
    return views_.size() - 1;
  }

  std::size_t vertices_;
  std::size_t indices_ = 0;
  std::string buffer_;
  nlohmann::json accessors_ = nlohmann::json::array(), views_ = nlohmann::json::array();
  nlohmann::json attributes_, surface_, document_;
};

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
    append_bytes(bytes, surface.vertices[v].position);
    append_bytes(bytes, surface.vertices[v].normal);
    for (const double value : baked.colors[v]) append_bytes(bytes, display_value(value, Exposure{1}));
    for (std::size_t i = 0; i < baked.names.size(); ++i)
      append_bytes(bytes, static_cast<float>(baked.values[v * baked.names.size() + i]));
  }
  for (const std::array<std::int32_t, 3>& triangle : surface.triangles) {
    append_bytes(bytes, std::uint8_t{3});
    for (const std::int32_t vertex : triangle) append_bytes(bytes, vertex);
  }
  return bytes;
}

std::string glb_bytes(const BakedSurface& baked) {
  GlbWriter glb(baked.surface);
  std::string colors;
  for (const LinearColor& color : baked.colors)
    for (const double value : color) append_bytes(colors, static_cast<float>(std::clamp(value, 0., 1.)));
  glb.add_attribute("COLOR_0", colors, "VEC3");
  return std::move(glb).bytes(baked.comment);
}

std::string textured_glb_bytes(const BakedTexture& baked) {
  GlbWriter glb(baked.surface);
  std::string coordinates;
  for (const std::array<double, 2>& place : baked.atlas.coordinates)
    for (const double value : place) append_bytes(coordinates, static_cast<float>(value));
  glb.add_attribute("TEXCOORD_0", coordinates, "VEC2");
  glb.add_texture(texture_png(baked));
  return std::move(glb).bytes(baked.comment);
}

std::string texture_png(const BakedTexture& baked) {
  const auto side = static_cast<std::size_t>(baked.atlas.side);
  std::vector<std::uint8_t> rgb(3 * side * side, 0);
  for (std::size_t i = 0; i < baked.atlas.texels.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      rgb[3 * baked.atlas.texels[i] + k] = display_value(baked.colors[i][k], Exposure{1});
  return png_bytes({baked.atlas.side, baked.atlas.side}, rgb);
}

std::string texture_exr(const BakedTexture& baked) {
  const auto side = static_cast<std::size_t>(baked.atlas.side);
  std::vector<ImageChannel> channels;
  for (std::size_t n = 0; n < baked.names.size(); ++n) {
    channels.push_back(
        {baked.names[n], std::vector<float>(side * side, std::numeric_limits<float>::quiet_NaN())});
    for (std::size_t i = 0; i < baked.atlas.texels.size(); ++i)
      channels.back().values[baked.atlas.texels[i]] =
          static_cast<float>(baked.values[i * baked.names.size() + n]);
  }
  return exr_bytes({baked.atlas.side, baked.atlas.side}, channels, baked.comment);
}

}  // namespace etendue
