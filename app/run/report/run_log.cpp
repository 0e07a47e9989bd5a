// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/run_log.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "app/write/json/summary.h"
#include "app/write/result/commit.h"
#include "app/write/result/output_folder.h"
#include "app/write/result/program_version.h"
#include "base/errors.h"

namespace etendue {
namespace {

constexpr const char* failed_log_name = "log-failed.txt";
/// The sequence that ends a drawing: it clears the rest of the line.
constexpr std::string_view clear_line = "\x1b[K";

}  // namespace

RunLog::RunLog(const RunRecord& record)
    : text_(fmt::format("etendue {} (commit {}), {}, on {}\n", program_version(), program_commit(),
                        iso_date(record.begun), host_name())) {
  if (!record.command_line.empty()) text_ += "command: " + record.command_line + "\n";
}

void RunLog::save() const {
  if (!directory_) return;
  OutputFolder folder(*directory_);
  folder.lock();
  if (holds_other_run(*directory_)) return;
  folder.add_text(run_log_name, text_);
  const std::string summary = summary_with_files(*directory_, {run_log_name}, {});
  if (!summary.empty()) folder.add_text("summary.json", summary);
  folder.publish({failed_log_name});
}

void RunLog::save_failed(std::string_view fault) const {
  if (!directory_) return;
  try {
    OutputFolder folder(*directory_);
    folder.add_text(failed_log_name, fmt::format("{}{}\n", text_, fault));
    folder.publish({});
  } catch (const FileError&) {
    // The fault itself is what the user must hear of, and often the disk that is full.
  }
}

void append_to_log(const std::filesystem::path& directory, std::string_view text) {
  OutputFolder folder(directory);
  folder.lock();
  if (holds_other_run(directory)) return;
  std::ifstream file(directory / run_log_name, std::ios::binary);
  if (!file) return;
  std::string log{std::istreambuf_iterator<char>(file), {}};
  log += text;
  folder.add_text(run_log_name, log);
  folder.publish({});
}

LoggedStream::Buffer::~Buffer() {
  if (!line_.empty()) end_line();
}

LoggedStream::Buffer::int_type LoggedStream::Buffer::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof())) return traits_type::not_eof(character);
  const char text = traits_type::to_char_type(character);
  xsputn(&text, 1);
  return character;
}

std::streamsize LoggedStream::Buffer::xsputn(const char* text, std::streamsize length) {
  for (const char character : std::string_view(text, static_cast<std::size_t>(length))) keep(character);
  shown_.write(text, length);  // which notes a fault of its own; the log continues
  return length;
}

int LoggedStream::Buffer::sync() {
  shown_.flush();
  return 0;
}

void LoggedStream::Buffer::keep(char character) {
  if (character == '\n') return end_line();
  line_ += character;
  if (!line_.ends_with(clear_line)) return;
  const auto drawing = line_.rfind('\r');
  line_.erase(drawing == std::string::npos ? 0 : drawing);
  has_drawing_ = true;
}

void LoggedStream::Buffer::end_line() {
  if (!line_.empty() || !has_drawing_) log_.add(line_ + "\n");
  line_.clear();
  has_drawing_ = false;
}

}  // namespace etendue
