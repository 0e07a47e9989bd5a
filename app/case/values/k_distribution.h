// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "solver/problem/bands.h"

namespace etendue {

/// The points of a k-distribution as gray gases, from a CSV file with lines of temperature [K], absorption
/// coefficient by the partial pressure [1/(m atm)] and weight, the fraction of a blackbody's power at that
/// temperature: for each temperature as many lines as there are points, in the same order (the full-spectrum
/// k-distribution of Modest and Zhang, J. Heat Transfer 124 (2002) 30). A point absorbs as at the temperature
/// of the gas, and has its weight at the temperature of what emits. Throws FileError where it cannot be read,
/// InputError where it is not such a file.
GrayGases k_distribution(const std::filesystem::path& path);

}  // namespace etendue
