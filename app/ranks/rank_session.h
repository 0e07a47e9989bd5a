// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <ostream>

#include "app/request/exit_code.h"
#include "base/parallel/rank_group.h"

namespace etendue {

/// Processes of this program that a launcher of MPI (mpirun, srun) has started together. One alone knows
/// nothing of MPI.
class RankSession {
 public:
  /// Does what each process has to; null: this one is alone.
  using Program = std::function<ExitCode(RankGroup* ranks, std::ostream& out, std::ostream& err)>;

  /// Finds the others. Where there are some and this build has no MPI, run() says so.
  RankSession();
  ~RankSession();
  RankSession(const RankSession&) = delete;
  RankSession& operator=(const RankSession&) = delete;

  /// Runs the program. Only the first process is heard; another one that fails alone is too, and then all of
  /// them end with its code. Returns once all processes have ended theirs.
  ExitCode run(const Program& program);

 private:
  struct Joined;

  std::unique_ptr<Joined> joined_;  ///< null where this process is alone
};

/// Whether the environment is that of a process that a launcher has started beside others.
bool is_one_of_several();

}  // namespace etendue
