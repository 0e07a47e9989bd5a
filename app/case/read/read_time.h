// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

/// When sources emit that say so themselves.
std::vector<InTime> own_courses(const Case& input);

/// Reads [time], which is there, into a case that is read but for what is written.
void read_time(Section time, const std::filesystem::path& case_folder, Case& result);

}  // namespace etendue
