// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/image_files.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <gtest/gtest.h>
#include <png.h>

#include <fstream>

#include "tests/app/write/sample_run.h"

namespace etendue::image_files_test {
namespace {

TEST(ImageFiles, KeepLinearNumbersToTheLastBit) {
  const test::ScratchFolder folder;
  const std::vector<ImageChannel> channels = {{"R", {0.1F, 2e5F, -3e-7F, 4, 5, 6}},
                                              {"radiance.red", {6, 5, 4, 3, 2, 1}}};
  const std::string path = (folder.path() / "a.exr").string();
  std::ofstream(path, std::ios::binary) << exr_bytes({3, 2}, channels, "what it is");
  Imf::InputFile file(path.c_str());
  EXPECT_EQ(Imf::comments(file.header()), "what it is");
  ASSERT_EQ(file.header().dataWindow().max, Imath::V2i(2, 1));
  for (const ImageChannel& channel : channels) {
    std::vector<float> values(6);
    Imf::FrameBuffer frame;
    frame.insert(channel.name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                          3 * sizeof(float)));
    file.setFrameBuffer(frame);
    file.readPixels(0, 1);
    EXPECT_EQ(values, channel.values);
  }
}

TEST(ImageFiles, KeepBytesOfAPng) {
  const std::vector<std::uint8_t> rgb = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 255};
  const std::string bytes = png_bytes({2, 2}, rgb);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
  image.format = PNG_FORMAT_RGB;
  ASSERT_EQ(PNG_IMAGE_SIZE(image), rgb.size());
  std::vector<std::uint8_t> read(rgb.size());
  ASSERT_TRUE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr));
  EXPECT_EQ(read, rgb);
}

}  // namespace
}  // namespace etendue::image_files_test
