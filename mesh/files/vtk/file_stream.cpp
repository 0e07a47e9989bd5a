// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/file_stream.h"

#include <cerrno>
#include <system_error>

namespace etendue {

FileBuffer::FileBuffer(const std::filesystem::path& path) : file_(std::fopen(path.c_str(), "wb")) {
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  if (file_ == nullptr)
    note_failure();
  else
    std::setvbuf(file_, nullptr, _IONBF, 0);
}

FileBuffer::~FileBuffer() { close(); }

std::string FileBuffer::close() {
  flush();
  if (file_ != nullptr && std::fclose(file_) != 0) note_failure();
  file_ = nullptr;
  return error_ == 0 ? "" : std::generic_category().message(error_);
}

void FileBuffer::note_failure() {
  if (error_ == 0) error_ = errno != 0 ? errno : EIO;
}

void FileBuffer::flush() {
  const auto size = static_cast<std::size_t>(pptr() - pbase());
  if (file_ != nullptr && error_ == 0 && std::fwrite(pbase(), 1, size, file_) != size) note_failure();
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

FileBuffer::int_type FileBuffer::overflow(int_type byte) {
  flush();
  if (!traits_type::eq_int_type(byte, traits_type::eof())) sputc(traits_type::to_char_type(byte));
  return traits_type::not_eof(byte);
}

FileBuffer::pos_type FileBuffer::seekoff(off_type offset, std::ios_base::seekdir from,
                                         std::ios_base::openmode) {
  if (error_ != 0) return 0;
  // The position alone is asked for often, and nothing has to be written for it.
  if (from == std::ios_base::cur && offset == 0) return ftello(file_) + (pptr() - pbase());
  flush();
  const int origin = from == std::ios_base::beg ? SEEK_SET : from == std::ios_base::cur ? SEEK_CUR : SEEK_END;
  if (error_ == 0 && fseeko(file_, offset, origin) != 0) note_failure();
  return error_ == 0 ? pos_type(ftello(file_)) : pos_type(0);
}

FileBuffer::pos_type FileBuffer::seekpos(pos_type position, std::ios_base::openmode which) {
  return seekoff(position, std::ios_base::beg, which);
}

int FileBuffer::sync() {
  flush();
  return 0;
}

}  // namespace etendue
