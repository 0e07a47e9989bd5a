// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/baked_surface.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/write/sample_run.h"

namespace etendue::baked_surface_test {
namespace {

template <class Value>
Value read(const std::string& bytes, std::size_t at) {
  Value value;
  std::memcpy(&value, bytes.data() + at, sizeof(Value));
  return value;
}

/// One triangle in the plane y = 2.
struct Sample {
  WallSurface surface{{{{0, 2, 0}, Vec3::UnitY(), {FaceIndex(0), 0}},
                       {{0, 2, 1}, Vec3::UnitY(), {FaceIndex(0), 1}},
                       {{1, 2, 0}, Vec3::UnitY(), {FaceIndex(0), 2}}},
                      {{0, 1, 2}}};
  BakedSurface baked{
      surface, {"irradiance deep"}, {1.5, 2.5, 3.5}, {{1, 0, 0}, {0.5, 0.5, 2}, {0, 0, 0}}, "light"};
};

TEST(BakedSurface, PlyHoldsNumbersAndColours) {
  const Sample sample;
  const std::string bytes = ply_bytes(sample.baked);
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment light\nelement vertex 3\nproperty float x\nproperty "
      "float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar "
      "red\nproperty uchar "
      "green\nproperty uchar blue\nproperty float irradiance_deep\nelement face 1\nproperty list uchar int "
      "vertex_indices\nend_header\n";
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  constexpr std::size_t vertex = 6 * 4 + 3 + 4;
  ASSERT_EQ(bytes.size(), header.size() + 3 * vertex + 1 + 3 * 4);
  const std::size_t second = header.size() + vertex;
  EXPECT_EQ(read<float>(bytes, second + 8), 1.0F);         // z
  EXPECT_EQ(read<std::uint8_t>(bytes, second + 24), 188);  // one half in sRGB
  EXPECT_EQ(read<std::uint8_t>(bytes, second + 26), 255);
  EXPECT_EQ(read<float>(bytes, second + 27), 2.5F);
  EXPECT_EQ(read<std::int32_t>(bytes, bytes.size() - 4), 2);
}

TEST(BakedSurface, GlbIsAFileOfWholeChunks) {
  const Sample sample;
  const std::string bytes = glb_bytes(sample.baked);
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(read<std::uint32_t>(bytes, 4), 2U);
  EXPECT_EQ(read<std::uint32_t>(bytes, 8), bytes.size());
  const auto json_length = read<std::uint32_t>(bytes, 12);
  EXPECT_EQ(json_length % 4, 0U);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  const nlohmann::json document = nlohmann::json::parse(bytes.substr(20, json_length));
  const std::size_t second = 20 + json_length;
  EXPECT_EQ(bytes.substr(second + 4, 4), std::string("BIN\0", 4));
  const auto buffer_length = read<std::uint32_t>(bytes, second);
  EXPECT_EQ(buffer_length, document["buffers"][0]["byteLength"]);
  EXPECT_EQ(second + 8 + buffer_length, bytes.size());
  const nlohmann::json& primitive = document["meshes"][0]["primitives"][0];
  const auto start_of = [&](int accessor) {
    return second + 8 +
           document["bufferViews"][document["accessors"][accessor]["bufferView"].get<std::size_t>()]
                   ["byteOffset"]
                       .get<std::size_t>();
  };
  EXPECT_EQ(document["accessors"][0]["max"], (nlohmann::json{1.0, 2.0, 1.0}));
  const std::size_t colors = start_of(primitive["attributes"]["COLOR_0"]);
  EXPECT_EQ(read<float>(bytes, colors + 12), 0.5F);
  EXPECT_EQ(read<float>(bytes, colors + 20), 1.0F) << "no more than white";
  EXPECT_EQ(read<std::uint32_t>(bytes, start_of(primitive["indices"]) + 8), 2U);
}

// All that the glTF 2.0 specification asks of the parts of such a file: aligned views within the buffer,
// counts that fit them, and references that exist; and the texture is a PNG.
TEST(BakedSurface, TexturedGlbIsConsistent) {
  const Sample sample;
  WallAtlas atlas;
  atlas.side = 16;
  atlas.texel = 0.1;
  atlas.coordinates = {{0.1, 0.2}, {0.1, 0.8}, {0.7, 0.2}};
  atlas.texels = {17, 18};
  const BakedTexture texture{sample.surface,           atlas,  {"irradiance"}, {1.5, 2.5},
                             {{1, 0.5, 0}, {0, 0, 1}}, "light"};
  const std::string bytes = textured_glb_bytes(texture);
  EXPECT_EQ(read<std::uint32_t>(bytes, 8), bytes.size());
  const auto json_length = read<std::uint32_t>(bytes, 12);
  const nlohmann::json document = nlohmann::json::parse(bytes.substr(20, json_length));
  const std::string buffer = bytes.substr(20 + json_length + 8);
  EXPECT_EQ(buffer.size() % 4, 0U);
  EXPECT_LE(document["buffers"][0]["byteLength"], buffer.size());
  const std::map<std::string, std::size_t> size_of = {{"SCALAR", 4}, {"VEC2", 8}, {"VEC3", 12}};
  for (const nlohmann::json& view : document["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
              document["buffers"][0]["byteLength"].get<std::size_t>());
  }
  for (const nlohmann::json& accessor : document["accessors"])
    EXPECT_EQ(accessor["count"].get<std::size_t>() * size_of.at(accessor["type"]),
              document["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteLength"]);
  const nlohmann::json& primitive = document["meshes"][0]["primitives"][0];
  EXPECT_EQ(document["accessors"][primitive["attributes"]["TEXCOORD_0"].get<std::size_t>()]["type"], "VEC2");
  EXPECT_FALSE(primitive["attributes"].contains("COLOR_0")) << "it would be multiplied by the texture";
  const nlohmann::json& material = document["materials"][primitive["material"].get<std::size_t>()];
  const auto number = material["pbrMetallicRoughness"]["baseColorTexture"]["index"].get<std::size_t>();
  const nlohmann::json& image = document["images"][document["textures"][number]["source"].get<std::size_t>()];
  EXPECT_EQ(image["mimeType"], "image/png");
  const nlohmann::json& view = document["bufferViews"][image["bufferView"].get<std::size_t>()];
  EXPECT_EQ(buffer.substr(view["byteOffset"], view["byteLength"]), texture_png(texture));
  EXPECT_EQ(texture_png(texture).substr(1, 3), "PNG");
  EXPECT_FALSE(texture_exr(texture).empty());
}

}  // namespace
}  // namespace etendue::baked_surface_test
