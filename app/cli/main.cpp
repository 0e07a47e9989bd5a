// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string_view>
#include <system_error>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "app/cli/command.h"
#include "app/ranks/rank_session.h"

namespace {

// A closed standard stream leaves its number to the next file that is opened, and what is meant for the
// stream would go into that file.
void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1 && open("/dev/null", O_RDWR) == -1) _exit(3);
}

// Threads that have nothing to do spin before they sleep, GNU's OpenMP by default for milliseconds. Where
// other processes want the cores they then take them from the threads that work: a run of 5 s takes 28. A
// thousand turns are its own choice for more threads than cores. It reads this before main()
// begins: the program starts itself again. Whoever has set something keeps it.
void let_idle_threads_sleep(int count, char** arguments) {
  if (count < 2 || std::string_view(arguments[1]) != "run") return;
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) return;
  std::error_code unknown;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (unknown || setenv("GOMP_SPINCOUNT", "1000", 0) != 0) return;
  execv(self.c_str(), arguments);  // where it fails the threads spin, and all else is the same
}

// Arrays of this size are mapped each on its own and go back to the system when they are freed. Else the GNU
// C library keeps them, once one of 32 MB has been freed, in heaps with holes: where temperatures are found
// in steps the peak was by a quarter higher. Whoever has set something keeps it.
void return_large_arrays() {
#ifdef __GLIBC__
  if (std::getenv("MALLOC_MMAP_THRESHOLD_") != nullptr || std::getenv("GLIBC_TUNABLES") != nullptr) return;
  constexpr int large = 2 << 20;
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, 2 * large);  // as it would have followed
#endif
}

// A write beyond the largest size of a file fails like one to a full disk, with a message.
void report_large_files() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace

int main(int count, char** arguments) {
  open_standard_streams();
  report_large_files();
  let_idle_threads_sleep(count, arguments);
  return_large_arrays();
  etendue::RankSession session;
  return static_cast<int>(session.run([&](etendue::RankGroup* ranks, std::ostream& out, std::ostream& err) {
    return etendue::run_command({arguments + 1, arguments + count}, out, err, ranks);
  }));
}
