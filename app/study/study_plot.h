// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace etendue {

/// Draws study.svg from the study.json of this folder with scripts/draw, which takes Python and Matplotlib.
/// Gives why there is no picture, or nothing.
std::string draw_study(const std::filesystem::path& folder);

}  // namespace etendue
