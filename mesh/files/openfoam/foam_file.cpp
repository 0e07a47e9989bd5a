// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/openfoam/foam_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "base/errors.h"
#include "base/text/text_lines.h"

namespace etendue {
namespace {

constexpr std::string_view foam_blanks = " \t\r\n";
constexpr std::string_view foam_marks = "(){};";

std::string_view unquoted(std::string_view word) {
  return word.size() >= 2 && word.front() == '"' ? word.substr(1, word.size() - 2) : word;
}

template <class Value>
Value value_of(std::string_view bytes) {
  Value value;
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

/// Refuses a file that is there in compressed form only.
std::filesystem::path uncompressed(const std::filesystem::path& path) {
  std::filesystem::path compressed = path;
  compressed += ".gz";
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored) && std::filesystem::exists(compressed, ignored))
    throw InputError(Fault{compressed.string(), 0, "is compressed; unpack it with gunzip"});
  return path;
}

}  // namespace

FoamFile::FoamFile(const std::filesystem::path& path, const std::vector<std::string_view>& classes)
    : file_(path.string()), text_(read_bytes(uncompressed(path))) {
  read_header(classes);
}

void FoamFile::read_header(const std::vector<std::string_view>& classes) {
  if (peek() != "FoamFile") fail("is no file of OpenFOAM (it does not begin with FoamFile)");
  token();
  expect("{");
  bool binary = false;
  while (peek() != "}") {
    const std::string_view key = token();
    if (key.empty()) fail("the file ends within its header (is it cut short?)");
    if (key == "class") class_name_ = token();
    if (key == "format") binary = token() == "binary";
    if (key == "arch") read_architecture(unquoted(token()));
    skip_entry();
  }
  token();
  binary_ = binary;
  if (std::ranges::count(classes, class_name_) == 0)
    fail("class " + shown_word(class_name_) + ": must be " + std::string(classes.front()));
}

/// "LSB;label=32;scalar=64"
void FoamFile::read_architecture(std::string_view text) {
  if (text.find("MSB") != std::string_view::npos)
    fail("arch: numbers are big-endian; write the mesh as ascii");
  if (text.find("label=64") != std::string_view::npos) label_size_ = 8;
  if (text.find("scalar=32") != std::string_view::npos) scalar_size_ = 4;
}

void FoamFile::skip_to_end_of_comment(std::string_view end) {
  const std::size_t found = text_.find(end, next_ + 2);
  const std::size_t stop = found == std::string::npos ? text_.size() : found + end.size();
  line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(next_),
                                       text_.begin() + static_cast<std::ptrdiff_t>(stop), '\n'));
  next_ = stop;
}

void FoamFile::skip_blanks() {
  while (next_ < text_.size()) {
    const std::string_view two = std::string_view(text_).substr(next_, 2);
    if (two == "//") {
      skip_to_end_of_comment("\n");
    } else if (two == "/*") {
      skip_to_end_of_comment("*/");
    } else if (foam_blanks.find(text_[next_]) != std::string_view::npos) {
      if (text_[next_++] == '\n') ++line_;
    } else {
      return;
    }
  }
}

std::string_view FoamFile::peek() {
  skip_blanks();
  const std::string_view rest = std::string_view(text_).substr(next_);
  if (rest.empty()) return rest;
  if (foam_marks.find(rest.front()) != std::string_view::npos) return rest.substr(0, 1);
  if (rest.front() == '"') {
    const std::size_t end = rest.find('"', 1);
    if (end == std::string_view::npos) fail("a string has no end (is the file cut short?)");
    return rest.substr(0, end + 1);
  }
  return rest.substr(0, std::min(rest.find_first_of(" \t\r\n(){};\""), rest.size()));
}

std::string_view FoamFile::token() {
  const std::string_view found = peek();
  next_ += found.size();
  return found;
}

void FoamFile::expect(std::string_view wanted) {
  const std::string_view found = token();
  if (found.empty()) fail("the file ends where " + std::string(wanted) + " should follow (is it cut short?)");
  if (found != wanted) fail(shown_word(found) + ": must be " + std::string(wanted));
}

void FoamFile::skip_entry() {
  int depth = 0;
  for (std::string_view found = token(); !found.empty(); found = token()) {
    if (found == ";" && depth == 0) return;
    if (found == "{" || found == "(") ++depth;
    if (found == "}" || found == ")") {
      if (--depth < 0) fail(std::string(found) + ": closes nothing");
      if (depth == 0 && found == "}") return;
    }
  }
  fail("the file ends within an entry (is it cut short?)");
}

