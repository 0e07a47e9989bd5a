// SPDX-License-Identifier: AGPL-3.0-or-later
#include <iostream>

#include "app/command/command.h"

int main(int count, char** arguments) {
  return static_cast<int>(etendue::run_command({arguments + 1, arguments + count}, std::cout, std::cerr));
}
