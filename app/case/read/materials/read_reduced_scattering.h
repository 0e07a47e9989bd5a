// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

/// Scattering coefficient mu_s = mu_s' / (1 - g) [1/length] from the key `reduced_scattering`, for which
/// tissue optics has mu_s' (S. L. Jacques, Phys. Med. Biol. 58 (2013) R37, section 2.3); g is the mean cosine
/// of the phase function of each band. Nothing where the key is absent or faulty. Faults: another key that
/// gives scattering, no phase function, one that only scatters straight ahead.
std::optional<BandValues> read_reduced_scattering(Section& section, const Bands& bands, AngularSpace space,
                                                  const std::vector<PhaseFunction>& phases);

}  // namespace etendue
