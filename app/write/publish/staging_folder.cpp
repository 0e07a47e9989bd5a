// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/publish/staging_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <string_view>
#include <system_error>

#include "base/errors.h"

namespace etendue {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ending = ".part";
/// More staging folders of one process are not there at a time.
constexpr int most_numbers = 1000;

bool is_in(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The target without links, so that what is beside it is on its file system.
fs::path resolved(const fs::path& target) {
  std::error_code error;
  const fs::path path = fs::canonical(target, error);
  return error ? fs::absolute(target) : path;
}

/// Returns whether files that are made beside the target are like files that are made in it: on its file
/// system, and of no other group or access list.
bool is_like_beside(const fs::path& target, const fs::path& above) {
  struct stat of_target {
  }, of_above{};
  return stat(target.c_str(), &of_target) == 0 && stat(above.c_str(), &of_above) == 0 &&
         of_target.st_dev == of_above.st_dev && (of_target.st_mode & S_ISGID) == 0 &&
         getxattr(target.c_str(), "system.posix_acl_default", nullptr, 0) <= 0;
}

std::string prefix_of(const fs::path& target) { return "." + target.filename().string() + "."; }

/// The process of a name PREFIX PROCESS [.NUMBER] .part; nothing for other names.
std::optional<pid_t> process_of(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || !name.ends_with(ending)) return {};
  if (name.size() <= prefix.size() + ending.size()) return {};
  name = name.substr(prefix.size(), name.size() - prefix.size() - ending.size());
  pid_t process = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), process);
  const bool whole = end == name.data() + name.size() || *end == '.';
  return error == std::errc() && whole && process > 0 ? std::optional(process) : std::nullopt;
}

/// Files only: a staging folder has no directories in it.
void remove_with_files(const fs::path& directory) {
  std::error_code ignored;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(directory, ignored), end; entry != end; entry.increment(ignored))
    files.push_back(entry->path());
  for (const fs::path& file : files) unlink(file.c_str());
  rmdir(directory.c_str());
}

void remove_abandoned_in(const fs::path& folder, const std::string& prefix) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (process_of(entry->path().filename().string(), prefix)) found.push_back(entry->path());
  for (const fs::path& path : found)
    if (const auto lock = DirectoryLock::try_take(path)) remove_with_files(path);
}

bool has_ended(pid_t process) { return kill(process, 0) != 0 && errno == ESRCH; }

/// Single files .NAME.PROCESS.part, which trials of a directory and earlier versions leave.
void remove_abandoned_files(const fs::path& target) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(target, error), end; !error && entry != end; entry.increment(error)) {
    std::string name = entry->path().filename().string();
    if (!name.starts_with(".") || !name.ends_with(ending) || !entry->is_regular_file(error)) continue;
    const auto point = name.rfind('.', name.size() - ending.size() - 1);
    if (point == std::string::npos || point == 0) continue;
    const auto process = process_of(name, name.substr(0, point + 1));
    if (process && has_ended(*process)) found.push_back(entry->path());
  }
  for (const fs::path& path : found) unlink(path.c_str());
}

bool exchange_paths(const fs::path& a, const fs::path& b) {
  return renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

/// Returns whether a file can be renamed from one directory into another: not where that is a mount point,
/// even of the same file system.
bool can_rename_into(const fs::path& from, const fs::path& target) {
  const std::string name = fmt::format("{}{}{}", prefix_of(target), getpid(), ending);
  const int file = open((from / name).c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) return false;
  close(file);
  const bool renamed = rename((from / name).c_str(), (target / name).c_str()) == 0;
  unlink(((renamed ? target : from) / name).c_str());
  return renamed;
}

/// Moves files that have their only name here to the target, where they were meant for it while it was
/// exchanged.
void rescue_strangers(const fs::path& from, const fs::path& target) {
  std::error_code error;
  std::vector<std::string> strangers;
  for (fs::directory_iterator entry(from, error), end; !error && entry != end; entry.increment(error)) {
    struct stat file {};
    if (lstat(entry->path().c_str(), &file) == 0 && file.st_nlink == 1)
      strangers.push_back(entry->path().filename().string());
  }
  for (const std::string& name : strangers)
    renameat2(AT_FDCWD, (from / name).c_str(), AT_FDCWD, (target / name).c_str(), RENAME_NOREPLACE);
}

}  // namespace

StagingFolder::StagingFolder(const fs::path& target) : target_(resolved(target)) {
  const fs::path above = target_.parent_path();
  const bool can_be_beside = target_.has_filename() && is_like_beside(target_, above);
  int reason = EEXIST;
  for (const bool beside : {true, false}) {
    if (beside && !can_be_beside) continue;
    for (int number = 0; number < most_numbers && !lock_; ++number) {
      path_ =
          (beside ? above : target_) / fmt::format("{}{}.{}{}", prefix_of(target_), getpid(), number, ending);
      beside_ = beside;
      if (mkdir(path_.c_str(), 0700) == 0) {
        lock_ = DirectoryLock::try_take(path_);
        // Another process may hold it to remove it; then the next number is tried.
        if (!lock_ && (DirectoryLock::is_held(path_) || !fs::exists(path_))) continue;
        if (!beside || can_rename_into(path_, target_)) return;
        lock_.reset();
        rmdir(path_.c_str());
        break;
      } else if (errno != EEXIST) {
        reason = errno;
        break;
      }
    }
  }
  throw FileError(target.string(), "cannot be written (" + std::generic_category().message(reason) + ")");
}

StagingFolder::~StagingFolder() { remove_with_files(path_); }

void StagingFolder::give(const std::string& name) const {
  std::error_code error;
  fs::rename(path_ / name, target_ / name, error);
  if (error) throw FileError((target_ / name).string(), "cannot be replaced (" + error.message() + ")");
}

bool StagingFolder::link_kept_files(const std::vector<std::string>& gone) const {
  std::error_code error;
  for (fs::directory_iterator entry(target_, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (is_in(name, gone)) continue;
    if (entry->symlink_status(error).type() == fs::file_type::directory || error) return false;
    if (linkat(AT_FDCWD, entry->path().c_str(), AT_FDCWD, (path_ / name).c_str(), 0) != 0) return false;
  }
  return !error;
}

bool StagingFolder::exchange(const std::vector<std::string>& gone, const std::vector<std::string>& added) {
  struct stat mode {};
  if (!beside_ || stat(target_.c_str(), &mode) != 0 || chmod(path_.c_str(), mode.st_mode & 07777) != 0)
    return false;
  if (!link_kept_files(gone) || !exchange_paths(target_, path_)) return false;
  // The target's name is now at the new set; path_ is the directory that was there.
  for (const std::string& name : gone) unlink((path_ / name).c_str());
  for (const std::string& name : added)
    if (link((target_ / name).c_str(), (path_ / name).c_str()) != 0) {
      rescue_strangers(path_, target_);
      return true;  // the new set stays there
    }
  exchange_paths(target_, path_);
  rescue_strangers(path_, target_);
  return true;
}

void remove_abandoned_staging(const fs::path& target) {
  std::error_code error;
  if (!fs::is_directory(target.parent_path().empty() ? "." : target.parent_path(), error)) return;
  const fs::path directory = resolved(target);
  const std::string prefix = prefix_of(directory);
  remove_abandoned_in(directory.parent_path(), prefix);
  remove_abandoned_in(directory, prefix);
  remove_abandoned_files(directory);
}

}  // namespace etendue
