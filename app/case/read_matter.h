// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "app/case/case.h"
#include "app/case/section.h"

namespace etendue {

std::map<std::string, MediumCase> read_media(Section media, const Bands& bands,
                                             const std::filesystem::path& case_folder);
std::map<std::string, WallCase> read_walls(Section walls, const Bands& bands);

}  // namespace etendue
