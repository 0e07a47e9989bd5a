// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/write/publish/directory_lock.h"

namespace etendue {

/// A hidden directory in which files of a target directory are made: .TARGET.PROCESS.NUMBER.part beside the
/// target, or in it where the directory above cannot be written or is another file system. It is locked as
/// long as its process lives, and removed with this object.
class StagingFolder {
 public:
  /// The caller holds the lock of the target, in which a name is tried. Throws FileError.
  explicit StagingFolder(const std::filesystem::path& target);
  ~StagingFolder();
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Gives a file its name in the target, in place of one that has it. Throws FileError.
  void give(const std::string& name) const;
  /// Replaces files of the target as one: those named in `gone` leave it and those in `added` come from here.
  /// Whoever looks sees the old set or the new one. The target is exchanged with this directory, filled, and
  /// exchanged again, so that it stays the same directory with all else that is in it. False, and nothing has
  /// changed, where the file system cannot exchange or link, or where the target has directories in it.
  bool exchange(const std::vector<std::string>& gone, const std::vector<std::string>& added);

 private:
  bool link_kept_files(const std::vector<std::string>& gone) const;

  std::filesystem::path target_;
  std::filesystem::path path_;
  bool beside_ = false;  ///< whether the target and path_ are in one directory
  std::optional<DirectoryLock> lock_;
};

/// Removes the staging folders that killed runs have left beside a directory and in it. Those of runs that
/// live stay.
void remove_abandoned_staging(const std::filesystem::path& target);

}  // namespace etendue
