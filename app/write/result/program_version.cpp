// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/program_version.h"

namespace etendue {

std::string program_version() { return ETENDUE_VERSION; }

}  // namespace etendue
