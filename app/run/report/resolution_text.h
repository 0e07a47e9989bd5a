// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "solver/transport/solve/resolution.h"

namespace etendue {

/// Lines for the terminal before a run: the optical thickness of cells, that at lights, how many are lumped,
/// and a caution with a remedy where cells at lights or directions are too coarse. Empty in a vacuum. Photons
/// are advised where the caller says so.
std::string resolution_text(const Resolution& resolution, bool by_photons_too);
/// Whether that text has a caution: results are off by percents.
bool is_coarse(const Resolution& resolution);

}  // namespace etendue
