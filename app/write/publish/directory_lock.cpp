// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/publish/directory_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include "base/errors.h"

namespace etendue {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds pause_between_trials(2);
constexpr std::chrono::seconds longest_wait(60);

int open_directory(const fs::path& directory) {
  return open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

/// Whether the path still names the directory that was opened: another process may have exchanged it.
bool is_at(int file, const fs::path& directory) {
  struct stat opened {
  }, named{};
  return fstat(file, &opened) == 0 && stat(directory.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

}  // namespace

DirectoryLock DirectoryLock::wait_for(const fs::path& directory) {
  const auto end = std::chrono::steady_clock::now() + longest_wait;
  do {
    DirectoryLock lock(open_directory(directory));
    if (lock.file_ < 0)
      throw FileError(directory.string(),
                      "cannot be opened (" + std::generic_category().message(errno) + ")");
    const bool taken = flock(lock.file_, LOCK_EX | LOCK_NB) == 0;
    if ((taken || errno != EWOULDBLOCK) && is_at(lock.file_, directory)) return lock;
    std::this_thread::sleep_for(pause_between_trials);
  } while (std::chrono::steady_clock::now() < end);
  throw FileError(directory.string(),
                  "another run writes its results there for longer than a minute; end it, or name another "
                  "directory with output.directory or --output");
}

std::optional<DirectoryLock> DirectoryLock::try_take(const fs::path& directory) {
  DirectoryLock lock(open_directory(directory));
  if (lock.file_ < 0 || flock(lock.file_, LOCK_EX | LOCK_NB) != 0 || !is_at(lock.file_, directory)) return {};
  return lock;
}

bool DirectoryLock::is_held(const fs::path& directory) {
  const DirectoryLock lock(open_directory(directory));
  return lock.file_ >= 0 && flock(lock.file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

DirectoryLock::DirectoryLock(DirectoryLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

DirectoryLock& DirectoryLock::operator=(DirectoryLock&& other) noexcept {
  std::swap(file_, other.file_);
  return *this;
}

DirectoryLock::~DirectoryLock() {
  if (file_ >= 0) close(file_);
}

}  // namespace etendue
