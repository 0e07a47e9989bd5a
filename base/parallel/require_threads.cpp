// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/parallel/require_threads.h"

#include <latch>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "base/errors.h"

namespace etendue {

void require_threads(int count) {
  std::latch all_are_there(1);
  std::vector<std::jthread> threads;
  try {
    while (static_cast<int>(threads.size()) + 1 < count) threads.emplace_back([&] { all_are_there.wait(); });
  } catch (const std::system_error& error) {
    const std::string started = std::to_string(threads.size() + 1);
    all_are_there.count_down();
    throw FileError(std::to_string(count) + " threads",
                    "the system starts only " + started + " (" + error.code().message() +
                        "); use fewer (solve.threads or --threads), or allow more processes (ulimit -u) or "
                        "memory");
  }
  all_are_there.count_down();
}

}  // namespace etendue
