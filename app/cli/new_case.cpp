// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <vector>

#include "app/cli/starters.h"
#include "app/request/commands.h"
#include "base/errors.h"
#include "base/text/edit_distance.h"

namespace etendue {
namespace {

const Starter& starter_called(const std::string& name) {
  std::vector<std::string> names;
  for (const Starter& starter : starters()) {
    if (starter.name == name) return starter;
    names.emplace_back(starter.name);
  }
  throw InputError(fmt::format("command line: new: {}: no such kind{}; use {}", name, suggestion(name, names),
                               enumerate(names)));
}

std::string last_error() { return std::generic_category().message(errno); }

/// Replaces nothing, and leaves nothing half written.
void write_new_file(const std::filesystem::path& path, std::string_view text) {
  std::FILE* const file = std::fopen(path.c_str(), "wx");
  if (file == nullptr && errno == EEXIST)
    throw InputError(fmt::format("{}: is there already; name another file with -o", path.string()));
  if (file == nullptr) throw FileError(path.string(), "cannot be written: " + last_error());
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (std::fclose(file) == 0 && written) return;
  const std::string reason = last_error();
  std::remove(path.c_str());
  throw FileError(path.string(), "cannot be written: " + reason);
}

}  // namespace

ExitCode new_case(const NewRequest& request, std::ostream& out) {
  const Starter& starter = starter_called(request.kind);
  const std::filesystem::path path =
      request.output.empty() ? std::filesystem::path(request.kind + ".toml") : request.output;
  write_new_file(path, starter.text);
  out << fmt::format("written to {}\nrun it with: etendue run {}\n", path.string(), path.string());
  return ExitCode::done;
}

}  // namespace etendue
