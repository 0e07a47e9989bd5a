// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// What the program does on SIGINT and SIGTERM while this lives. At first it ends at once with exit code 130:
/// nothing is written yet. A closed pipe behind standard output does not end it: the results are in files.
/// One at a time in a process.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// From now on a first signal is only noted and a second ends the program at once.
  void note_the_first();
  /// From now on signals are only noted: files are being written, and they become whole.
  void note_all();
  /// Whether a signal was noted.
  bool noted() const;
};

}  // namespace etendue
