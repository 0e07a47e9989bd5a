// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace etendue::test {

/// Of sensors.csv the numbers of each row, by "sensor band quantity unit": uncollided, collided, value.
std::map<std::string, std::vector<double>> rows_of(const std::string& table);

}  // namespace etendue::test
