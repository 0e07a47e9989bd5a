// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/interruption.h"

#include <unistd.h>

#include <csignal>
#include <limits>

#include "app/command/exit_code.h"

namespace etendue {
namespace {

// Written by a signal handler, which reaches nothing but globals of this type.
volatile std::sig_atomic_t signals_noted = 0;
volatile std::sig_atomic_t signals_allowed = 0;  ///< so many are noted before one ends the program

struct sigaction interrupt_before;
struct sigaction terminate_before;
struct sigaction pipe_before;

constexpr std::sig_atomic_t any_number = std::numeric_limits<std::sig_atomic_t>::max();

void on_signal(int) {
  if (signals_noted >= signals_allowed) {
    constexpr char message[] = "\ninterrupted: nothing was written\n";
    [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, message, sizeof message - 1);
    _exit(static_cast<int>(ExitCode::interrupted));
  }
  signals_noted = signals_noted + 1;
}

}  // namespace

Interruption::Interruption() {
  signals_noted = 0;
  signals_allowed = 0;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;  // writing must not fail because of a signal
  sigaction(SIGINT, &action, &interrupt_before);
  sigaction(SIGTERM, &action, &terminate_before);
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, &pipe_before);
}

Interruption::~Interruption() {
  sigaction(SIGINT, &interrupt_before, nullptr);
  sigaction(SIGTERM, &terminate_before, nullptr);
  sigaction(SIGPIPE, &pipe_before, nullptr);
}

void Interruption::note_the_first() { signals_allowed = 1; }

void Interruption::note_all() { signals_allowed = any_number; }

bool Interruption::noted() const { return signals_noted > 0; }

}  // namespace etendue
