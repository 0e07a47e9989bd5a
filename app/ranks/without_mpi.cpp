// SPDX-License-Identifier: AGPL-3.0-or-later
#include <iostream>

#include "app/ranks/rank_session.h"

namespace etendue {

struct RankSession::Joined {};

RankSession::RankSession() = default;
RankSession::~RankSession() = default;

ExitCode RankSession::run(const Program& program) {
  if (!is_one_of_several()) return program(nullptr, std::cout, std::cerr);
  std::cerr << "several processes were started together, and this build of etendue has no MPI: start one, or "
               "build with MPI\n";
  return ExitCode::input_error;
}

}  // namespace etendue
