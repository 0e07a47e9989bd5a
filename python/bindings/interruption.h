// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include "python/bindings/bindings.h"

namespace etendue::python {

/// Ctrl-C while the interpreter's lock is free. Threads ask often; the one that called looks at the
/// interpreter's signals twenty times a second.
class PythonInterruption {
 public:
  PythonInterruption() : caller_(std::this_thread::get_id()) {}

  /// Whether a signal's handler has raised an exception.
  bool noted() {
    if (std::this_thread::get_id() == caller_ && is_due()) {
      const py::gil_scoped_acquire locked;
      if (PyErr_CheckSignals() != 0) raise(py::error_already_set());
    }
    return noted_;
  }

  /// Notes an exception of Python's, with the lock held.
  void raise(const py::error_already_set& error) {
    error_ = error;
    noted_ = true;
  }

  /// Throws the exception that was noted, with the lock held.
  void rethrow() const {
    if (error_) throw py::error_already_set(*error_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool is_due() {
    const Clock::time_point now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(50)) return false;
    last_ = now;
    return true;
  }

  std::thread::id caller_;
  Clock::time_point last_ = Clock::now();
  std::atomic<bool> noted_ = false;
  std::optional<py::error_already_set> error_;
};

}  // namespace etendue::python
