// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/errors.h>

#include <utility>

namespace etendue::v0 {

InputError::InputError(const std::string& lines, std::vector<Fault> faults)
    : std::runtime_error(lines), faults_(std::move(faults)) {}

// Here, so that all programs know these types by one table of virtual functions.
InputError::~InputError() = default;
FileError::~FileError() = default;
NotFiniteError::~NotFiniteError() = default;
Stopped::~Stopped() = default;

}  // namespace etendue::v0
