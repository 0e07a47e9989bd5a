// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/write/result/run_result.h"

namespace etendue {

// The text of the tables that a run writes. Numbers have the fewest digits that give them back exactly.

std::string probes_csv(const RunResult& result);   ///< probe,index,x,y,z,band,fluence,flux_…,irradiance
std::string walls_csv(const RunResult& result);    ///< wall,band,area,irradiance_mean,incoming,outgoing,net
std::string regions_csv(const RunResult& result);  ///< region,band,volume,fluence_mean,absorbed,emitted
std::string history_csv(const RunResult& result);  ///< sweep,band,residual

/// kind,name,extent,emitted,absorbed,net,density: heat of walls and regions, all bands together.
std::string heat_csv(const RunResult& result);

/// pass,band,exitant,incident,deposit: powers of the passes of radiosity.
std::string passes_csv(const RunResult& result);

/// from,to,factor: form factors of whole walls.
std::string form_factors_csv(const RunResult& result);

/// What keeping values positive met, ordinate by ordinate.
std::string positivity_csv(const RunResult& result);

}  // namespace etendue
