// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/setup/exact_setup.h"

namespace etendue {

ExactSetup::ExactSetup(const Case& given, const Problem& problem, const DirectionSet& directions) try
    : radiance(given.exact->radiance), input(problem, directions, radiance) {
} catch (const InputError& error) {
  throw InputError(fault_at(given.exact->origin, "", error.faults().front().text));
}

}  // namespace etendue
