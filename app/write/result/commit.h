// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace etendue {

/// Git commit that the program was built from, with "-modified" where files differed from it; "unknown" where
/// the sources were no checkout.
std::string program_commit();

}  // namespace etendue
