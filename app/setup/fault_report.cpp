// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/setup/fault_report.h"

#include <new>
#include <system_error>

#include "app/setup/memory.h"
#include "base/errors.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue {
namespace {

template <class Kind>
bool is(const std::exception& fault) {
  return dynamic_cast<const Kind*>(&fault) != nullptr;
}

/// Faults that are listed at most: the first ones often bring the others about.
constexpr std::size_t most_listed = 20;

std::string list_of(const InputError& error) {
  const std::vector<Fault>& faults = error.faults();
  if (faults.size() <= most_listed) return error.what();
  std::string text;
  for (std::size_t i = 0; i < most_listed; ++i) text += to_string(faults[i]) + "\n";
  return text + "and " + std::to_string(faults.size() - most_listed) + " more, which are not listed";
}

}  // namespace

FaultReport report_of(const std::exception& fault) {
  const std::string what = fault.what();
  if (const auto* error = dynamic_cast<const InputError*>(&fault))
    return {ExitCode::input_error, list_of(*error)};
  if (is<FileError>(fault) || is<std::system_error>(fault)) return {ExitCode::file_error, what};
  if (is<NotFiniteError>(fault)) return {ExitCode::not_converged, what + "; nothing is written"};
  if (is<std::bad_alloc>(fault)) return {ExitCode::input_error, out_of_memory_message()};
  return {ExitCode::internal_error, "internal error: " + what};
}

}  // namespace etendue
