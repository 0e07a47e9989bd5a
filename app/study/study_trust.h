// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/study/study.h"

namespace etendue {

/// What an estimate of an error rests on.
enum class TrustBasis { exact, limit, change };
/// "exact", "limit" or "change".
const char* name_of(TrustBasis basis);

/// How far a value of the finest level is to be trusted.
struct StudyTrust {
  const StudyValue* value = nullptr;
  double error = 0;  ///< estimated, in the unit of the value
  TrustBasis basis = TrustBasis::change;
};

/// Errors of the finest level, by what was refined alone: against the exact value; else 1.25 times the
/// distance from the limit of the last three levels (Roache 1994); else the change from the next coarser
/// level, of mesh and directions added in squares where both are refined. None of norms and balances, nor
/// where there is but one level.
std::vector<StudyTrust> study_trust(const std::vector<StudyRow>& rows, const std::vector<LevelResult>& levels,
                                    Refinement refinement);

/// For people: the largest first, and in words what they leave out. `asked` levels were to be run.
std::string trust_text(const std::vector<StudyTrust>& trust, const std::vector<LevelResult>& levels,
                       Refinement refinement, int asked);

}  // namespace etendue
