// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <memory>
#include <system_error>

#include "base/errors.h"

namespace etendue {
namespace {

constexpr int kUnexpectedException = 255;

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

/// For a reason of errno.
[[noreturn]] void refuse(const char* problem, const char* remedy) {
  throw FileError("child process", std::string(problem) + " (" + std::strerror(errno) + "); " + remedy);
}

/// A pipe; its ends are closed with this object.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) refuse("cannot get a pipe", "allow more open files (ulimit -n)");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reading() const { return ends_[0]; }
  int writing() const { return ends_[1]; }
  void close_reading() { close_end(0); }
  void close_writing() { close_end(1); }

 private:
  void close_end(std::size_t end) {
    if (ends_[end] >= 0) close(ends_[end]);
    ends_[end] = -1;
  }

  std::array<int, 2> ends_ = {-1, -1};
};

/// Beyond this memory an allocation shall fail at once, and not the machine swap for hours.
void limit_memory(std::size_t memory) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0) return;
  std::size_t pages = 0;  // what this process has mapped already
  if (const File status{std::fopen("/proc/self/statm", "r")}; status)
    if (std::fscanf(status.get(), "%zu", &pages) != 1) pages = 0;
  const rlim_t most = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + memory;
  limit.rlim_cur = std::min(limit.rlim_max, most);
  setrlimit(RLIMIT_AS, &limit);
}

[[noreturn]] void be_the_child(const std::function<int(std::FILE*)>& work, int output, int result_pipe) {
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  std::setvbuf(stdout, nullptr, _IONBF, 0);  // lines must come as they are, and survive an abort
  const File result(fdopen(result_pipe, "wb"));
  int code = kUnexpectedException;
  try {
    if (result) code = work(result.get());
  } catch (const std::exception& error) {
    std::fprintf(stdout, "%s\n", error.what());
  }
  if (result && std::fflush(result.get()) != 0) code = kUnexpectedException;
  std::fflush(stdout);
  _exit(code);
}

/// A child must not outlive an interrupted parent, nor handle interrupts as it does, nor leave a core
/// file behind for a fault that is reported anyway.
void restrict_child(std::size_t memory) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  limit_memory(memory);
}

/// Waits for the child, which is killed first if its end is not wanted any more.
class Child {
 public:
  explicit Child(pid_t process) : process_(process) {}
  ~Child() {
    if (process_ == 0) return;
    kill(process_, SIGKILL);
    wait_for_end();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The status as of waitpid().
  int wait_for_end() {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    return status;
  }

 private:
  pid_t process_;
};

/// Appends what there is to read. False at the end of the pipe.
bool read_some(int input, std::string& bytes) {
  std::array<char, 1 << 16> buffer{};
  const ssize_t count = read(input, buffer.data(), buffer.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  bytes.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0;
}

/// Gives the whole lines away.
void give_lines(std::string& pending, const std::function<void(std::string_view)>& on_line) {
  std::size_t start = 0;
  for (std::size_t end; (end = pending.find('\n', start)) != std::string::npos; start = end + 1)
    if (on_line) on_line(std::string_view(pending).substr(start, end - start));
  pending.erase(0, start);
}

/// Reads lines and result until the child has closed both. Returns the result.
std::string read_child(int output, int result_pipe, const std::function<void(std::string_view)>& on_line) {
  std::string pending, result;
  std::array<pollfd, 2> inputs = {pollfd{output, POLLIN, 0}, pollfd{result_pipe, POLLIN, 0}};
  while (inputs[0].fd >= 0 || inputs[1].fd >= 0) {
    if (poll(inputs.data(), inputs.size(), -1) < 0 && errno != EINTR) break;
    for (pollfd& input : inputs) {
      if (input.fd < 0 || input.revents == 0) continue;
      if (!read_some(input.fd, input.fd == output ? pending : result)) input.fd = -1;
      input.revents = 0;
    }
    give_lines(pending, on_line);
  }
  if (!pending.empty() && on_line) on_line(pending);
  return result;
}

}  // namespace

std::size_t physical_memory() {
  return static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::size_t memory_to_read(const std::filesystem::path& file) {
  // Zlib compresses 1,032 times at most, and bytes may become doubles.
  constexpr std::size_t least = std::size_t{1} << 30, times_its_size = 8 * 1032;
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  const std::size_t most = physical_memory();
  // These name a case of many files.
  if (file.extension() == ".foam" || file.filename() == "controlDict") return most;
  if (unknown || size > most / times_its_size) return most;
  return std::min(most, least + times_its_size * static_cast<std::size_t>(size));
}

void limit_processor_seconds(double seconds) {
  rlimit limit{};
  if (getrlimit(RLIMIT_CPU, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(std::ceil(std::max(1.0, seconds))));
  setrlimit(RLIMIT_CPU, &limit);
}

ChildOutcome run_in_child(const std::function<int(std::FILE* result)>& work,
                          const std::function<void(std::string_view)>& on_line, std::size_t memory) {
  Pipe output, result;
  std::fflush(nullptr);  // or the child would print again what waits in the buffers
  const pid_t process = fork();
  if (process < 0) refuse("cannot be started", "allow more processes (ulimit -u) or memory");
  if (process == 0) {
    output.close_reading();
    result.close_reading();
    restrict_child(std::min(memory, physical_memory()));
    be_the_child(work, output.writing(), result.writing());
  }
  Child child(process);
  output.close_writing();
  result.close_writing();
  std::string bytes = read_child(output.reading(), result.reading(), on_line);
  const int status = child.wait_for_end();
  if (WIFSIGNALED(status)) return {0, WTERMSIG(status), {}};
  return {WEXITSTATUS(status), 0, std::move(bytes)};
}

}  // namespace etendue
