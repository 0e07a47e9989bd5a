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

/// Names of the files that are being replaced one by one, in their directory.
constexpr const char* replacement_list = ".replaced-files";

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

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
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

fs::path OutputFolder::add(const std::string& name) {
  if (!staging_) make_staging_folder();
  names_.push_back(name);
  return staging_->path() / name;
}

/// It tries names in the directory, which must not be exchanged meanwhile.
void OutputFolder::make_staging_folder() {
  const auto lock = lock_ ? std::nullopt : std::optional(DirectoryLock::wait_for(directory_));
  staging_.emplace(directory_);
}

void OutputFolder::add_text(const std::string& name, std::string_view text) {
  write_text(add(name), directory_ / name, text);
}

void OutputFolder::refuse_folders_in_the_way() const {
  for (const std::string& name : names_)
    if (fs::is_directory(directory_ / name))
      throw FileError((directory_ / name).string(), "cannot be replaced (it is a directory)");
}

void OutputFolder::lock() {
  if (!lock_) lock_ = DirectoryLock::wait_for(directory_);
}

std::vector<std::string> OutputFolder::half_replaced() const {
  std::vector<std::string> names;
  std::ifstream list(directory_ / replacement_list);
  for (std::string name; std::getline(list, name);)
    if (name.find('/') == std::string::npos && name != "." && name != "..") names.push_back(name);
  return names;
}

/// The last file vouches for the others: the earlier one goes first. A list tells the next run what belongs
/// to this one if it is killed meanwhile.
void OutputFolder::replace_one_by_one(const std::vector<std::string>& outdated) {
  std::string list;
  for (const std::string& name : outdated) list += name + "\n";
  for (const std::string& name : names_) list += name + "\n";
  write_text(staging_->path() / replacement_list, directory_, list);
  staging_->give(replacement_list);
  if (contains(outdated, names_.back())) remove_file(directory_ / names_.back());
  for (const std::string& name : outdated) remove_file(directory_ / name);
  for (const std::string& name : names_) staging_->give(name);
  remove_file(directory_ / replacement_list);
}

void OutputFolder::publish(const std::vector<std::string>& outdated) {
  if (names_.empty()) return;
  refuse_folders_in_the_way();
  lock();
  std::vector<std::string> replaced = half_replaced();
  const bool was_killed = !replaced.empty();
  replaced.insert(replaced.end(), outdated.begin(), outdated.end());
  std::erase_if(replaced,
                [&](const std::string& name) { return !fs::exists(fs::symlink_status(directory_ / name)); });
  std::vector<std::string> gone = names_;
  for (const std::string& name : replaced)
    if (!contains(gone, name)) gone.push_back(name);
  if (was_killed) gone.emplace_back(replacement_list);
  if (gone.size() == 1) {
    staging_->give(names_.front());
  } else if (!staging_->exchange(gone, names_)) {
    replace_one_by_one(replaced);
  }
  names_.clear();
  staging_.reset();
  lock_.reset();
}

void make_output_directory(const fs::path& directory) { make_directories(directory); }

void check_output_directory(const fs::path& directory) {
  remove_abandoned_staging(directory);
  const std::vector<fs::path> made = make_directories(directory);
  const fs::path trial = directory / (".trial." + std::to_string(getpid()) + ".part");
  std::error_code ignored;
  const auto clean_up = [&] {
    fs::remove(trial, ignored);
    for (auto path = made.rbegin(); path != made.rend(); ++path) fs::remove(*path, ignored);
  };
  try {
    const DirectoryLock lock = DirectoryLock::wait_for(directory);
    write_text(trial, directory, "trial");
    remove_file(trial);
  } catch (...) {
    clean_up();
    throw;
  }
  clean_up();
}

}  // namespace etendue
