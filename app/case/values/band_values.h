// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "app/case/case.h"
#include "app/case/keys/section.h"
#include "solver/problem/bands.h"

namespace etendue {

/// The bands of a case. No names where they are faulty: then nothing can be said about a list's length.
Bands read_bands(Section bands, const std::filesystem::path& case_folder,
                 const std::optional<BandValues>& molar_ratio);

/// What formulas may be in.
enum class FormulaOf { place, place_and_direction, place_and_temperature };

/// A value per band that is there and sound: a list is as long as the bands, formulas can be evaluated.
std::optional<BandValues> read_band_values(Section& section, std::string_view name, const Bands& bands,
                                           FormulaOf formula = FormulaOf::place);

/// The same with the declared default.
BandValues read_band_values_or_default(Section& section, std::string_view name, const Bands& bands,
                                       FormulaOf formula = FormulaOf::place);

/// The value of a key that is the same in all bands; empty where it is absent or faulty.
std::optional<BandValues> read_place_value(Section& section, std::string_view name,
                                           FormulaOf formula = FormulaOf::place);

/// Whether some formula uses the direction of travel.
bool depend_on_direction(const std::optional<BandValues>& values);

/// Reports a list of a wrong length; whether it is right.
bool check_band_count(Section& section, std::string_view name, std::size_t count, const Bands& bands);

/// Value of a band.
const Value& value_of(const BandValues& values, int band);

}  // namespace etendue
