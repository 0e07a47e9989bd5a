// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/pictures.h"

#include <fmt/format.h>

#include <limits>
#include <numeric>
#include <span>

#include "app/write/image/false_color_png.h"
#include "app/write/image/image_files.h"
#include "app/write/image/seen_luminance.h"
#include "app/write/image/toned_png.h"
#include "app/write/json/summary.h"
#include "app/write/result/output_folder.h"
#include "app/write/result/unit_labels.h"
#include "base/errors.h"
#include "solver/observe/color/photometric_units.h"

namespace etendue {
namespace {

std::vector<LinearColor> colors_of(const Picture& picture, const BandColor& rule) {
  std::vector<LinearColor> colors;
  for (std::size_t at = 0; at < picture.radiance.size(); at += picture.bands)
    colors.push_back(rule.of(std::span(picture.radiance).subspan(at, picture.bands)));
  return colors;
}

/// A channel of each band: PREFIX.BAND.
void add_bands(const std::string& prefix, const std::vector<std::string>& bands, const Picture& picture,
               std::vector<ImageChannel>& channels) {
  for (std::size_t b = 0; b < picture.bands; ++b) {
    ImageChannel& channel = channels.emplace_back(ImageChannel{prefix + "." + bands[b], {}});
    for (std::size_t at = b; at < picture.radiance.size(); at += picture.bands)
      channel.values.push_back(static_cast<float>(picture.radiance[at]));
  }
}

std::string exr_of(const Case& input, const NamedPicture& named, const BandColor& rule,
                   const std::vector<LinearColor>& colors) {
  std::vector<ImageChannel> channels;
  const std::array<std::string, 3> primaries = {"R", "G", "B"};
  for (std::size_t i = 0; i < 3; ++i) {
    ImageChannel& channel = channels.emplace_back(ImageChannel{primaries[i], {}});
    for (const LinearColor& color : colors) channel.values.push_back(static_cast<float>(color[i]));
  }
  add_bands("radiance", input.bands.names, named.picture, channels);
  for (const PictureError& error : named.errors)
    add_bands("error." + error.of, input.bands.names, error.picture, channels);
  return exr_bytes(named.picture.pixels, channels,
                   fmt::format("radiance [{}/({}^2 sr)]; R, G, B: {}", input.units.power, input.units.length,
                               rule.rule()));
}

/// Makes pixels NaN that lie outside of the circle of a fisheye.
void hide_unseen(const Camera& camera, std::vector<double>& values) {
  if (camera.projection == Projection::perspective) return;
  const CameraRays rays(camera);
  for (int row = 0; row < camera.pixels[1]; ++row)
    for (int column = 0; column < camera.pixels[0]; ++column)
      if (!rays.shows(column + 0.5, row + 0.5))
        values[static_cast<std::size_t>(row) * static_cast<std::size_t>(camera.pixels[0]) +
               static_cast<std::size_t>(column)] = std::numeric_limits<double>::quiet_NaN();
}

std::string false_colors_of(const Case& input, const NamedPicture& named) {
  const FalseColor& scale = *named.camera.false_color;
  const Picture& picture = named.picture;
  std::vector<double> values;
  const auto add_each = [&](const auto& value) {
    for (std::size_t at = 0; at < picture.radiance.size(); at += picture.bands)
      values.push_back(value(std::span(picture.radiance).subspan(at, picture.bands)));
  };
  std::string title;
  if (scale.quantity == FalseColorQuantity::luminance) {
    const SeenLuminance seen(input);
    const PhotometricUnit& unit = *find_photometric_unit(input.units.luminance);
    add_each([&](std::span<const double> radiance) { return seen.in_si(radiance) / unit.in_si; });
    title = "luminance [" + unit.symbol + "]";
  } else {
    add_each([](std::span<const double> radiance) { return std::reduce(radiance.begin(), radiance.end()); });
    title = "radiance [" + UnitLabels(input.units).radiance + "]";
  }
  hide_unseen(named.camera.camera, values);
  return false_color_png(picture.pixels, values, scale, title);
}

}  // namespace

std::vector<std::string> add_pictures(const std::filesystem::path& directory, const Case& input,
                                      const std::vector<NamedPicture>& pictures,
                                      std::optional<double> seconds) {
  const BandColor rule(input.bands);
  OutputFolder folder(directory);
  for (const NamedPicture& named : pictures) {
    const CameraCase& camera = named.camera;
    const Picture& picture = named.picture;
    const std::vector<LinearColor> colors = colors_of(picture, rule);
    folder.add_text(camera.name + ".exr", exr_of(input, named, rule, colors));
    folder.add_text(camera.name + ".png",
                    toned_png(picture.pixels, balanced(colors, WhiteBalance(input.bands, camera.white)),
                              camera.exposure, camera.tone));
    if (camera.false_color) folder.add_text(camera.name + ".false.png", false_colors_of(input, named));
  }
  const std::vector<std::string> names = folder.names();
  folder.lock();
  if (seconds && holds_other_run(directory))
    throw FileError(
        directory.string(),
        "holds the results of another run that ended meanwhile, so these pictures are not written; "
        "give each run a directory of its own with output.directory or --output");
  const std::string summary = summary_with_files(directory, names, seconds);
  if (!summary.empty()) folder.add_text("summary.json", summary);
  folder.publish({});
  return names;
}

}  // namespace etendue
