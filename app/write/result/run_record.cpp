// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/run_record.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <string_view>

namespace etendue {
namespace {

/// Characters that mean nothing to a shell, beside letters and digits.
constexpr std::string_view plain_characters = "-_./=:,+@%";

bool is_plain(std::string_view word) {
  for (const char c : word) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!letter && !(c >= '0' && c <= '9') && plain_characters.find(c) == std::string_view::npos)
      return false;
  }
  return !word.empty();
}

std::string quoted_for_shell(const std::string& word) {
  if (is_plain(word)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

}  // namespace

std::string iso_date(std::chrono::sys_seconds time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm date{};
  gmtime_r(&seconds, &date);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", date.tm_year + 1900, date.tm_mon + 1,
                     date.tm_mday, date.tm_hour, date.tm_min, date.tm_sec);
}

std::string host_name() {
  std::array<char, 256> name{};
  // The last character stays 0: a name that is cut short need not end in one.
  return gethostname(name.data(), name.size() - 1) == 0 && name.front() != 0 ? name.data() : "unknown";
}

std::string shell_line(const std::string& program, const std::vector<std::string>& arguments) {
  std::string line = quoted_for_shell(program);
  for (const std::string& argument : arguments) line += " " + quoted_for_shell(argument);
  return line;
}

}  // namespace etendue
