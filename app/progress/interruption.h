// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace etendue {

/// Last words of a run that is repeated, whose results are there.
inline constexpr const char* last_words_of_repetition =
    "\ninterrupted: the results are whole, but for the estimate of their errors\n";

/// What the program does on SIGINT and SIGTERM while this lives. At first it ends at once with exit code 130:
/// nothing is written yet. A closed pipe behind standard output does not end it: the results are in files.
/// One may live within the life of another, and while it does it decides alone.
class Interruption {
 public:
  Interruption();
  /// Of a run that leaves nothing itself: any signal ends the program at once with these last words.
  explicit Interruption(const char* last_words);
  /// For a run within another program, which decides itself when the run ends: signals stay as they are, and
  /// several of these may live at once.
  explicit Interruption(std::function<bool()> asked);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// From now on a first signal is only noted and a second ends the program at once.
  void note_the_first();
  /// From now on signals are only noted: files are being written, and they become whole.
  void note_all();
  /// Whether a signal was noted.
  bool noted() const;
  /// Returns whether the first was noted before the last half second: what is short has ended since, so that
  /// the run leaves all results; what is long must end.
  bool is_overdue() const;

 private:
  struct Before;

  bool may_note_ = true;
  std::unique_ptr<const Before> before_;  ///< what happened on signals before; null: signals stay as they are
  std::function<bool()> asked_;           ///< in place of signals
};

/// While this lives, a run that is ended before it wrote anything ends with these words in place of "nothing
/// was written": of what runs before it left. Not to be made or destroyed while an Interruption lives.
class EarlierResults {
 public:
  explicit EarlierResults(std::string words);
  ~EarlierResults();
  EarlierResults(const EarlierResults&) = delete;
  EarlierResults& operator=(const EarlierResults&) = delete;

 private:
  std::string words_;
};

}  // namespace etendue
