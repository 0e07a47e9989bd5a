// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/problem/problem.h"

namespace etendue {

enum class EmitterKind { region, wall, light };

/// One of the things that emit in a problem, alone in the same problem otherwise.
struct Emitter {
  EmitterKind kind;
  std::string name;
  Problem problem;
};

/// Each region, wall and light that emits something. The parts of one sky or fibre are one light.
std::vector<Emitter> emitters_of(const Problem& problem);

}  // namespace etendue
