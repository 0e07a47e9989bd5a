// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/image_files.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <png.h>

#include <stdexcept>

namespace etendue {
namespace {

/// A file in memory.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("memory") {}

  void write(const char bytes[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (at_ + size > bytes_.size()) bytes_.resize(at_ + size);
    bytes_.replace(at_, size, bytes, size);
    at_ += size;
  }
  uint64_t tellp() override { return at_; }
  void seekp(uint64_t position) override { at_ = position; }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

void append_png(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

/// libpng must not go on; it may be left by an exception, having been made by us alone.
void refuse_png(png_structp, png_const_charp message) { throw std::runtime_error(message); }

struct PngWriter {
  PngWriter()
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, refuse_png, nullptr)),
        info(png_create_info_struct(png)) {}
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  png_structp png;
  png_infop info;
};

}  // namespace

std::string exr_bytes(std::array<int, 2> pixels, const std::vector<ImageChannel>& channels,
                      const std::string& comment) {
  Imf::Header header(pixels[0], pixels[1]);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addComments(header, comment);
  Imf::FrameBuffer frame;
  const std::size_t row = sizeof(float) * static_cast<std::size_t>(pixels[0]);
  for (const ImageChannel& channel : channels) {
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    // The library takes a place to write from as one to write to.
    char* values = const_cast<char*>(reinterpret_cast<const char*>(channel.values.data()));
    frame.insert(channel.name, Imf::Slice(Imf::FLOAT, values, sizeof(float), row));
  }
  MemoryStream stream;
  {
    Imf::OutputFile file(stream, header, 1);
    file.setFrameBuffer(frame);
    file.writePixels(pixels[1]);
  }
  return stream.take();
}

std::string png_bytes(std::array<int, 2> pixels, std::span<const std::uint8_t> rgb) {
  std::string bytes;
  PngWriter writer;
  png_set_write_fn(writer.png, &bytes, append_png, nullptr);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(pixels[0]),
               static_cast<png_uint_32>(pixels[1]), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(writer.png, writer.info);
  const std::size_t row = 3 * static_cast<std::size_t>(pixels[0]);
  for (std::size_t at = 0; at < rgb.size(); at += row) png_write_row(writer.png, &rgb[at]);
  png_write_end(writer.png, nullptr);
  return bytes;
}

}  // namespace etendue
