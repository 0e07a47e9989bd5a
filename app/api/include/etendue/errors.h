// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <etendue/export.h>

namespace etendue {
ETENDUE_INTERFACE_BEGIN
/// One thing that is wrong with a case, a mesh or an argument.
struct Fault {
  std::string file;  ///< empty where no file is concerned
  int line = 0;      ///< from 1; 0 where no line is concerned
  std::string text;  ///< `key = value: problem (why); what is accepted`
};

/// The case, the mesh or an argument is wrong. `what()` has one line for each fault.
class ETENDUE_EXPORT InputError : public std::runtime_error {
 public:
  InputError(const std::string& lines, std::vector<Fault> faults);
  ~InputError() override;
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// A file could not be read or written.
class ETENDUE_EXPORT FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  ~FileError() override;
};

/// A solution is not finite: the problem has no steady state that the numbers can hold.
class ETENDUE_EXPORT NotFiniteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  ~NotFiniteError() override;
};

/// SolveSettings::stop ended a solve or a picture: there is no result.
class ETENDUE_EXPORT Stopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  ~Stopped() override;
};

ETENDUE_INTERFACE_END
}  // namespace etendue