std::int64_t FoamFile::integer(std::string_view what, std::int64_t least, std::int64_t most) {
  const std::string_view text = token();
  if (text.empty()) fail("the file ends where " + std::string(what) + " should follow (is it cut short?)");
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string shown = std::string(what) + " = " + shown_word(text);
  if (error == std::errc::invalid_argument || end != text.data() + text.size())
    fail(shown + ": is not an integer");
  if (error != std::errc() || value < least || value > most)
    fail(shown + ": is out of range; use " + std::to_string(least) + " to " + std::to_string(most));
  return value;
}

std::size_t FoamFile::count(std::string_view what, std::size_t least_bytes) {
  const auto most = static_cast<std::int64_t>((text_.size() - next_) / least_bytes);
  const std::int64_t value = integer(what, 0, std::numeric_limits<std::int32_t>::max());
  if (value > most)
    fail(std::string(what) + " = " + std::to_string(value) +
         ": is more than the file holds (is it cut short?)");
  return static_cast<std::size_t>(value);
}

double FoamFile::number(std::string_view what) {
  const std::string_view text = token();
  if (text.empty()) fail("the file ends where " + std::string(what) + " should follow (is it cut short?)");
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  // A number too small for a double becomes 0.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(text).c_str(), nullptr);
  if (error == std::errc::invalid_argument || end != text.data() + text.size() || !std::isfinite(value))
    fail(std::string(what) + " = " + shown_word(text) + ": is not a finite number");
  return value;
}

std::string_view FoamFile::raw(std::size_t size) {
  if (text_.size() - next_ < size) fail("the file ends within a binary list (is it cut short?)");
  next_ += size;
  return std::string_view(text_).substr(next_ - size, size);
}

std::int64_t FoamFile::binary_label() {
  const std::string_view bytes = raw(label_size_);
  return label_size_ == 8 ? value_of<std::int64_t>(bytes) : value_of<std::int32_t>(bytes);
}

double FoamFile::binary_scalar() {
  const std::string_view bytes = raw(scalar_size_);
  return scalar_size_ == 8 ? value_of<double>(bytes) : static_cast<double>(value_of<float>(bytes));
}

std::vector<int> FoamFile::labels(std::string_view what, std::int64_t least, std::int64_t most,
                                  std::size_t most_entries) {
  while (!peek().empty() && std::isdigit(static_cast<unsigned char>(peek().front())) == 0 && peek() != "(" &&
         peek() != "-")
    token();
  const std::string length = "length of the list of " + std::string(what);
  const auto entries = static_cast<std::size_t>(integer(length, 0, static_cast<std::int64_t>(most_entries)));
  if (peek() == "{") {  // one value for all
    token();
    const auto value = static_cast<int>(integer(what, least, most));
    expect("}");
    return std::vector<int>(entries, value);
  }
  std::vector<int> values;
  if (entries == 0 && peek() != "(") return values;
  expect("(");
  for (std::size_t i = 0; i < entries; ++i) {
    const std::int64_t value = binary_ ? binary_label() : integer(what, least, most);
    if (value < least || value > most)
      fail(std::string(what) + " " + std::to_string(i) + " = " + std::to_string(value) +
           ": is out of range; use " + std::to_string(least) + " to " + std::to_string(most));
    values.push_back(static_cast<int>(value));
  }
  expect(")");
  return values;
}

std::vector<Vec3> FoamFile::vectors(std::string_view what) {
  const std::size_t entries = count("number of " + std::string(what) + "s", binary_ ? 3 * scalar_size_ : 8);
  std::vector<Vec3> values;
  values.reserve(entries);
  expect("(");
  for (std::size_t i = 0; i < entries; ++i) {
    Vec3 value;
    if (!binary_) expect("(");
    for (double& x : value)
      x = binary_ ? binary_scalar() : number(std::string(what) + " " + std::to_string(i));
    if (!binary_) expect(")");
    if (!value.allFinite()) fail(std::string(what) + " " + std::to_string(i) + ": is not finite");
    values.push_back(value);
  }
  expect(")");
  return values;
}

void FoamFile::fail(const std::string& problem) const { throw InputError(Fault{file_, line_, problem}); }

}  // namespace etendue
