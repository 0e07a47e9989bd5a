// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/command.h"

#include <etendue/command.h>

#include "app/write/result/program_version.h"

namespace etendue::v0 {

int run_command(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
  return static_cast<int>(etendue::run_command(arguments, out, err));
}

std::string version() { return program_version(); }

}  // namespace etendue::v0
