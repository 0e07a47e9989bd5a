// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace etendue {

/// A set of files that appears whole in a directory, or not at all. Files are written to temporary names
/// beside their final ones and renamed by publish(); without it they are removed.
class OutputFolder {
 public:
  /// Makes the directory with its parents. Throws FileError.
  explicit OutputFolder(std::filesystem::path directory);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// The temporary path that the file `name` is to be written to.
  std::filesystem::path add(const std::string& name);
  /// Adds a file with this text. Throws FileError.
  void add_text(const std::string& name, std::string_view text);
  /// Names of the files added so far.
  const std::vector<std::string>& names() const { return names_; }

  /// Removes `outdated` files that were not added and gives all others their names, the last one last: a
  /// reader that finds it finds the whole set. Throws FileError.
  void publish(const std::vector<std::string>& outdated);

 private:
  std::filesystem::path temporary(const std::string& name) const;
  void refuse_folders_in_the_way() const;

  std::filesystem::path directory_;
  std::vector<std::string> names_;
};

/// Makes a directory with its parents. Throws FileError.
void make_output_directory(const std::filesystem::path& directory);

/// Throws FileError where files could not be made in this directory, with the reason. Leaves nothing behind.
void check_output_directory(const std::filesystem::path& directory);

}  // namespace etendue
