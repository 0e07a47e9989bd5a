// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/output_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "base/errors.h"

namespace etendue {
namespace {

namespace fs = std::filesystem;

std::string last_reason() { return std::generic_category().message(errno == 0 ? EIO : errno); }

/// Makes the directory with its parents and says which of them were new, the innermost last.
std::vector<fs::path> make_directories(const fs::path& directory) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path path = directory; !path.empty() && !fs::exists(path, error); path = path.parent_path()) {
    if (path.has_filename()) missing.push_back(path);
    if (path == path.parent_path()) break;
  }
  std::reverse(missing.begin(), missing.end());
  fs::create_directories(directory, error);
  if (!error && !fs::is_directory(directory, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (error)
    throw FileError(directory.string(), "the output directory cannot be made (" + error.message() +
                                            "); name another with output.directory or --output");
  return missing;
}

void remove_file(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) throw FileError(path.string(), "cannot be removed (" + error.message() + ")");
}

void write_text(const fs::path& path, const fs::path& shown, std::string_view text) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream) throw FileError(shown.string(), "cannot be written (" + last_reason() + ")");
}

}  // namespace

OutputFolder::OutputFolder(fs::path directory) : directory_(std::move(directory)) {
  make_directories(directory_);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  for (const std::string& name : names_) fs::remove(temporary(name), ignored);
}

fs::path OutputFolder::temporary(const std::string& name) const {
  // With the process in the name, two runs into one directory do not write into each other's files.
  return directory_ / ("." + name + "." + std::to_string(getpid()) + ".part");
}

fs::path OutputFolder::add(const std::string& name) {
  names_.push_back(name);
  return temporary(name);
}

void OutputFolder::add_text(const std::string& name, std::string_view text) {
  write_text(add(name), directory_ / name, text);
}

void OutputFolder::refuse_folders_in_the_way() const {
  for (const std::string& name : names_)
    if (fs::is_directory(directory_ / name))
      throw FileError((directory_ / name).string(), "cannot be replaced (it is a directory)");
}

void OutputFolder::publish(const std::vector<std::string>& outdated) {
  refuse_folders_in_the_way();
  for (const std::string& name : outdated)
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) remove_file(directory_ / name);
  // The last file vouches for the others, so the earlier one goes before anything is replaced. A file that is
  // alone is replaced in one step.
  if (names_.size() > 1) remove_file(directory_ / names_.back());
  for (const std::string& name : names_) {
    std::error_code error;
    fs::rename(temporary(name), directory_ / name, error);
    if (error) throw FileError((directory_ / name).string(), "cannot be replaced (" + error.message() + ")");
  }
  names_.clear();
}

void make_output_directory(const fs::path& directory) { make_directories(directory); }

void check_output_directory(const fs::path& directory) {
  const std::vector<fs::path> made = make_directories(directory);
  const fs::path trial = directory / (".trial." + std::to_string(getpid()) + ".part");
  std::error_code ignored;
  const auto clean_up = [&] {
    fs::remove(trial, ignored);
    for (auto path = made.rbegin(); path != made.rend(); ++path) fs::remove(*path, ignored);
  };
  try {
    write_text(trial, directory, "trial");
  } catch (...) {
    clean_up();
    throw;
  }
  clean_up();
}

}  // namespace etendue
