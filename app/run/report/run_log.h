// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

#include "app/write/result/run_record.h"

namespace etendue {

/// Name of the log among the results.
inline constexpr const char* run_log_name = "log.txt";

/// Lines that a run has printed, for its log.txt.
class RunLog {
 public:
  /// Begins with the version, the date, the machine and the command.
  explicit RunLog(const RunRecord& record);

  void add(std::string_view text) { text_ += text; }
  /// The directory of the results, once it is known.
  void belongs_in(const std::filesystem::path& directory) { directory_ = directory; }

  /// Writes log.txt, and names it in summary.json. Results of another run keep their log. Throws FileError.
  void save() const;
  /// Writes log-failed.txt with `fault` as the last line: the results of an earlier run keep their log. A
  /// directory that is not known, or cannot be written, gets none.
  void save_failed(std::string_view fault) const;

 private:
  std::string text_;
  std::optional<std::filesystem::path> directory_ = {};
};

/// Adds text to the log of a run of this process that is over. Throws FileError.
void append_to_log(const std::filesystem::path& directory, std::string_view text);

/// Prints to another stream, and copies whole lines into the log. A drawing, from a carriage return to the
/// sequence that clears the rest of its line, is printed only.
class LoggedStream : public std::ostream {
 public:
  /// Both must outlive the stream.
  LoggedStream(std::ostream& shown, RunLog& log) : std::ostream(nullptr), buffer_(shown, log) {
    rdbuf(&buffer_);
  }

 private:
  class Buffer : public std::streambuf {
   public:
    Buffer(std::ostream& shown, RunLog& log) : shown_(shown), log_(log) {}
    ~Buffer() override;
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

   protected:
    int_type overflow(int_type character) override;
    std::streamsize xsputn(const char* text, std::streamsize length) override;
    int sync() override;

   private:
    void keep(char character);
    void end_line();

    std::ostream& shown_;
    RunLog& log_;
    std::string line_;
    bool has_drawing_ = false;  ///< the line so far holds a drawing
  };

  Buffer buffer_;
};

}  // namespace etendue
