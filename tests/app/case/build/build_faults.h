// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/case/build/build.h"
#include "base/errors.h"

namespace etendue::test {

/// What is wrong with a case beyond its keys: a line each, with the number of the line.
inline std::string build_faults(const Case& input) {
  try {
    build_problem(input, build_mesh(input));
    return "";
  } catch (const InputError& error) {
    std::string faults;
    for (const Fault& fault : error.faults()) faults += std::to_string(fault.line) + ": " + fault.text + "\n";
    return faults;
  }
}

}  // namespace etendue::test
