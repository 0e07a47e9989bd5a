// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/write/result/run_result.h"

namespace etendue {

/// quantity,name,band,frequency,amplitude,phase,modulation,unit: light that changes as cos(2 pi f t). The
/// phase is by how much it comes later [degree], from -180 to 180; the modulation is the amplitude over the
/// mean, that of frequency 0.
std::string frequency_csv(const RunResult& result);

/// quantity,name,band,t,value,error,unit: histories, and what the inversion may be off by.
std::string times_csv(const RunResult& result);

/// quantity,name,band,t,value,error,unit: what is read at the ends of steps, and by how much it would differ
/// with a step of first order; of temperatures that is not known.
std::string steps_csv(const RunResult& result);

/// quantity,name,band,mean,deviation,unit: of the time of flight.
std::string flight_times_csv(const RunResult& result);

}  // namespace etendue
