// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <etendue/errors.h>

#include "base/errors.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue::v0 {

/// Throws the exception of the interface for one of the program.
[[noreturn]] inline void rethrow(const etendue::InputError& error) {
  std::vector<Fault> faults;
  for (const etendue::Fault& fault : error.faults()) faults.push_back({fault.file, fault.line, fault.text});
  throw InputError(error.what(), std::move(faults));
}

/// Does what users asked; they see exceptions of the interface alone.
template <class Act>
auto translated(const Act& act) {
  try {
    return act();
  } catch (const etendue::InputError& error) {
    rethrow(error);
  } catch (const etendue::FileError& error) {
    throw FileError(error.what());
  } catch (const etendue::NotFiniteError& error) {
    throw NotFiniteError(error.what());
  }
}

}  // namespace etendue::v0
