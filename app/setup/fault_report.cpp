// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/setup/fault_report.h"

#include <new>

#include "app/setup/memory.h"
#include "base/errors.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue {
namespace {

template <class Kind>
bool is(const std::exception& fault) {
  return dynamic_cast<const Kind*>(&fault) != nullptr;
}

}  // namespace

FaultReport report_of(const std::exception& fault) {
  const std::string what = fault.what();
  if (is<InputError>(fault)) return {ExitCode::input_error, what};
  if (is<FileError>(fault)) return {ExitCode::file_error, what};
  if (is<NotFiniteError>(fault)) return {ExitCode::not_converged, what + "; nothing is written"};
  if (is<std::bad_alloc>(fault)) return {ExitCode::input_error, out_of_memory_message()};
  return {ExitCode::internal_error, "internal error: " + what};
}

}  // namespace etendue
