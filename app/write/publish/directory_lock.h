// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace etendue {

/// A lock of a directory among processes (flock). It ends with this object, and with the process.
class DirectoryLock {
 public:
  /// Waits until no other process holds the lock. A file system without locks gives one that excludes nobody.
  /// Throws FileError where the directory cannot be opened, or is held for longer than a minute.
  static DirectoryLock wait_for(const std::filesystem::path& directory);
  /// The lock, if it is free and the file system has locks.
  static std::optional<DirectoryLock> try_take(const std::filesystem::path& directory);
  /// Whether another process holds the lock.
  static bool is_held(const std::filesystem::path& directory);

  DirectoryLock(DirectoryLock&& other) noexcept;
  DirectoryLock& operator=(DirectoryLock&& other) noexcept;
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;
  ~DirectoryLock();

 private:
  explicit DirectoryLock(int file) : file_(file) {}

  int file_;  ///< descriptor of the directory; -1: none
};

}  // namespace etendue
