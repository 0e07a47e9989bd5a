// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>

#include <iostream>

#include "app/command/command.h"

namespace {

// A closed standard stream leaves its number to the next file that is opened, and what is meant for the
// stream would go into that file.
void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1 && open("/dev/null", O_RDWR) == -1) _exit(3);
}

}  // namespace

int main(int count, char** arguments) {
  open_standard_streams();
  return static_cast<int>(etendue::run_command({arguments + 1, arguments + count}, std::cout, std::cerr));
}
