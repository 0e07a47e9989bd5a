// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdio>
#include <filesystem>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

namespace etendue {

/// Buffer of a file that accepts all bytes, also after a write has failed, and remembers the first failure.
/// VTK frees memory that it does not own where an inline write fails, so it must not meet a failure.
class FileBuffer : public std::streambuf {
 public:
  explicit FileBuffer(const std::filesystem::path& path);
  ~FileBuffer() override;
  FileBuffer(const FileBuffer&) = delete;
  FileBuffer& operator=(const FileBuffer&) = delete;

  /// Closes the file. Returns the reason of the first failure since it was opened; empty: none.
  std::string close();

 protected:
  int_type overflow(int_type byte) override;
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode which) override;
  pos_type seekpos(pos_type position, std::ios_base::openmode which) override;
  int sync() override;

 private:
  /// Empties the put area into the file.
  void flush();
  void note_failure();

  // VTK writes base64 text four characters at a time: the put area takes them without a call.
  static constexpr std::size_t kBufferSize = 1 << 16;
  std::vector<char> buffer_ = std::vector<char>(kBufferSize);
  std::FILE* file_;
  int error_ = 0;  ///< errno of the first failure; 0: none
};

}  // namespace etendue
