// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "solver/observe/camera/picture.h"

namespace etendue {

/// An estimate of what a picture is off by, in every pixel and band.
struct PictureError {
  std::string of;  ///< "cells" or "directions"
  Picture picture;
};

struct NamedPicture {
  const CameraCase& camera;
  Picture picture;
  std::vector<PictureError> errors = {};
};

/// Adds NAME.exr and NAME.png of each picture to a directory, all or none, and to the list of files in its
/// summary.json where there is one. NAME.exr holds linear numbers: R, G, B as BandColor has them, and
/// `radiance.BAND` and
/// `error.cells.BAND`, `error.directions.BAND` of each band. NAME.png went through exposure and tone curve;
/// NAME.false.png is in false colors, where the camera asks for them.
/// Returns the names of the files. The summary counts the seconds that the pictures of a run took where they
/// are given; then the results must be of this process. Throws FileError.
std::vector<std::string> add_pictures(const std::filesystem::path& directory, const Case& input,
                                      const std::vector<NamedPicture>& pictures,
                                      std::optional<double> seconds = {});

}  // namespace etendue
