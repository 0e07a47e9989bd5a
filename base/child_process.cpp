// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/child_process.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace etendue {
namespace {

constexpr int kUnexpectedException = 255;

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

[[noreturn]] void throw_system_error(const std::string& what) {
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

/// Beyond the machine's memory an allocation shall fail at once, and not the machine swap for hours.
void limit_memory() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0) return;
  std::size_t pages = 0;  // what this process has mapped already
  if (const File status{std::fopen("/proc/self/statm", "r")}; status)
    if (std::fscanf(status.get(), "%zu", &pages) != 1) pages = 0;
  const rlim_t most = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + physical_memory();
  limit.rlim_cur = std::min(limit.rlim_max, most);
  setrlimit(RLIMIT_AS, &limit);
}

[[noreturn]] void be_the_child(const std::function<int(std::FILE*)>& work, std::FILE* result, int output) {
  // A child must not outlive an interrupted parent, nor share its way of handling interrupts, nor leave a
  // core file behind for a fault that is reported anyway.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  limit_memory();
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  close(output);
  std::setvbuf(stdout, nullptr, _IONBF, 0);  // lines must come as they are, and survive an abort
  int code = kUnexpectedException;
  try {
    code = work(result);
  } catch (const std::exception& error) {
    std::fprintf(stdout, "%s\n", error.what());
  }
  std::fflush(result);
  std::fflush(stdout);
  _exit(code);
}

void give_lines(int input, const std::function<void(std::string_view)>& on_line) {
  std::string pending;
  std::array<char, 4096> bytes{};
  for (;;) {
    const ssize_t count = read(input, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    pending.append(bytes.data(), static_cast<std::size_t>(count));
    std::size_t start = 0;
    for (std::size_t end; (end = pending.find('\n', start)) != std::string::npos; start = end + 1)
      if (on_line) on_line(std::string_view(pending).substr(start, end - start));
    pending.erase(0, start);
  }
  if (!pending.empty() && on_line) on_line(pending);
}

std::string whole_file(std::FILE* file) {
  std::fseek(file, 0, SEEK_END);
  std::string bytes(static_cast<std::size_t>(std::ftell(file)), '\0');
  std::rewind(file);
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
  return bytes;
}

}  // namespace

std::size_t physical_memory() {
  return static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

ChildOutcome run_in_child(const std::function<int(std::FILE* result)>& work,
                          const std::function<void(std::string_view)>& on_line) {
  const File result(std::tmpfile());
  if (!result) throw_system_error("cannot make a temporary file");
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw_system_error("cannot make a pipe");
  std::fflush(nullptr);  // or the child would print again what waits in the buffers
  const pid_t child = fork();
  if (child < 0) {
    const int error = errno;
    close(ends[0]);
    close(ends[1]);
    errno = error;
    throw_system_error("cannot start a process");
  }
  if (child == 0) {
    close(ends[0]);
    be_the_child(work, result.get(), ends[1]);
  }
  close(ends[1]);
  give_lines(ends[0], on_line);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) return {0, WTERMSIG(status), {}};
  return {WEXITSTATUS(status), 0, whole_file(result.get())};
}

}  // namespace etendue
