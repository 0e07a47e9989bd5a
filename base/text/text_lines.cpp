// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/text/text_lines.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include "base/errors.h"
#include "base/text/trimmed.h"

namespace etendue {
namespace {

constexpr std::size_t kLongestShown = 40;

std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word.front() == '+' ? word.substr(1) : word;
}

}  // namespace

std::string shown_word(std::string_view word) {
  std::string text;
  for (const char letter : word.substr(0, kLongestShown))
    text += letter >= ' ' && letter <= '~' ? letter : '?';
  return word.size() > kLongestShown ? text + "..." : text;
}

std::string read_bytes(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw FileError(path.string(), "is a directory; name a file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path.string(), std::string("cannot be opened (") + std::strerror(errno) + ")");
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad())
    throw FileError(path.string(), std::string("cannot be read (") + std::strerror(errno) + ")");
  return bytes;
}

TextLines::TextLines(const std::filesystem::path& path, char comment)
    : file_(path.string()), text_(read_bytes(path)), comment_(comment) {
  if (trimmed(text_).empty()) throw InputError(Fault{file_, 0, "the file is empty"});
  if (text_.find('\0') != std::string::npos)
    throw InputError(Fault{file_, 0, "is a binary file; save the mesh as text (ASCII)"});
}

bool TextLines::next() {
  while (next_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', next_), text_.size());
    std::string_view line = std::string_view(text_).substr(next_, end - next_);
    next_ = end + 1;
    ++line_;
    if (comment_ != '\0') line = line.substr(0, line.find(comment_));
    rest_ = trimmed(line);
    if (!rest_.empty()) return true;
  }
  rest_ = {};
  return false;
}

void TextLines::next(std::string_view expected) {
  if (!next()) fail("the file ends where " + std::string(expected) + " should follow (is it cut short?)");
}

std::string_view TextLines::word() {
  const auto end = std::min(rest_.find_first_of(blanks), rest_.size());
  const std::string_view found = rest_.substr(0, end);
  rest_ = trimmed(rest_.substr(end));
  return found;
}

std::string_view TextLines::needed_word(std::string_view what, std::string_view kind) {
  const std::string_view found = word();
  if (found.empty()) fail(std::string(what) + " is missing; give " + std::string(kind));
  return found;
}

std::int64_t TextLines::integer(std::string_view what, std::int64_t least, std::int64_t most) {
  const std::string_view text = needed_word(what, "an integer");
  const std::string_view digits = without_plus(text);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) fail(what, text, "is too large an integer");
  if (error != std::errc() || end != digits.data() + digits.size()) fail(what, text, "is not an integer");
  if (value < least || value > most)
    fail(what, text,
         most == std::numeric_limits<std::int64_t>::max()
             ? "is too small; use " + std::to_string(least) + " or more"
             : "is out of range; use " + std::to_string(least) + " to " + std::to_string(most));
  return value;
}

std::int64_t TextLines::integer(std::string_view what) {
  return integer(what, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
}

double TextLines::number(std::string_view what) {
  const std::string_view text = needed_word(what, "a number");
  const std::string_view digits = without_plus(text);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  // from_chars leaves the value alone where it is too large or too small; strtod tells the two apart.
  if (error == std::errc::result_out_of_range)
    value = std::strtod(std::string(digits).c_str(), nullptr);
  else if (error != std::errc() || end != digits.data() + digits.size())
    fail(what, text, "is not a number");
  if (!std::isfinite(value)) fail(what, text, "is not a finite number");
  return value;
}

Vec3 TextLines::point() {
  const double x = number("x");
  const double y = number("y");
  const double z = number("z");
  return {x, y, z};
}

std::size_t TextLines::count(std::string_view what) {
  const std::string_view before = rest_;
  const auto value = static_cast<std::size_t>(integer(what, 0, std::numeric_limits<std::int64_t>::max()));
  if (value > text_.size() / 2) {
    rest_ = before;
    fail(what, word(), "is more than the file holds (is it cut short?)");
  }
  return value;
}

void TextLines::fail(const std::string& problem) const { throw InputError(Fault{file_, line_, problem}); }

void TextLines::fail(std::string_view what, std::string_view value, const std::string& problem) const {
  fail(std::string(what) + " = " + shown_word(value) + ": " + problem);
}

}  // namespace etendue
