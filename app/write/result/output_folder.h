// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/write/publish/staging_folder.h"

namespace etendue {

/// A set of files that appears whole in a directory, or not at all. Files are written into a staging folder
/// and take their names by publish(); without it they are removed.
class OutputFolder {
 public:
  /// Makes the directory with its parents. Throws FileError.
  explicit OutputFolder(std::filesystem::path directory);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// The temporary path that the file `name` is to be written to. Throws FileError.
  std::filesystem::path add(const std::string& name);
  /// Adds a file with this text. Throws FileError.
  void add_text(const std::string& name, std::string_view text);
  /// Names of the files added so far.
  const std::vector<std::string>& names() const { return names_; }

  /// Keeps other runs from publishing into the directory until publish() or the end of this object: what is
  /// read of the directory then stays true. Throws FileError where another run does so for a minute.
  void lock();
  /// Removes `outdated` files and gives those that were added their names, in one step where the file system
  /// can exchange directories. Elsewhere the outdated files go first, and the last name is given last: a
  /// reader that finds it finds the whole set. Throws FileError.
  void publish(const std::vector<std::string>& outdated);

 private:
  void make_staging_folder();
  void refuse_folders_in_the_way() const;
  /// Files of a run that was killed while it replaced them one by one.
  std::vector<std::string> half_replaced() const;
  void replace_one_by_one(const std::vector<std::string>& outdated);

  std::filesystem::path directory_;
  std::vector<std::string> names_;
  std::optional<StagingFolder> staging_;  ///< while there are files to publish
  std::optional<DirectoryLock> lock_;
};

/// Makes a directory with its parents. Throws FileError.
void make_output_directory(const std::filesystem::path& directory);

/// Throws FileError where files could not be made in this directory, with the reason. Leaves nothing behind,
/// and removes what killed runs have left.
void check_output_directory(const std::filesystem::path& directory);

}  // namespace etendue
