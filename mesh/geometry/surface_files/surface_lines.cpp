// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/surface_lines.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "base/errors.h"
#include "base/text/text_lines.h"

namespace etendue {
namespace {

constexpr std::string_view kSpaces = " \t\r";

template <class Number>
bool parse(std::string_view word, Number& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  return fault == std::errc() && end == word.data() + word.size();
}

}  // namespace

std::string file_content(const std::filesystem::path& path) {
  std::error_code fault;
  if (std::filesystem::is_directory(path, fault)) throw FileError(path.string(), "is a directory");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path.string(), "cannot be opened");
  std::ostringstream content;
  content << file.rdbuf();
  if (file.bad()) throw FileError(path.string(), "cannot be read");
  return std::move(content).str();
}

SurfaceLines::SurfaceLines(const std::filesystem::path& path)
    : file_(path.string()), text_(file_content(path)) {}

bool SurfaceLines::next() {
  while (position_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    std::string_view line(text_.data() + position_, end - position_);
    position_ = end + 1;
    ++line_;
    line = line.substr(0, line.find('#'));
    words_.clear();
    for (std::size_t start = line.find_first_not_of(kSpaces); start != std::string_view::npos;) {
      const std::size_t stop = std::min(line.find_first_of(kSpaces, start), line.size());
      words_.push_back(line.substr(start, stop - start));
      start = line.find_first_not_of(kSpaces, stop);
    }
    if (!words_.empty()) return true;
  }
  return false;
}

void SurfaceLines::require(std::string_view expected) {
  if (!next()) fail(fmt::format("the file ends early; expected {}", expected));
}

std::string_view SurfaceLines::rest() const {
  if (words_.size() < 2) return {};
  return {words_[1].data(),
          static_cast<std::size_t>(words_.back().data() + words_.back().size() - words_[1].data())};
}

std::string_view SurfaceLines::word(std::size_t index, std::string_view what) const {
  if (index >= words_.size()) fail(fmt::format("{} is missing", what));
  return words_[index];
}

int SurfaceLines::integer(std::size_t index, std::string_view what) const {
  int value = 0;
  if (!parse(word(index, what), value))
    fail(fmt::format("{} = {}: must be a whole number", what, shown_word(words_[index])));
  return value;
}

double SurfaceLines::number(std::size_t index, std::string_view what) const {
  double value = 0;
  if (!parse(word(index, what), value) || !std::isfinite(value))
    fail(fmt::format("{} = {}: must be a finite number", what, shown_word(words_[index])));
  return value;
}

void SurfaceLines::fail(const std::string& problem) const { throw InputError(Fault{file_, line_, problem}); }

}  // namespace etendue
