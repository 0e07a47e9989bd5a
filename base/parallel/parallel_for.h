// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>

namespace etendue {

/// Calls body(i, workspace) for i = 0 … count - 1 on several threads, `chunk` at a time; each thread has a
/// workspace of its own from make(). The body returns whether to continue: after false no more is begun, and
/// the rest is left out. What it throws ends the loop too, and the first of it is thrown here. Whether all
/// was done comes back. Bodies that write to places of their own leave the same bits for any number of
/// threads.
template <class Make, class Body>
bool parallel_for(std::size_t count, int threads, int chunk, const Make& make, const Body& body) {
  std::atomic<bool> stopped = false;
  std::exception_ptr failure;
  std::mutex failing;
  const auto fail = [&] {
    const std::lock_guard<std::mutex> lock(failing);
    if (!failure) failure = std::current_exception();
    stopped = true;
  };
#pragma omp parallel num_threads(threads)
  {
    std::optional<decltype(make())> workspace;
#pragma omp for schedule(dynamic, chunk)
    for (std::size_t i = 0; i < count; ++i) {
      if (stopped) continue;
      try {
        if (!workspace) workspace.emplace(make());
        if (!body(i, *workspace)) stopped = true;
      } catch (...) {
        fail();
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
  return !stopped;
}

/// The same of body(i) without a workspace.
template <class Body>
bool parallel_for(std::size_t count, int threads, int chunk, const Body& body) {
  struct Nothing {};
  return parallel_for(
      count, threads, chunk, [] { return Nothing{}; }, [&](std::size_t i, Nothing&) { return body(i); });
}

}  // namespace etendue
