// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/progress/interruption.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <limits>
#include <utility>

#include "app/request/exit_code.h"

namespace etendue {
namespace {

// A signal handler reaches nothing but globals of such types.
volatile std::sig_atomic_t signals_noted = 0;
volatile std::sig_atomic_t signals_allowed = 0;  ///< so many are noted before one ends the program
std::atomic<std::int64_t> first_noted = 0;       ///< when a signal was noted first
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal handler must not wait");
constexpr std::int64_t nanoseconds_of_grace = 500'000'000;
constexpr char nothing_written[] = "\ninterrupted: nothing was written\n";
const char* words_before_results = nothing_written;
const char* volatile last_words = nothing_written;

constexpr std::sig_atomic_t any_number = std::numeric_limits<std::sig_atomic_t>::max();

// May be called by a signal handler (signal-safety(7)).
std::int64_t nanoseconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

void on_signal(int) {
  if (signals_noted >= signals_allowed) {
    [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, last_words, std::strlen(last_words));
    _exit(static_cast<int>(ExitCode::interrupted));
  }
  if (signals_noted == 0) first_noted = nanoseconds_now();
  signals_noted = signals_noted + 1;
}

}  // namespace

struct Interruption::Before {
  struct sigaction on_interrupt, on_terminate, on_pipe;
  std::sig_atomic_t noted = signals_noted, allowed = signals_allowed;
  const char* words = last_words;
};

Interruption::Interruption(const char* words) : Interruption() {
  last_words = words;
  may_note_ = false;
}

Interruption::Interruption() {
  auto before = std::make_unique<Before>();
  last_words = words_before_results;
  signals_noted = 0;
  signals_allowed = 0;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;  // writing must not fail because of a signal
  sigaction(SIGINT, &action, &before->on_interrupt);
  sigaction(SIGTERM, &action, &before->on_terminate);
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, &before->on_pipe);
  before_ = std::move(before);
}

Interruption::Interruption(std::function<bool()> asked) : may_note_(false), asked_(std::move(asked)) {}

Interruption::~Interruption() {
  if (!before_) return;
  last_words = before_->words;
  signals_noted = before_->noted;
  signals_allowed = before_->allowed;
  sigaction(SIGINT, &before_->on_interrupt, nullptr);
  sigaction(SIGTERM, &before_->on_terminate, nullptr);
  sigaction(SIGPIPE, &before_->on_pipe, nullptr);
}

void Interruption::note_the_first() {
  if (may_note_) signals_allowed = 1;
}

void Interruption::note_all() {
  if (may_note_) signals_allowed = any_number;
}

bool Interruption::noted() const { return asked_ ? asked_() : signals_noted > 0; }

bool Interruption::is_overdue() const {
  if (asked_) return asked_();
  return signals_noted > 0 && nanoseconds_now() - first_noted > nanoseconds_of_grace;
}

EarlierResults::EarlierResults(std::string words) : words_(std::move(words)) {
  words_before_results = words_.c_str();
}

EarlierResults::~EarlierResults() { words_before_results = nothing_written; }

}  // namespace etendue
